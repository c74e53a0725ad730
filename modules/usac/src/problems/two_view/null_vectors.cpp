// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/two_view/null_vectors.hpp"

#include <Eigen/Geometry>

namespace cv {
namespace usacv20 {

namespace {

//! The second singular value must be more than 1 / RATIO times the first one, and the third less
//! than 1 / RATIO times the second one.
constexpr double RATIO = 1e3;
//! Each product with the matrix of cofactors divides the error of the vectors by the ratio of the
//! second to the third singular value, at least RATIO. A column of this matrix has an error of at
//! most about 1 / RATIO, so that only rounding errors remain after two steps.
constexpr int STEPS = 2;

}  // namespace

Eigen::Matrix3d completion(const Eigen::Vector3d& n)
{
    Eigen::Vector3d v = n.normalized();
    v[2] += v[2] < 0 ? -1 : 1;
    return Eigen::Matrix3d::Identity() - (2 / v.squaredNorm()) * v * v.transpose();
}

bool completeNullVectors(const Eigen::Matrix3d& M, Eigen::Matrix3d& U, Eigen::Matrix3d& V)
{
    Eigen::Matrix3d cofactors;
    for (int i = 0; i < 3; ++i)
        cofactors.row(i) = M.row((i + 1) % 3).cross(M.row((i + 2) % 3));
    // about the first singular value, the product of the first two, and the product of all three
    const double first = M.norm(), firstTwo = cofactors.norm(),
                 all = std::abs(M.row(0).dot(cofactors.row(0)));
    if (!(RATIO * firstTwo > first * first && RATIO * all * first < firstTwo * firstTwo))
        return false;
    int largest;
    cofactors.colwise().squaredNorm().maxCoeff(&largest);
    cofactors /= firstTwo;
    Eigen::Vector3d left, right = cofactors.transpose() * cofactors.col(largest);
    for (int step = 0; step < STEPS; ++step)
    {
        left = (cofactors * right).normalized();
        right = (cofactors.transpose() * left).normalized();
    }
    U = completion(left);
    V = completion(right);
    return true;
}

}  // namespace usacv20
}  // namespace cv
