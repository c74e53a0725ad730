// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PROBLEM_HPP
#define OPENCV_USACV20_PROBLEM_HPP

#ifndef OPENCV_BINDING_PARSER  // C++ only, no bindings

#include "opencv2/usac/least_squares.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20_extend
//! @{

//! Cost of a minimal sample. The unit of time is one point test, the time that the built-in kernels
//! take to score one point, about 2 ns.
struct SampleCost
{
    //! Sets both numbers.
    SampleCost(double time_, double models_) : time(time_), models(models_) {}

    double time;    //!< time to solve a sample and to check its models, in point tests
    double models;  //!< average number of models per sample that remain to be scored
};

/** @brief One kind of model: everything that is specific to it.

The search, the samplers, the scores and the termination criteria access the properties of the model
only through this class. A program can define its own problem, see Usac::create and
samples/custom_problem.cpp. All methods are `const`; a run calls them from one thread at a time. */
class CV_EXPORTS Problem
{
public:
    virtual ~Problem();

    //! Name in messages, one word. Usac::create raises a cv::Exception with this name if the
    //! numbers below are inconsistent.
    virtual String name() const = 0;
    //! Degrees of freedom of a model: Parameterization::dimension of createParameterization(), and
    //! at most errorDimension() times the sample size.
    virtual int dimension() const = 0;
    /** Degrees of freedom of the error of an inlier, 1 to 3; that is the codimension of the
    manifold of exact data in the space of a datum. It is 2 if a point is mapped to a point of a
    plane (H), 3 if it is mapped to a 3-D point, and 1 if it is mapped to a line (F, E). A symmetric
    error has the same number as the one-sided error: its two terms are functions of each other, so
    the second term only changes the scale. */
    virtual int errorDimension() const = 0;
    //! Coordinates per point in the caller's array 0 or 1: 1 to 3, or 0 if there is no array 1.
    //! Default: 2, two images.
    virtual int coordinates(int array) const;
    //! Name of array 0 or 1 in messages. Default: points1, points2.
    virtual String arrayName(int array) const;
    //! True (default): both arrays have the unit of the threshold; points of an array that are
    //! within about one threshold of each other are treated as repetitions of one point. False: in
    //! array 0, only equal points are repetitions, and #NEIGHBORHOOD_KNN and #NEIGHBORHOOD_RADIUS
    //! use array 1 only.
    virtual bool commonUnit() const;
    //! Cost of a sample, for SPRT and for the size of the batches.
    virtual SampleCost sampleCost() const = 0;
    //! True if two good models can have the same inliers, like the two motions that are compatible
    //! with a plane (E). A model with the same inliers as the best one is then optimized, too.
    //! Default: false.
    virtual bool ambiguous() const;
    /** @brief True if nearly all inliers together leave some parameters of the model undetermined:
    for F and E, if these inliers lie on a plane or the camera only rotates.
    @param context the data of the run: points in the coordinates of the model, and the threshold
    @param model in the coordinates of Correspondences

    Default: false. */
    virtual bool leavesFree(const Context& context, const Model& model) const;

    /** @brief Transforms the caller's points to the coordinates of the model, in place; for E, from
    pixels to the normalized image plane.
    @param columns columns of `count` numbers each
    @param count number of points
    @return number of pixels (units of Params::threshold) per unit of the new coordinates. Default:
    1, nothing is transformed. */
    virtual double toModelCoordinates(double* const* columns, int count) const;
    //! What is implausible about points in the coordinates of toModelCoordinates(), some of which
    //! can be NaN: a text for Report::warning. Default: empty, nothing is.
    virtual String doubt(const double* const* columns, int count) const;
    //! Converts the points of array 1, in place, to the unit of toModelCoordinates() without
    //! removing their distortion, for createImageResidual(). The columns of array 0 must stay
    //! unchanged. Default: nothing is converted.
    virtual void toImageCoordinates(double* const* columns, int count) const;
    /** @brief How the points are normalized for the search, a @ref Normalization.
    @param residual @ref ResidualType

    Default: #SCALE_NONE. */
    virtual int normalization(int residual) const;
    /** @brief Converts a model of the search to the coordinates of toModelCoordinates() and to the
    scale and sign in which models are returned.
    @param model model in the coordinates of Correspondences
    @param points the points of the run, for their Correspondences::frame
    @param result output
    @return false if the result is not finite. */
    virtual bool toInput(const Model& model, const Correspondences& points,
                         Model& result) const = 0;
    //! Converts a model from toInput() to what Usac::run returns. Default: its matrix, CV_64F.
    virtual Mat toOutput(const Model& model) const;
    /** @brief The inverse of toOutput() and toInput(): converts a model of the caller to the
    coordinates of the search.
    @param output finite numbers, row by row; their count might be wrong
    @param points the points of the run, for their Correspondences::frame
    @param model output
    @return false if `output` is not a valid model or has a wrong count. Default: false, so that
    Params::initialModel raises cv::Exception. */
    virtual bool fromOutput(const std::vector<double>& output, const Correspondences& points,
                            Model& model) const;
    /** @brief Converts a model of the caller to the coordinates of toModelCoordinates(), for the
    mask and Usac::errors. The model is taken as it is, even if it violates constraints slightly.
    @param output a matrix of the shape of toOutput(), CV_64F

    Default: an empty model; fromOutput() and toInput() are then used instead, with the same result
    up to rounding. */
    virtual Model ofOutput(const Mat& output) const;
    //! The closest model that fulfills all constraints. Models of solvers and polishers might
    //! violate them slightly. Default: the model itself.
    virtual Model closest(const Model& model) const;

