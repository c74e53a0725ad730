// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "optimization/any_parameterization.hpp"
#include "problems/absolute_pose/absolute_pose.hpp"
#include "problems/absolute_pose/camera.hpp"
#include "problems/absolute_pose/lens_residual.hpp"
#include "problems/absolute_pose/pose_parameterization.hpp"
#include "problems/kernels.hpp"
#include "problems/seen_points.hpp"
#include "problems/two_view/two_view.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** @brief Rotation and translation of a calibrated camera from 3D points and their images:
x ~ K (R X + t).

Models of the search are 3x4 camera matrices, see PoseCamera; the caller gets [R t]. */
class AbsolutePoseProblem : public Problem
{
public:
    AbsolutePoseProblem(InputArray cameraMatrix, InputArray distCoeffs)
        : camera(cameraMatrix, distCoeffs)
    {}

    String name() const CV_OVERRIDE { return "absolutePose"; }
    int dimension() const CV_OVERRIDE { return PoseParameterization::DIMENSION; }
    int errorDimension() const CV_OVERRIDE { return 2; }
    int coordinates(int array) const CV_OVERRIDE { return array == 0 ? 3 : 2; }
    bool commonUnit() const CV_OVERRIDE { return false; }
    //! Time per sample in point tests (see SampleCost), and number of models per sample; both were
    //! measured.
    SampleCost sampleCost() const CV_OVERRIDE { return SampleCost(800, 1.7); }

    double toModelCoordinates(double* const* columns, int count) const CV_OVERRIDE
    {
        camera.toSearch(columns[3], columns[4], count);
        return camera.focal;
    }

    String doubt(const double* const* columns, int count) const CV_OVERRIDE
    {
        return SeenPoints(columns[3], columns[4], count).aside ? SeenPoints::ASIDE : "";
    }

    void toImageCoordinates(double* const* columns, int count) const CV_OVERRIDE
    {
        camera.toSearchUnits(columns[3], columns[4], count);
    }

    int normalization(int) const CV_OVERRIDE { return SCALE_FIRST; }

    bool toInput(const Model& model, const Correspondences& points, Model& result) const CV_OVERRIDE
    {
        const Frame& frame = points.frame[0];
        const PoseParameterization pose(camera.matrix, model);
        const Matx33d R = pose.rotation();
        const Vec3d t = pose.translation() * (1 / frame.scale) - R * Vec3d(frame.center);
        result = PoseParameterization(camera.matrix, R, t).model();
        return checkRange(Mat(3, 4, CV_64F, result.val));
    }

    Mat toOutput(const Model& model) const CV_OVERRIDE
    {
        const PoseParameterization pose(camera.matrix, model);
        const Matx33d R = pose.rotation();
        const Vec3d t = pose.translation();
        return Mat(Matx34d(R(0, 0), R(0, 1), R(0, 2), t[0], R(1, 0), R(1, 1), R(1, 2), t[1],
                           R(2, 0), R(2, 1), R(2, 2), t[2]),
                   true);
    }

    Model ofOutput(const Mat& output) const CV_OVERRIDE
    {
        const Matx34d pose(output.ptr<double>());
        return camera.matrix * pose;
    }

    bool fromOutput(const std::vector<double>& output, const Correspondences& points,
                    Model& model) const CV_OVERRIDE
    {
        if (output.size() != 12)
            return false;
        const Frame& frame = points.frame[0];
        const PoseParameterization pose(Matx33d::eye(), Model(Matx34d(output.data())));
        const Matx33d R = pose.rotation();
        const Vec3d t = (R * Vec3d(frame.center) + pose.translation()) * frame.scale;
        model = PoseParameterization(camera.matrix, R, t).model();
        return checkRange(Mat(3, 4, CV_64F, model.val));
    }

    Model closest(const Model& model) const CV_OVERRIDE
    {
        return PoseParameterization(camera.matrix, model).model();
    }

    Ptr<Residual> createResidual(int type) const CV_OVERRIDE
    {
        if (type == RESIDUAL_SYMMETRIC)
            CV_Error(Error::StsBadArg,
                     "residual: RESIDUAL_SYMMETRIC needs two images; an absolute pose has one");
        return createResidualOf<ReprojectionError>();
    }

    Ptr<Residual> createImageResidual(const Ptr<Residual>& residual) const CV_OVERRIDE
    {
        const bool whitened = hasFormula<WhitenedReprojectionError>(*residual);
        const bool approximate = whitened || hasFormula<ReprojectionError>(*residual);
        if (!camera.distorted || !approximate)
            return Ptr<Residual>();
        return makePtr<LensResidual>(camera, whitened);
    }

    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE
    {
        return createP3PSolver(camera.matrix);
    }

    Ptr<Parameterization> createParameterization() const CV_OVERRIDE
    {
        typedef PoseParameterization::Around Around;
        return makePtr<BuiltInParameterization<PoseParameterization, Around>>(
            Around(camera.matrix));
    }

    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>& residual) const CV_OVERRIDE
    {
        return createPoseFit(residual, camera.matrix);
    }

    void createDegeneracies(int flags, std::vector<Ptr<Degeneracy>>& degeneracies) const CV_OVERRIDE
    {
        createChecksOfMaps(flags, name(), degeneracies);
        if (flags & DEGENERACY_DEGENSAC)
            degeneracies.push_back(createSecondPose(camera.matrix));
    }

private:
    const PoseCamera camera;
};

}  // namespace

Ptr<Problem> createAbsolutePoseProblem(InputArray cameraMatrix, InputArray distCoeffs)
{
    return makePtr<AbsolutePoseProblem>(cameraMatrix, distCoeffs);
}

Ptr<NonMinimalSolver> createPoseFit(const Ptr<Residual>& residual, const Matx33d& camera)
{
    typedef LeastSquaresSolver<PoseParameterization, PoseParameterization::Around> Fit;
    return makePtr<Fit>(residual, 2, PoseParameterization::Around(camera));
}

}  // namespace usacv20
}  // namespace cv
