// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "optimization/any_parameterization.hpp"
#include "problems/rigid_motion/rigid_motion.hpp"
#include "problems/rigid_motion/rigid_parameterization.hpp"
#include "problems/two_view/two_view.hpp"
#include "problems/kernels.hpp"

namespace cv {
namespace usacv20 {

namespace {

typedef Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> MapOfSpace;

//! Converts [A t] to the map between points of space 1 normalized by `from` and points of space 2
//! normalized by `to`. If both frames have the same scale, A is unchanged, without rounding.
Model moved(const MapOfSpace& map, const Frame& from, const Frame& to)
{
    const Eigen::Map<const Eigen::Vector3d> center1(from.center), center2(to.center);
    const Eigen::Matrix3d A = map.leftCols<3>() * (to.scale / from.scale);
    const Eigen::Vector3d t = (map.leftCols<3>() * center1 + map.col(3) - center2) * to.scale;
    return motionOf(A, t);
}

//! The inverse of moved().
Model movedBack(const MapOfSpace& map, const Frame& from, const Frame& to)
{
    const Eigen::Map<const Eigen::Vector3d> center1(from.center), center2(to.center);
    const Eigen::Matrix3d A = map.leftCols<3>() * (from.scale / to.scale);
    const Eigen::Vector3d t = map.col(3) / to.scale - A * center1 + center2;
    return motionOf(A, t);
}

/** @brief Rotation and translation from points of space 1 to their counterparts in space 2:
X2 = s R X1 + t. If `SCALED` is false, s = 1. Models, including those that the caller gets, are 3x4
matrices [sR t]. */
template <bool SCALED>
class RigidMotionProblem : public Problem
{
public:
    String name() const CV_OVERRIDE { return SCALED ? "similarity3D" : "rigid3D"; }
    int dimension() const CV_OVERRIDE { return RigidParameterization<SCALED>::DIMENSION; }
    int errorDimension() const CV_OVERRIDE { return 3; }
    int coordinates(int) const CV_OVERRIDE { return 3; }
    //! If the scale is estimated, too, the unit of space 1 can differ from that of space 2, which
    //! is also the unit of the threshold.
    bool commonUnit() const CV_OVERRIDE { return !SCALED; }
    //! The time, in point tests, was measured together with those of H, affinity and similarity.
    SampleCost sampleCost() const CV_OVERRIDE { return SampleCost(320, 1); }
    int normalization(int) const CV_OVERRIDE { return SCALED ? SCALE_EACH : SCALE_COMMON; }

    bool toInput(const Model& model, const Correspondences& points, Model& result) const CV_OVERRIDE
    {
        result = movedBack(MapOfSpace(model.val), points.frame[0], points.frame[1]);
        const bool regular = MapOfSpace(result.val).leftCols<3>().squaredNorm() >
                             0;  // false: A has underflowed
        return regular && checkRange(Mat(3, 4, CV_64F, result.val));
    }

    Model ofOutput(const Mat& output) const CV_OVERRIDE { return Matx34d(output.ptr<double>()); }

    bool fromOutput(const std::vector<double>& output, const Correspondences& points,
                    Model& model) const CV_OVERRIDE
    {
        if (output.size() != 12)
            return false;
        model = closest(moved(MapOfSpace(output.data()), points.frame[0], points.frame[1]));
        return checkRange(Mat(3, 4, CV_64F, model.val));
    }

    Model closest(const Model& model) const CV_OVERRIDE
    {
        return RigidParameterization<SCALED>(model).model();
    }

    Ptr<Residual> createResidual(int type) const CV_OVERRIDE
    {
        if (type == RESIDUAL_SYMMETRIC)
            CV_Error_(
                Error::StsBadArg,
                ("residual: RESIDUAL_SYMMETRIC is for two images; the problem %s measures the "
                 "distance in space 2",
                 name().c_str()));
        return createResidualOf<SpaceTransferError>();
    }

    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE
    {
        return createTriangleSolver(SCALED);
    }

    Ptr<Parameterization> createParameterization() const CV_OVERRIDE
    {
        return makePtr<BuiltInParameterization<RigidParameterization<SCALED>>>();
    }

    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>& residual) const CV_OVERRIDE
    {
        return createRigidFit(residual, SCALED);
    }

    void createDegeneracies(int flags, std::vector<Ptr<Degeneracy>>& degeneracies) const CV_OVERRIDE
    {
        createChecksOfMaps(flags, name(), degeneracies);
    }
};

}  // namespace

Ptr<Problem> createRigid3DProblem() { return makePtr<RigidMotionProblem<false>>(); }

Ptr<Problem> createSimilarity3DProblem() { return makePtr<RigidMotionProblem<true>>(); }

Ptr<NonMinimalSolver> createRigidFit(const Ptr<Residual>& residual, bool scaled)
{
    if (hasFormula<SpaceTransferError>(*residual))
        return createRigidLeastSquares(scaled);
    if (scaled)
        return makePtr<LeastSquaresSolver<RigidParameterization<true>>>(residual, 3);
    return makePtr<LeastSquaresSolver<RigidParameterization<false>>>(residual, 3);
}

}  // namespace usacv20
}  // namespace cv