    //! Creates the residual for a @ref ResidualType.
    virtual Ptr<Residual> createResidual(int type) const = 0;
    /** @brief Creates the residual for the original image points, if the error of the search only
    approximates the error there. Polishing and the mask use it with the points of
    toImageCoordinates().
    @param residual the residual of the search; the new one has the same unit and the same models
    @return the new residual. Default: empty, which means that `residual` is exact. */
    virtual Ptr<Residual> createImageResidual(const Ptr<Residual>& residual) const;
    //! Creates the minimal solver.
    virtual Ptr<MinimalSolver> createMinimalSolver() const = 0;
    //! Creates the parameterization with which least squares varies the models, in the coordinates
    //! of Correspondences. Default: empty, there is none.
    virtual Ptr<Parameterization> createParameterization() const;
    //! Creates a solver that minimizes the sum of squares of a residual; empty if there is none.
    //! Called again if a program has replaced the residual, but not the solver. Default:
    //! #createLeastSquares with createParameterization(); empty if there is no parameterization.
    virtual Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>& residual) const;
    /** @brief Appends the checks for a set of @ref DegeneracyFlags, in the order in which they are
    called. Default: none.
    @param flags set of @ref DegeneracyFlags
    @param degeneracies output; the checks are appended */
    virtual void createDegeneracies(int flags, std::vector<Ptr<Degeneracy>>& degeneracies) const;

    /** @brief Side of the cube in which the error vectors of outliers are assumed to be uniformly
    distributed, in the coordinates of `points`. In d dimensions, their density is side^-d. Default:
    the geometric mean of the sides of the box that contains nearly all points of the last array (of
    both arrays for errors of dimension 1). */
    virtual double outlierExtent(const Correspondences& points) const;
    /** @brief Probability that a point is an inlier of a wrong model, if wrong matches are
    uniformly distributed; at most 1. Default: an upper bound of the fraction of a box that is
    within the threshold of a point, line or plane of codimension errorDimension(). The box contains
    nearly all points of the last array. For errors of dimension 1 and two arrays, the threshold is
    that of the Sampson distance. */
    virtual double randomInlierRatio(const Correspondences& points) const;
};

//! How points are normalized for the search, see Problem::normalization.
enum Normalization {
    SCALE_NONE,    //!< no normalization: the constraints of the model hold in the original
                   //!< coordinates only. The module's least-squares fits then hardly converge if
                   //!< the distance of the points from the origin is 100 times their extent or more
    SCALE_COMMON,  //!< each array is centered, and both are scaled by the same factor, which then
                   //!< also multiplies all errors
    SCALE_EACH,    //!< each array is centered and scaled separately
    SCALE_FIRST    //!< array 0 is centered and scaled, array 1 is unchanged
};

/** @brief Tests whether the methods of a problem agree with each other, for the models of random
minimal samples. For tests of a program that defines a problem. Tested are

- the numbers that Usac::create refuses;
- createMinimalSolver(): the points of a sample have no errors under its models, if the sample has
  no more equations than a model has degrees of freedom;
- createResidual(): both versions of squaredErrors() compute the same squares, which are the squared
  lengths of error(), whose derivative linearize() returns. Also errorDimension() and
  Residual::homogeneous;
- createParameterization(): #checkParameterization;
- closest(), toInput(), fromOutput(), ofOutput(): the converted model has the same errors, in the
  caller's units;
- methods of solvers, residuals and parameterizations write as many numbers as they should.

Not tested: createImageResidual(), createNonMinimalSolver(), createDegeneracies(), and the numbers
for probabilities.
@param problem the problem to test
@param points1, points2 points as in Usac::create, such as the program will have; wrong matches do
no harm. An invalid argument raises cv::Exception
@return empty if no violation was found, otherwise a description of the first violated law, which
begins with the name of the method. A law is permitted to be violated in a quarter of the cases,
because the models of some random samples are ill-conditioned. */
CV_EXPORTS String checkProblem(const Ptr<Problem>& problem, InputArray points1,
                               InputArray points2 = noArray());

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
