// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "optimization/closest_rotation.hpp"
#include "problems/absolute_pose/pose_parameterization.hpp"

namespace cv {
namespace usacv20 {

PoseParameterization::PoseParameterization(const Matx33d& camera, const Model& model)
    : K(Eigen::Map<const RowMajor3>(camera.val))
{
    const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> M(model.val);
    const Eigen::Matrix<double, 3, 4> pose = K.inverse() * M;
    const ClosestRotation closest(pose.leftCols<3>());
    R = closest.rotation;
    t = pose.col(3) * (3 / closest.singularValues.sum());
}

PoseParameterization::PoseParameterization(const Matx33d& camera, const Matx33d& rotation,
                                           const Vec3d& translation)
    : K(Eigen::Map<const RowMajor3>(camera.val)), R(Eigen::Map<const RowMajor3>(rotation.val)),
      t(translation[0], translation[1], translation[2])
{}

PoseParameterization::Basis PoseParameterization::tangent() const
{
    Basis basis;
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
    {
        const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k);
        const Model rotated = withCamera(turnedAbout(axis, R), zero),
                    moved = withCamera(Eigen::Matrix3d::Zero(), axis);
        for (int i = 0; i < NUMBERS; ++i)
        {
            basis(i, k) = rotated.val[i];
            basis(i, 3 + k) = moved.val[i];
        }
    }
    return basis;
}

PoseParameterization PoseParameterization::plus(const Step& step) const
{
    PoseParameterization result(*this);
    result.R = rotationOf(step.head<3>()) * R;
    result.t = t + step.tail<3>();
    return result;
}

Model PoseParameterization::model() const { return withCamera(R, t); }

Matx33d PoseParameterization::rotation() const
{
    Matx33d result;
    Eigen::Map<RowMajor3>(result.val) = R;
    return result;
}

Model PoseParameterization::withCamera(const Eigen::Matrix3d& rotation,
                                       const Eigen::Vector3d& translation) const
{
    Model result(3, 4);
    Eigen::Map<Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> M(result.val);
    M.leftCols<3>() = K * rotation;
    M.col(3) = K * translation;
    return result;
}

}  // namespace usacv20
}  // namespace cv
