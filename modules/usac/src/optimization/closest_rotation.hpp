// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CLOSEST_ROTATION_HPP
#define OPENCV_USACV20_CLOSEST_ROTATION_HPP

#include <cmath>
#include <Eigen/SVD>

namespace cv {
namespace usacv20 {

//! All of it is NaN if the matrix is not finite: Eigen by itself leaves then what was in the memory.
struct FullSvd : Eigen::JacobiSVD<Eigen::Matrix3d>
{
    explicit FullSvd(const Eigen::Matrix3d& M)
    {
        m_matrixU.setConstant(NAN);
        m_matrixV.setConstant(NAN);
        m_singularValues.setConstant(NAN);
        compute(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
    }
};

/** The rotation that is the closest to a matrix M in the Frobenius norm, and has the largest trace of R^T M, by the
singular value decomposition. NaN if M is not finite. */
struct ClosestRotation
{
    explicit ClosestRotation(const Eigen::Matrix3d& M)
    {
        const FullSvd svd(M);
        Eigen::Matrix3d U = svd.matrixU();
        singularValues = svd.singularValues();
        const bool mirrored = U.determinant() * svd.matrixV().determinant() < 0;
        if (mirrored)
            U.col(2) = -U.col(2);
        rotation = U * svd.matrixV().transpose();
        scale = (singularValues[0] + singularValues[1] + (mirrored ? -1 : 1) * singularValues[2]) / 3;
    }

    Eigen::Matrix3d rotation;
    double scale;                    //!< by which it is the closest: a third of that trace
    Eigen::Vector3d singularValues;  //!< of M, the largest first
};

}  // namespace usacv20
}  // namespace cv

#endif
