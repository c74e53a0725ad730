// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/unit_norm.hpp"
#include "lanes/lane_solver.hpp"
#include "optimization/any_parameterization.hpp"
#include "problems/fundamental/fundamental.hpp"
#include "problems/fundamental/fundamental_parameterization.hpp"
#include "problems/two_view/dominant_plane.hpp"
#include "problems/two_view/two_view.hpp"
#include "problems/kernels.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Up to three fundamental matrices from seven points, see seven_points.inl.hpp.
class Fundamental7Solver : public LaneSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 7; }

protected:
    SolverKernel kernelOf(const lanes::Kernels& kernels) const CV_OVERRIDE
    {
        return kernels.sevenPoints;
    }
};

/** The matrix of rank 2 that is closest to F, scaled to unit norm. F must have unit norm; it is
returned unchanged if its rank is 2 up to rounding. The argument is a product T2^T M T1, where T1
and T2 normalize the points of the images and M, the model of the search, has rank 2. The product
has rank 2 only up to the rounding errors of its largest terms. If these terms cancel, for example
because both epipoles are at the origin and coordinates are large, these errors are not small
relative to the product. */
Matx33d toRankTwo(const Matx33d& F)
{
    Vec3d w;
    Matx33d U, Vt;
    SVD::compute(F, w, U, Vt);
    if (w[2] <= 1e-12)
        return F;
    return ofUnitNorm(F - w[2] * U.col(2) * Vt.row(2));
}

//! The epipolar geometry of two views: x2^T F x1 = 0, where F has rank 2.
class FundamentalProblem : public Problem
{
public:
    String name() const CV_OVERRIDE { return "fundamental"; }
    int dimension() const CV_OVERRIDE { return FundamentalParameterization::DIMENSION; }
    int errorDimension() const CV_OVERRIDE { return 1; }
    //! Time per sample in point tests (see SampleCost), and number of models per sample; both were
    //! measured.
    SampleCost sampleCost() const CV_OVERRIDE { return SampleCost(300, 1.2); }
    int normalization(int) const CV_OVERRIDE { return SCALE_COMMON; }
    bool leavesFree(const Context& context, const Model& model) const CV_OVERRIDE
    {
        return epipoleIsFree(context, model);
    }

    //! The result has rank 2 and unit norm.
    bool toInput(const Model& model, const Correspondences& points, Model& result) const CV_OVERRIDE
    {
        Matx33d F = points.frame[1].matrix().t() * Matx33d(model) * points.frame[0].matrix();
        if (!toUnitNorm(F))
            return false;
        result = toRankTwo(F);
        return true;
    }

    Model ofOutput(const Mat& output) const CV_OVERRIDE { return Matx33d(output.ptr<double>()); }

    bool fromOutput(const std::vector<double>& output, const Correspondences& points,
                    Model& model) const CV_OVERRIDE
    {
        if (output.size() != 9)
            return false;
        Matx33d F = points.frame[1].matrix().inv().t() * Matx33d(output.data()) *
                    points.frame[0].matrix().inv();
        const bool usable = toUnitNorm(F);
        model = closest(F);
        return usable;
    }

    Model closest(const Model& model) const CV_OVERRIDE
    {
        return FundamentalParameterization(model).model();
    }

    Ptr<Residual> createResidual(int type) const CV_OVERRIDE
    {
        return type == RESIDUAL_SYMMETRIC ? createResidualOf<SymmetricEpipolarError>()
                                          : createResidualOf<SampsonError>();
    }

    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE
    {
        return createFundamental7Solver();
    }

    Ptr<Parameterization> createParameterization() const CV_OVERRIDE
    {
        return makePtr<BuiltInParameterization<FundamentalParameterization>>();
    }

    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>& residual) const CV_OVERRIDE
    {
        return createFundamentalFit(residual);
    }

    void createDegeneracies(int flags, std::vector<Ptr<Degeneracy>>& degeneracies) const CV_OVERRIDE
    {
        if (flags & DEGENERACY_ORIENTATION)
            degeneracies.push_back(createOrientedEpipolar());
        if (flags & DEGENERACY_DEGENSAC)
            degeneracies.push_back(createDegensac());
        if (flags & DEGENERACY_REPEATED)
            degeneracies.push_back(createSharedPoints());
    }
};

}  // namespace

Ptr<MinimalSolver> createFundamental7Solver() { return makePtr<Fundamental7Solver>(); }

Ptr<Problem> createFundamentalProblem() { return makePtr<FundamentalProblem>(); }

Ptr<NonMinimalSolver> createFundamentalFit(const Ptr<Residual>& residual)
{
    return makePtr<LeastSquaresSolver<FundamentalParameterization>>(residual, 1);
}

}  // namespace usacv20
}  // namespace cv
