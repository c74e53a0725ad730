// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PROBLEM_HPP
#define OPENCV_USACV20_PROBLEM_HPP

#ifndef OPENCV_BINDING_PARSER  // nothing here is for other languages

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

//! What a sample takes, in units of the test of one point by the built-in kernels, about 2
//! nanoseconds.
struct SampleCost
{
    //! Both numbers.
    SampleCost(double time_, double models_) : time(time_), models(models_) {}

    double time;    //!< to solve a sample and to check its models
    double models;  //!< that are left to be rated, on average
};

/** @brief One kind of model: all that is particular to it.

The search, the samplers, the scores, the criteria know nothing else of what is estimated. A program
can bring a problem of its own, see Usac::create and samples/custom_problem.cpp. All methods are
`const`; those that are called during the search (closest()) come from one thread at a time. */
class CV_EXPORTS Problem
{
public:
    virtual ~Problem();

    //! For messages, one word. Usac::create raises cv::Exception that has it if the numbers below
    //! do not fit each other.
    virtual String name() const = 0;
    //! Degrees of freedom of a model; at most errorDimension() times the size of a sample.
    virtual int dimension() const = 0;
    /** Degrees of freedom of the error of an inlier, that is the codimension of the manifold on
    which exact data lie in the space of a datum: 2 where a point is mapped to a point of a plane
    (H), 3 where to one of space, 1 where it is mapped to a line (F, E). 1 to 3. So it is for
    symmetric errors, too: their terms are functions of each other, so the second term changes the
    scale of the error only. */
    virtual int errorDimension() const = 0;
    //! Numbers of a point in the caller's array 0 or 1: 1 to 3, or 0 if there is no array 1.
    //! Default: 2, two images.
    virtual int coordinates(int array) const;
    //! What messages call array 0 or 1. Default: points1, points2.
    virtual String arrayName(int array) const;
    //! True, the default: both arrays have the unit of the threshold, so that points of either that
    //! are nearer to each other are taken for the same. False: in array 0 only equal points are,
    //! and #NEIGHBORHOOD_KNN and #NEIGHBORHOOD_RADIUS look for neighbors in array 1 alone.
    virtual bool commonUnit() const;
    //! For the sequential test, and for the size of the batches.
    virtual SampleCost sampleCost() const = 0;
    //! True if two good models can have the same inliers, as the two motions of a plane that E has:
    //! then each is optimized. Default: false.
    virtual bool ambiguous() const;
    /** @brief True if nearly all inliers of a model leave some of its parameters free, as those of
    F or E on a plane, or seen by a camera that has only turned: then their errors tell little of
    these parameters.
    @param context the points in the coordinates of the model, the threshold
    @param model as components see it
    Default: false. */
    virtual bool leavesFree(const Context& context, const Model& model) const;

    /** @brief Moves the caller's points to the coordinates of the model, in place; E: from pixels
    to the normalized image plane.
    @param columns `count` numbers each
    @param count number of points
    @return pixels in a unit of the new coordinates. Default: 1, nothing is moved. */
    virtual double toModelCoordinates(double* const* columns, int count) const;
    //! The same for createImageResidual(): the points of the last array stay where they were seen.
    //! Default: nothing is moved.
    virtual void toImageCoordinates(double* const* columns, int count) const;
    /** @brief How the points may be normalized for the search.
    @param residual @ref ResidualType
    Default: #SCALE_NONE. */
    virtual int normalization(int residual) const;
    /** @brief A model of the search in the coordinates of toModelCoordinates(), in the normal form
    that is documented.
    @param model as components see it
    @param points their Correspondences::frame
    @param result output
    @return false if it is not finite. */
    virtual bool toInput(const Model& model, const Correspondences& points,
                         Model& result) const = 0;
    //! What Usac::run returns for a model of toInput(). Default: its matrix, CV_64F.
    virtual Mat toOutput(const Model& model) const;
    /** @brief The inverse of toOutput() and toInput(): a model of the caller's as the search sees
    it.
    @param output as many numbers as toOutput() has, finite, row by row
    @param points their Correspondences::frame
    @param model output
    @return false if it is none. Default: false, so that Params::initialModel is refused. */
    virtual bool fromOutput(const std::vector<double>& output, const Correspondences& points,
                            Model& model) const;
    /** @brief A model of the caller's in the coordinates of toModelCoordinates(), with the numbers
    as they are: what the mask and Usac::errors compare the points with.
    @param output a matrix of the shape of toOutput(), CV_64F Default: an empty one, it is not
    known; then fromOutput() and toInput() make it, the same but for rounding. */
    virtual Model ofOutput(const Mat& output) const;
    //! The closest model that fulfills all constraints; what solvers and polishers find may miss
    //! them by a bit. Default: the model itself.
    virtual Model closest(const Model& model) const;

    //! The error that @ref ResidualType names.
    virtual Ptr<Residual> createResidual(int type) const = 0;
    /** @brief The error where the points were seen, if the coordinates of the search are only
    nearly as good: the polishing and the mask take this one, of the points of toImageCoordinates().
    @param residual that of the search, in the same units and of the same models
    @return default: empty, `residual` is as good. */
    virtual Ptr<Residual> createImageResidual(const Ptr<Residual>& residual) const;
    //! The models of a minimal sample.
    virtual Ptr<MinimalSolver> createMinimalSolver() const = 0;
    //! Least squares of the errors of a residual. Asked again if the caller has brought another
    //! residual. Empty: none.
    virtual Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>& residual) const = 0;
    /** @brief Adds the checks that a set of @ref DegeneracyFlags names, in the order in which they
    are asked. Default: none.
    @param flags set of @ref DegeneracyFlags
    @param degeneracies output, to be appended to */
    virtual void createDegeneracies(int flags, std::vector<Ptr<Degeneracy>>& degeneracies) const;

    /** @brief Side of the cube on which outliers are taken to be uniform, in the coordinates of
    `points`: the vector of an error of d dimensions has the density extent^-d. Default: the
    geometric mean of the sides of the box in which nearly all points of the last array lie, for
    errors of dimension 1 of both. */
    virtual double outlierExtent(const Correspondences& points) const;
    /** @brief Probability that a point is an inlier of a wrong model, if wrong matches are
    everywhere: the part of the box of the last array that is within the threshold of a point or,
    for errors of dimension 1, of the longest line (by Sampson's distance if there are two arrays)
    or largest plane. At most 1. */
    virtual double randomInlierRatio(const Correspondences& points) const;
};

//! Values of Problem::normalization.
enum Normalization {
    SCALE_NONE,    //!< the constraints of the model need the coordinates as they are
    SCALE_COMMON,  //!< each array is moved to its center, both with one scale, with which the
                   //!< errors scale
    SCALE_EACH,    //!< each array is moved to its center and scaled by itself
    SCALE_FIRST    //!< array 0 is moved to its center and scaled, array 1 stays as it is
};

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
