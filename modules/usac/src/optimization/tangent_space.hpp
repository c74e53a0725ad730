// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TANGENT_SPACE_HPP
#define OPENCV_USACV20_TANGENT_SPACE_HPP

#include <Eigen/Geometry>
#include "optimization/inner_product.hpp"
#include "residual/normal_equations.hpp"

namespace cv {
namespace usacv20 {

typedef Eigen::Matrix<double, 3, 3, Eigen::RowMajor> RowMajor3;

//! The rotation about the axis w by the angle |w| in radians.
inline Eigen::Matrix3d rotationOf(const Eigen::Vector3d& w)
{
    const double angle = w.norm();
    if (angle < 1e-300)
        return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, w / angle).toRotationMatrix();
}

//! Derivative of a matrix with respect to the angle by which it is rotated about an axis of unit
//! length, at angle 0: the cross product of the axis with each column.
inline Eigen::Matrix3d turnedAbout(const Eigen::Vector3d& axis, const Eigen::Matrix3d& matrix)
{
    Eigen::Matrix3d turned;
    for (int j = 0; j < 3; ++j)
        turned.col(j) = axis.cross(matrix.col(j));
    return turned;
}

//! Converts normal equations in the entries of the model to equations in the parameters:
//! A = B^T JtJ B and b = B^T Jtr. B is `basis`, the derivatives of the entries with respect to the
//! parameters.
template <int DIMENSION, int SIZE>
void projectOnTangents(const NormalEquationsOf<SIZE>& sums,
                       const Eigen::Matrix<double, SIZE, DIMENSION>& basis,
                       Eigen::Matrix<double, DIMENSION, DIMENSION>& A,
                       Eigen::Matrix<double, DIMENSION, 1>& b)
{
    const Eigen::Matrix<double, SIZE, DIMENSION> image = sums.JtJ.lazyProduct(basis);
    for (int j = 0; j < DIMENSION; ++j)
        for (int i = j; i < DIMENSION; ++i)
            A(i, j) = A(j, i) = innerProduct(basis.col(i), image.col(j));
    for (int i = 0; i < DIMENSION; ++i)
        b[i] = innerProduct(basis.col(i), sums.Jtr);
}

}  // namespace usacv20
}  // namespace cv

#endif
