// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "lanes/lane_kernels.hpp"
#include "problems/fundamental/fundamental_parameterization.hpp"
#include "problems/two_view/null_vectors.hpp"

#include <Eigen/SVD>

namespace cv {
namespace usacv20 {

namespace {

//! F is considered a matrix of rank 1 if the ratio of its second to its first singular value is at
//! most this number. The ratio has a rounding error of about 1e-16. For points in pixels, the ratio
//! is about the inverse square of the focal length.
constexpr double RANK_ONE = 1e-12;

}  // namespace

FundamentalParameterization::FundamentalParameterization(const Model& model)
{
    const Eigen::Map<const RowMajor3> M(model.val);
    if (completeNullVectors(M, U, V))
    {
        corner = U.leftCols<2>().transpose() * M * V.leftCols<2>();
        corner /= corner.norm();
        return;
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(Eigen::Matrix3d(M),
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    U = svd.matrixU();
    V = svd.matrixV();
    const double first = svd.singularValues()[0], second = svd.singularValues()[1],
                 norm = std::hypot(first, second);
    corner << first / norm, 0, 0, second / norm;
}

bool FundamentalParameterization::hasFullRank() const
{
    return std::abs(corner.determinant()) > RANK_ONE;
}

bool FundamentalParameterization::wellConditioned() const
{
    return std::abs(corner.determinant()) > LEAST_RATIO;
}

/** Multiplies the corner (a, b; c, d), taken as a quaternion, by the three imaginary units. This
gives three matrices of unit norm that are orthogonal to the corner and to each other. */
void FundamentalParameterization::cornerDirections(Eigen::Matrix2d (&directions)[3]) const
{
    const double a = corner(0, 0), b = corner(0, 1), c = corner(1, 0), d = corner(1, 1);
    directions[0] << -b, a, -d, c;
    directions[1] << -c, d, a, -b;
    directions[2] << -d, -c, b, a;
}

FundamentalParameterization::Basis FundamentalParameterization::tangent() const
{
    RowMajor3 D[DIMENSION];
    Eigen::Matrix2d directions[3];
    cornerDirections(directions);
    for (int k = 0; k < 3; ++k)
        D[k] = U.leftCols<2>() * directions[k] * V.leftCols<2>().transpose();
    for (int k = 0; k < 2; ++k)
    {
        D[3 + k] = U.col(k) * V.col(2).transpose();
        D[5 + k] = U.col(2) * V.col(k).transpose();
    }
    Basis basis;
    for (int k = 0; k < DIMENSION; ++k)
        basis.col(k) = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(D[k].data());
    return basis;
}

/** In the bases U and V, the model plus the step is [I; y^T] C [I, x]: C is the changed corner, C x
the last column and y^T C the last row. The rank is 2, because the last entry is y^T C x. One
reflection makes the null vector (-x, 1) the last column of V, another one makes (-y, 1) the last
column of U. */
FundamentalParameterization FundamentalParameterization::plus(const Step& step) const
{
    FundamentalParameterization result(*this);
    Eigen::Matrix2d directions[3];
    cornerDirections(directions);
    Eigen::Matrix2d C = corner;
    for (int k = 0; k < 3; ++k)
        C += step[k] * directions[k];
    const Eigen::Matrix2d inverse = C.inverse();
    const Eigen::Vector2d x = inverse * step.segment<2>(3),
                          y = inverse.transpose() * step.segment<2>(5);
    const Eigen::Matrix3d left = completion(Eigen::Vector3d(-y[0], -y[1], 1));
    const Eigen::Matrix3d right = completion(Eigen::Vector3d(-x[0], -x[1], 1));
    result.U = U * left;
    result.V = V * right;
    // upper left 2x2 block of (left^T [I; y^T]) C ([I, x] right)
    const Eigen::Matrix2d L = left.topLeftCorner<2, 2>() + y * left.block<1, 2>(2, 0);
    const Eigen::Matrix2d R = right.topLeftCorner<2, 2>() + x * right.block<1, 2>(2, 0);
    result.corner = L.transpose() * C * R;
    result.corner /= result.corner.norm();
    return result;
}

Model FundamentalParameterization::model() const
{
    Matx33d result;
    Eigen::Map<RowMajor3>(result.val) = U.leftCols<2>() * corner * V.leftCols<2>().transpose();
    return result;
}

}  // namespace usacv20
}  // namespace cv
