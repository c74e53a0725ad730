// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PLANE_MAP_HPP
#define OPENCV_USACV20_PLANE_MAP_HPP

#include "optimization/any_parameterization.hpp"
#include "problems/kernels.hpp"

namespace cv {
namespace usacv20 {

/** @brief Weighted means and second moments of matches, from which the least-squares affinity or
similarity x2 = A x1 + t is computed. The problem is linear, and t is 0 for points relative to the
means @cite umeyama1991least. The moments take one pass over the matches, with about 30 operations
per match. */
struct Moments
{
    /** Moments of `count` matches. The sums use coordinates relative to the first match, so that
    little precision is lost if all points are close together and far from the origin. If `weights`
    is null, all weights are 1. */
    Moments(const Correspondences& points, const int* indices, int count, const double* weights);

    //! The map with the linear part (a b; c d) that maps the mean of the points in image 1 to the
    //! mean of the points in image 2.
    Matx33d map(double a, double b, double c, double d) const;

    double mean[4];     //!< means of x1, y1, x2, y2
    double xx, xy, yy;  //!< moments of x1, y1 about the means, not divided by the sum of weights
    double xu, xv, yu, yv;  //!< the same for the products x1 x2, x1 y2, y1 x2 and y1 y2
};

/** @brief Common base of the problems whose model is an affine map of the plane, x2 = A x1 + t. A
model is a homography with the last row 0 0 1, so that errors, kernels and sums are those of a
homography; the caller gets the 2x3 matrix [A t], as from cv::estimateAffine2D. */
class PlaneMapProblem : public Problem
{
public:
    int errorDimension() const CV_OVERRIDE { return 2; }
    //! The same as for a homography, because the errors are the same.
    int normalization(int residual) const CV_OVERRIDE;
    bool toInput(const Model& model, const Correspondences& points,
                 Model& result) const CV_OVERRIDE;
    bool fromOutput(const std::vector<double>& output, const Correspondences& points,
                    Model& model) const CV_OVERRIDE;
    Mat toOutput(const Model& model) const CV_OVERRIDE;
    Model ofOutput(const Mat& output) const CV_OVERRIDE;
    Ptr<Residual> createResidual(int type) const CV_OVERRIDE;
    void createDegeneracies(int flags,
                            std::vector<Ptr<Degeneracy>>& degeneracies) const CV_OVERRIDE;
};

//! The differences between the kinds of affine maps.
struct PlaneMapParts
{
    const char* name;   //!< see Problem::name
    double sampleTime;  //!< see SampleCost::time
    bool keepsScale;    //!< true if the map cannot change the scale; the normalization must then
                        //!< scale both images by the same factor
    Ptr<MinimalSolver> (*minimalSolver)();    //!< creates the solver for minimal samples
    Ptr<NonMinimalSolver> (*leastSquares)();  //!< creates the closed-form least-squares fit of the
                                              //!< transfer error
};

//! @brief The problem of one kind of affine map; `Parameterization_` is its PlaneParameterization.
template <class Parameterization_>
class PlaneMap : public PlaneMapProblem
{
public:
    explicit PlaneMap(const PlaneMapParts& parts_) : parts(parts_) {}

    String name() const CV_OVERRIDE { return parts.name; }
    int dimension() const CV_OVERRIDE { return Parameterization_::DIMENSION; }
    SampleCost sampleCost() const CV_OVERRIDE { return SampleCost(parts.sampleTime, 1); }
    int normalization(int residual) const CV_OVERRIDE
    {
        return parts.keepsScale ? (int)SCALE_COMMON : PlaneMapProblem::normalization(residual);
    }
    Model closest(const Model& model) const CV_OVERRIDE { return Parameterization_(model).model(); }
    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE { return parts.minimalSolver(); }
    Ptr<Parameterization> createParameterization() const CV_OVERRIDE
    {
        return makePtr<BuiltInParameterization<Parameterization_>>();
    }

    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>& residual) const CV_OVERRIDE
    {
        if (hasFormula<TransferError>(*residual))
            return parts.leastSquares();
        return makePtr<LeastSquaresSolver<Parameterization_>>(residual, 2);
    }

private:
    const PlaneMapParts parts;
};

}  // namespace usacv20
}  // namespace cv

#endif
