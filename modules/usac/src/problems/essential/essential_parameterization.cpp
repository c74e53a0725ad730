// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/essential/essential_parameterization.hpp"
#include "problems/two_view/null_vectors.hpp"

#include <Eigen/SVD>

namespace cv {
namespace usacv20 {

namespace {

//! The rotation or reflection of the plane that is closest to a 2x2 matrix.
Eigen::Matrix2d closestOrthogonal(const Eigen::Matrix2d& M)
{
    const double side = M.determinant() < 0 ? -1 : 1, cosine = M(0, 0) + side * M(1, 1),
                 sine = M(1, 0) - side * M(0, 1), size = std::hypot(cosine, sine);
    Eigen::Matrix2d result;
    result << cosine, -side * sine, sine, side * cosine;
    return result / size;
}

}  // namespace

EssentialParameterization::EssentialParameterization(const Model& model)
{
    const Eigen::Map<const RowMajor3> M(model.val);
    if (completeNullVectors(M, U, V))
    {
        U.leftCols<2>() = (U.leftCols<2>() *
                           closestOrthogonal(U.leftCols<2>().transpose() * M * V.leftCols<2>()))
                              .eval();
        return;
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(Eigen::Matrix3d(M),
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    U = svd.matrixU();
    V = svd.matrixV();
}

EssentialParameterization::Basis EssentialParameterization::tangent() const
{
    const double s = std::sqrt(0.5);
    RowMajor3 D[DIMENSION];
    D[0] = s * U.col(2) * V.col(1).transpose();
    D[1] = -s * U.col(2) * V.col(0).transpose();
    D[2] = s * (U.col(1) * V.col(0).transpose() - U.col(0) * V.col(1).transpose());
    D[3] = s * U.col(1) * V.col(2).transpose();
    D[4] = -s * U.col(0) * V.col(2).transpose();
    Basis basis;
    for (int k = 0; k < DIMENSION; ++k)
        basis.col(k) = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(D[k].data());
    return basis;
}

EssentialParameterization EssentialParameterization::plus(const Step& step) const
{
    EssentialParameterization result(*this);
    result.U = U * rotationOf(step.head<3>());
    result.V = V * rotationOf(Eigen::Vector3d(step[3], step[4], 0));
    return result;
}

Model EssentialParameterization::model() const
{
    const Eigen::Matrix2d corner = Eigen::Matrix2d::Identity() * std::sqrt(0.5);
    Matx33d result;
    Eigen::Map<RowMajor3>(result.val) = U.leftCols<2>() * corner * V.leftCols<2>().transpose();
    return result;
}

}  // namespace usacv20
}  // namespace cv
