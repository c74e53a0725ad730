// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/unit_norm.hpp"
#include "lanes/lane_solver.hpp"
#include "optimization/any_parameterization.hpp"
#include "problems/essential/cameras.hpp"
#include "problems/essential/essential.hpp"
#include "problems/essential/essential_parameterization.hpp"
#include "problems/two_view/dominant_plane.hpp"
#include "problems/two_view/two_view.hpp"
#include "problems/kernels.hpp"
#include "problems/seen_points.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Up to ten essential matrices from five points of calibrated cameras, see five_points.inl.hpp.
class Essential5Solver : public LaneSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 5; }

protected:
    SolverKernel kernelOf(const lanes::Kernels& kernels) const CV_OVERRIDE
    {
        return kernels.fivePoints;
    }
};

//! The epipolar geometry of two calibrated views: x2^T E x1 = 0 for points on the normalized image
//! planes; E has the singular values (s, s, 0).
class EssentialProblem : public Problem
{
public:
    explicit EssentialProblem(const Cameras& cameras_) : cameras(cameras_) {}

    String name() const CV_OVERRIDE { return "essential"; }
    int dimension() const CV_OVERRIDE { return EssentialParameterization::DIMENSION; }
    int errorDimension() const CV_OVERRIDE { return 1; }
    //! Time per sample in point tests (see SampleCost), and number of models per sample; both were
    //! measured.
    SampleCost sampleCost() const CV_OVERRIDE { return SampleCost(1500, 2); }
    //! Two camera motions explain all points of a plane @cite ma2004invitation; only points off the
    //! plane show which motion is right.
    bool ambiguous() const CV_OVERRIDE { return true; }
    bool leavesFree(const Context& context, const Model& model) const CV_OVERRIDE
    {
        return epipoleIsFree(context, model);
    }

    double toModelCoordinates(double* const* columns, int count) const CV_OVERRIDE
    {
        return cameras.toImagePlane(columns, count);
    }

    String doubt(const double* const* columns, int count) const CV_OVERRIDE
    {
        const SeenPoints first(columns[X1], columns[Y1], count),
            second(columns[X2], columns[Y2], count);
        if (first.aside || second.aside)
            return SeenPoints::ASIDE;
        return first.corner && first.corner == second.corner
                   ? "the principal point is at a corner of the points' box in both images: is the "
                     "camera matrix that of images of this size?"
                   : "";
    }

    //! The result has unit norm: its singular values are (1, 1, 0) / sqrt(2).
    bool toInput(const Model& model, const Correspondences&, Model& result) const CV_OVERRIDE
    {
        Matx33d E = model;
        if (!toUnitNorm(E))
            return false;
        result = E;
        return true;
    }

    Model ofOutput(const Mat& output) const CV_OVERRIDE { return Matx33d(output.ptr<double>()); }

    bool fromOutput(const std::vector<double>& output, const Correspondences&,
                    Model& model) const CV_OVERRIDE
    {
        if (output.size() != 9)
            return false;
        Matx33d E(output.data());
        const bool usable = toUnitNorm(E);
        model = closest(E);
        return usable;
    }

    Model closest(const Model& model) const CV_OVERRIDE
    {
        return EssentialParameterization(model).model();
    }

    Ptr<Residual> createResidual(int type) const CV_OVERRIDE
    {
        return type == RESIDUAL_SYMMETRIC ? createResidualOf<SymmetricEpipolarError>()
                                          : createResidualOf<SampsonError>();
    }

    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE { return createEssential5Solver(); }

    Ptr<Parameterization> createParameterization() const CV_OVERRIDE
    {
        return makePtr<BuiltInParameterization<EssentialParameterization>>();
    }

    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>& residual) const CV_OVERRIDE
    {
        return createEssentialFit(residual);
    }

    void createDegeneracies(int flags, std::vector<Ptr<Degeneracy>>& degeneracies) const CV_OVERRIDE
    {
        if (flags & DEGENERACY_ORIENTATION)
            degeneracies.push_back(createOrientedEpipolar());
        if (flags & DEGENERACY_DEGENSAC)
            degeneracies.push_back(createPlanarMotion());
        if (flags & DEGENERACY_REPEATED)
            degeneracies.push_back(createSharedPoints());
    }

private:
    const Cameras cameras;
};

}  // namespace

Ptr<MinimalSolver> createEssential5Solver() { return makePtr<Essential5Solver>(); }

Ptr<Problem> createEssentialProblem(InputArray cameraMatrix1, InputArray cameraMatrix2,
                                    InputArray distCoeffs1, InputArray distCoeffs2)
{
    return makePtr<EssentialProblem>(
        Cameras(cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2));
}

Ptr<NonMinimalSolver> createEssentialFit(const Ptr<Residual>& residual)
{
    return makePtr<LeastSquaresSolver<EssentialParameterization>>(residual, 1);
}

}  // namespace usacv20
}  // namespace cv
