// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/rigid_motion/rigid_parameterization.hpp"
#include "optimization/closest_rotation.hpp"

namespace cv {
namespace usacv20 {

template <bool SCALED>
RigidParameterization<SCALED>::RigidParameterization(const Model& model)
{
    const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> M(model.val);
    const ClosestRotation closest(M.leftCols<3>());
    R = closest.rotation;
    t = M.col(3);
    scale = SCALED ? closest.scale : 1;
}

template <bool SCALED>
typename RigidParameterization<SCALED>::Basis RigidParameterization<SCALED>::tangent() const
{
    Basis basis;
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    for (int k = 0; k < DIMENSION; ++k)
    {
        const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k % 3);
        const Model moved = k < 3   ? motionOf(scale * turnedAbout(axis, R), zero)
                            : k < 6 ? motionOf(Eigen::Matrix3d::Zero(), axis)
                                    : motionOf(scale * R, zero);
        basis.col(k) = Eigen::Map<const Eigen::Matrix<double, NUMBERS, 1>>(moved.val);
    }
    return basis;
}

template <bool SCALED>
RigidParameterization<SCALED> RigidParameterization<SCALED>::plus(const Step& step) const
{
    RigidParameterization result(*this);
    result.R = rotationOf(step.template head<3>()) * R;
    result.t = t + step.template segment<3>(3);
    if (SCALED)
        result.scale = scale * (1 + step[DIMENSION - 1]);
    return result;
}

template class RigidParameterization<false>;
template class RigidParameterization<true>;

}  // namespace usacv20
}  // namespace cv
