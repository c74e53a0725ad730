// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CLOSEST_ROTATION_HPP
#define OPENCV_USACV20_CLOSEST_ROTATION_HPP

#include <limits>
#include <Eigen/SVD>

namespace cv {
namespace usacv20 {

/** The rotation R that is closest to a matrix M in the Frobenius norm, from the singular value
decomposition of M. It is also the rotation with the largest trace of R^T M. All members are NaN if
M is not finite. */
struct ClosestRotation
{
    explicit ClosestRotation(const Eigen::Matrix3d& M)
    {
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
#if EIGEN_VERSION_AT_LEAST(3, 4, 0)  // since this version, info() exists, and U and V are undefined
                                     // if M is not finite
        const bool solved = svd.info() == Eigen::Success;
#else
        const bool solved = M.allFinite();
#endif
        if (!solved)
        {
            scale = std::numeric_limits<double>::quiet_NaN();
            rotation.setConstant(scale);
            singularValues.setConstant(scale);
            return;
        }
        Eigen::Matrix3d U = svd.matrixU();
        singularValues = svd.singularValues();
        const bool mirrored = U.determinant() * svd.matrixV().determinant() < 0;
        if (mirrored)
            U.col(2) = -U.col(2);
        rotation = U * svd.matrixV().transpose();
        scale = (singularValues[0] + singularValues[1] + (mirrored ? -1 : 1) * singularValues[2]) /
                3;
    }

    Eigen::Matrix3d rotation;
    double scale;                    //!< factor s for which s R is closest to M: trace(R^T M) / 3
    Eigen::Vector3d singularValues;  //!< singular values of M, largest first
};

}  // namespace usacv20
}  // namespace cv

#endif
