// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_MODEL_COVARIANCE_HPP
#define OPENCV_USACV20_MODEL_COVARIANCE_HPP

#include "opencv2/usac/problem.hpp"
#include "optimization/any_parameterization.hpp"

namespace cv {
namespace usacv20 {

/** @brief Covariance of the parameters of a polished model, and the noise of its inliers.

A polished model is an M-estimate: the sum of J^T w(e) e over the points within the support of the
polisher is 0, with errors e, weights w (Polisher::weight) and the derivatives J of the error with
respect to the parameters. The covariance of the model is A^-1 B A^-1 @cite huber1981robust, with

    A = c (sum p J^T J - N),    B = sum (p s + (1 - p) w^2 e^2) J^T J.

- The standard deviation sigma of the noise and the number of inliers come from a mixture of inliers
  and uniform wrong matches, which the EM algorithm fits to the errors up to twice the support.
- c and s are the expected derivative of w(e) e and the expected square of a component of w(e) e for
  this noise. They allow for the points that the support cuts off and for the weights: c = 1 and s =
  sigma^2 for least squares without a cut-off.
- p is the probability that a point is an inlier, from the likelihood of its deleted residual, that
  is, of its error under a fit without this point. The error itself is not used, because a wrong
  match of high leverage (the fraction of its own error that a point removes from a fit) has nearly
  no error: the model has adapted to it. The other inliers show how many inliers have such a
  leverage, and the points outside of the support show how many wrong matches have such a leverage.
  Wrong matches add no information to A, but they add to B the shift of the model that they cause.
- N is the information that the noise of the points alone contributes to sum p J^T J, if the error
  is the distance from a curve (F, E): sigma^2 sum p (dJ/dx)^T dJ/dx. If N is at least a quarter of
  sum p J^T J for some linear combination of the parameters, the covariance is not determined.
- As sigma is estimated from f degrees of freedom, s is multiplied by f / (f - 2): the errors of the
  parameters then have Student's distribution, and the result is the covariance of this
  distribution.

If there are more than #MOST points within the support, a random subset of #MOST is used. */
class ModelCovariance
{
public:
    //! Maximum numbers of points that are used: within the support, and outside of it.
    enum { MOST = 512, OTHERS = 128 };
    //! A prior is not used if Report::priorChance is smaller than this. A prior with the right
    //! covariance is rejected with this probability.
    static constexpr double LEAST_CHANCE = 0.001;

    //! @param context the points, residual and polisher with which the model was polished
    explicit ModelCovariance(const Context& context);

    //! Computes noise and covariance. @param model in the coordinates of the points
    void estimate(const Model& model);

    /** @brief Replaces the model with the mean of the model and a prior, weighted by the inverses
    of their covariances, and the covariance with that of the mean.
    @param prior in the coordinates of the points
    @param covariance covariance of the prior in the caller's coordinates, d x d, CV_64F
    @return Report::priorChance; if it is below #LEAST_CHANCE, nothing is changed */
    double weigh(const Model& prior, const Mat& covariance);

    //! Raises a cv::Exception unless the matrix is symmetric and positive definite.
    static void checkPrior(const Mat& covariance);

    //! The model passed to estimate(), or the mean computed by weigh(), in the coordinates of the
    //! points.
    const Model& model() const { return here; }
    //! Standard deviation of the noise in each component, in the coordinates of the points; 0:
    //! unknown.
    double sigma() const { return noise; }
    //! Covariance matrix of the model in the caller's coordinates, for the parameters of
    //! callerBasis(). All entries are NaN if the covariance is not determined.
    Mat ofCaller() const;

private:
    typedef AnyParameterization::Matrix Square;
    typedef AnyParameterization::Basis Basis;
    typedef AnyParameterization::Step Vector;
    typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Rows;
    //! The rows of J of one point; no heap memory is needed.
    typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor,
                          Residual::MAX_COMPONENTS, MAX_MODEL_SIZE>
        FewRows;

    bool findMembers(const Polisher& polisher, const Model& model);
    void estimateNoise();
    double chanceDensity() const;
    void linearize(int point, double* rows);
    bool takeRows();
    bool judge(Arena::Scope& scope);
    void likelihoods(const double* levers, double* others, int otherCount);
    int leversOfOthers(const Eigen::LLT<Square>& information, double* levers);
    bool noiseInformation(Square& N);
    bool combine(const Polisher& polisher);
    Eigen::MatrixXd change(const Model& from) const;
    bool stepTo(const Model& model, Vector& step) const;

    const Context& context;
    const Correspondences& points;
    const Residual& residual;
    const Ptr<Parameterization> rule;
    const int degrees, dimension;
    double support, noise, right;  //!< Polisher::support(); sigma(); expected number of inliers
                                   //!< among the first `looked` points
    bool known;                    //!< false: the covariance is not determined
    float* squared;                //!< squared errors of all points
    int* members;                  //!< indices of `count` points within the support
    double* shares;                //!< for each member, the probability that it is an inlier
    double* rowMemory;             //!< the rows of J of the members, scaled by `scale`
    //! Number of members; number of points that were examined, from the first point on; number of
    //! components of an error.
    int count, looked, components;
    Model here;     //!< model()
    Basis tangent;  //!< derivatives of the entries of `here` with respect to the parameters
    Vector scale;   //!< factors of the columns of J, such that J^T J has a unit diagonal
    Square information, own;  //!< sum p J^T J, of the scaled rows; covariance of the parameters
};

}  // namespace usacv20
}  // namespace cv

#endif
