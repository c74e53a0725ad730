// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "solvers/manifold.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace cv {
namespace usacv20 {

namespace {

typedef Eigen::Matrix<double, 3, 3, Eigen::RowMajor> RowMajor3;

Eigen::Matrix3d rotation(const Eigen::Vector3d& w)
{
    const double angle = w.norm();
    if (angle < 1e-300)
        return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, w / angle).toRotationMatrix();
}

} // namespace

Manifold::Manifold(ProblemType problem_, const Model& model) : problem(problem_), angle(CV_PI / 4)
{
    const Eigen::Map<const RowMajor3> M(model.val);
    if (problem == HOMOGRAPHY)
    {
        h = Eigen::Map<const Eigen::Matrix<double, 9, 1> >(model.val).normalized();
        return;
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(Eigen::Matrix3d(M), Eigen::ComputeFullU | Eigen::ComputeFullV);
    U = svd.matrixU();
    V = svd.matrixV();
    if (problem == FUNDAMENTAL)
        angle = std::atan2(svd.singularValues()[1], svd.singularValues()[0]);
}

bool Manifold::hasFullRank() const
{
    if (problem == HOMOGRAPHY)
        return std::abs(determinant(model())) > LEAST_DETERMINANT;
    return problem == ESSENTIAL || std::abs(std::sin(2 * angle)) > 2 * LEAST_RATIO;
}

Manifold::Basis Manifold::tangent() const
{
    Basis basis(9, dimension());
    if (problem == HOMOGRAPHY)
    {
        Eigen::Matrix<double, 9, 1> v;
        const double factor = reflection(v);
        for (int k = 0; k < 8; ++k)
        {
            basis.col(k) = -factor * v[k] * v;
            basis(k, k) += 1;
        }
        return basis;
    }
    const double s1 = std::cos(angle), s2 = std::sin(angle);
    RowMajor3 D[7];
    D[0] = s2 * U.col(2) * V.col(1).transpose();
    D[1] = -s1 * U.col(2) * V.col(0).transpose();
    D[2] = s1 * U.col(1) * V.col(0).transpose() - s2 * U.col(0) * V.col(1).transpose();
    D[3] = s2 * U.col(1) * V.col(2).transpose();
    D[4] = -s1 * U.col(0) * V.col(2).transpose();
    D[5] = s1 * U.col(0) * V.col(1).transpose() - s2 * U.col(1) * V.col(0).transpose();
    D[6] = s1 * U.col(1) * V.col(1).transpose() - s2 * U.col(0) * V.col(0).transpose();
    for (int k = 0; k < dimension(); ++k)
        basis.col(k) = Eigen::Map<const Eigen::Matrix<double, 9, 1> >(D[k].data());
    return basis;
}

Manifold Manifold::moved(const Step& step) const
{
    Manifold result(*this);
    if (problem == HOMOGRAPHY)
    {
        Eigen::Matrix<double, 9, 1> v;
        const double factor = reflection(v);
        const Eigen::Matrix<double, 8, 1> s = step;
        result.h = h - (factor * v.head<8>().dot(s)) * v;
        result.h.head<8>() += s;
        result.h.normalize();
        return result;
    }
    const bool essential = problem == ESSENTIAL;
    result.U = U * rotation(step.head<3>());
    result.V = V * rotation(Eigen::Vector3d(step[3], step[4], essential ? 0 : step[5]));
    result.angle = essential ? angle : angle + step[6];
    return result;
}

Model Manifold::model() const
{
    Model result;
    if (problem == HOMOGRAPHY)
        Eigen::Map<Eigen::Matrix<double, 9, 1> >(result.val) = h;
    else
        Eigen::Map<RowMajor3>(result.val) = std::cos(angle) * U.col(0) * V.col(0).transpose() +
                                            std::sin(angle) * U.col(1) * V.col(1).transpose();
    return result;
}

} // namespace usacv20
} // namespace cv
