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

A polished model is an M-estimate: the sum of w(e) e J^T over the points within the support of the
polisher is 0, with errors e, weights w (Polisher::weight) and the derivatives J of the error by the
parameters. Its covariance is A^-1 B A^-1 @cite huber1981robust, with

    A = c sum p J^T J - N,    B = sum (p s + (1 - p) w^2 e^2) J^T J.

- The noise sigma and the number of inliers: a mixture of inliers and uniform wrong matches, cut off
  at twice the support, is fitted to the errors by the EM algorithm.
- c and s are the expected derivative of w(e) e and the expected square of a component of w(e) e for
  this noise. They allow for the points that the support cuts off and for the weights: c = 1 and s =
  sigma^2 for plain least squares.
- p is the probability that the point is an inlier, from the likelihood of its deleted residual: a
  wrong match of high leverage (the part of its own error that a point removes from a fit) has
hardly an error, because the model has turned to it. That inliers have this leverage, too, is known
from the other inliers, and how many wrong matches have it from the points outside of the support.
Wrong matches add no information to A, but their own shift of the model to B.
- N is the information that noise of the points alone contributes to sum p J^T J, if the error is
the distance from a curve (F, E): sigma^2 sum p (dJ/dx)^T dJ/dx. If it is more than half of that,
noise is all that determines some parameter.
- As sigma is estimated from f degrees of freedom, s is multiplied by f / (f - 2): errors have the
  distribution of Student, and the covariance is that of the latter.

At most #MOST points within the support are used, of more a random part. */
class ModelCovariance
{
public:
    //! Most points within the support and outside of it that are used.
    enum { MOST = 512, OTHERS = 128 };

    //! @param context points, residual and polisher with which the model was polished
    explicit ModelCovariance(const Context& context);

    //! @param model in the coordinates of the points
    void estimate(const Model& model);

    //! Standard deviation of the noise in each component, in the coordinates of the points; 0:
    //! unknown.
    double sigma() const { return noise; }
    //! Covariance in the parameters of callerBasis() of the model in the caller's coordinates, NaN
    //! if it is not determined.
    Mat ofCaller() const;

private:
    typedef AnyParameterization::Matrix Square;
    typedef AnyParameterization::Basis Basis;
    typedef AnyParameterization::Step Vector;
    typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Rows;
    //! The rows of one point, without memory of the heap.
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
    bool change(const Model& center, const Basis& basis, Square& T) const;

    const Context& context;
    const Correspondences& points;
    const Residual& residual;
    const Ptr<Parameterization> rule;
    const int degrees, dimension;
    double support, noise, right;  //!< right: number of inliers among the first `looked` points
    bool known;
    float* squared;     //!< squared errors of all points
    int* members;       //!< points within the support, the first `count`
    double* shares;     //!< probability that each of them is an inlier
    double* rowMemory;  //!< their rows of J, scaled by `scale`
    int count, looked, components;
    Model here;
    Basis tangent;
    Vector scale;  //!< of the parameters, such that J^T J has a unit diagonal
    Square information, own;
};

}  // namespace usacv20
}  // namespace cv

#endif
