// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/unit_norm.hpp"
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include "problems/essential/motions.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The camera has translated if the singular values of the homography of a plane, divided by the
//! middle one, differ by more than this value. Otherwise the camera has only rotated. Rounding
//! causes differences of 1e-15, and an error of a hundredth of a pixel causes differences of 1e-5.
constexpr double TURNED = 1e-9;

Matx33d toMatx(const Eigen::Matrix3d& A)
{
    Matx33d result;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            result(r, c) = A(r, c);
    return result;
}

Eigen::Matrix3d toEigen(const Matx33d& A)
{
    Eigen::Matrix3d result;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            result(r, c) = A(r, c);
    return result;
}

}  // namespace

Matx33d Motion::essential() const
{
    const Matx33d cross(0, -t[2], t[1], t[2], 0, -t[0], -t[1], t[0], 0);
    return ofUnitNorm(cross * R);
}

void motionsOf(const Matx33d& E, Motion motions[4])
{
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(toEigen(E),
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d U = svd.matrixU(), V = svd.matrixV(), W;
    W << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    if (U.determinant() < 0)
        U.col(2) *= -1;
    if (V.determinant() < 0)
        V.col(2) *= -1;
    const Vec3d t(U(0, 2), U(1, 2), U(2, 2));
    for (int k = 0; k < 4; ++k)
    {
        const Eigen::Matrix3d turn = k < 2 ? W : Eigen::Matrix3d(W.transpose());
        motions[k].R = toMatx(U * turn * V.transpose());
        motions[k].t = k % 2 ? -t : t;
    }
}

/* Let H = R + t n^T have the singular values s1 >= 1 >= s3. H maps the plane spanned by the second
right singular vector v2 and by u = (sqrt(1 - s3^2) v1 +- sqrt(s1^2 - 1) v3) / sqrt(s1^2 - s3^2)
without changing lengths. On this plane H equals R, and n is a normal of this plane. */
bool motionsOfPlane(const Matx33d& given, const Vec3d& x, Motion motions[2])
{
    Eigen::Matrix3d H = toEigen(given);
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(H, Eigen::ComputeFullV);
    const Eigen::Vector3d s = svd.singularValues() / svd.singularValues()[1];
    if (!(svd.singularValues()[2] > 0) || !(s[0] - s[2] > TURNED))
        return false;
    H /= svd.singularValues()[1] * (H.determinant() < 0 ? -1 : 1);
    const Eigen::Vector3d v1 = svd.matrixV().col(0), v2 = svd.matrixV().col(1),
                          v3 = svd.matrixV().col(2);
    const double a = std::sqrt(std::max(1 - s[2] * s[2], 0.)),
                 b = std::sqrt(std::max(s[0] * s[0] - 1, 0.));
    for (int k = 0; k < 2; ++k)
    {
        const Eigen::Vector3d u = (a * v1 + (k ? -b : b) * v3) / std::sqrt(a * a + b * b);
        Eigen::Matrix3d from, to;
        from << v2, u, v2.cross(u);
        const Eigen::Vector3d second = H * v2, third = H * u;
        to << second, third, second.cross(third);
        const Eigen::Matrix3d R = to * from.transpose();
        Eigen::Vector3d n = v2.cross(u);
        if (n.dot(Eigen::Vector3d(x[0], x[1], x[2])) < 0)
            n = -n;
        const Eigen::Vector3d t = ((H - R) * n).normalized();
        motions[k].R = toMatx(R);
        motions[k].t = Vec3d(t[0], t[1], t[2]);
    }
    return true;
}

/* d2 x2 = d1 R x1 + t with the depths d1 and d2: the cross products with x2 and with R x1 eliminate
one depth each. */
bool inFront(const Motion& motion, const Vec3d& x1, const Vec3d& x2, double threshold)
{
    const Vec3d turned = motion.R * x1, normal = turned.cross(x2);
    if (normal.dot(x2.cross(motion.t)) > 0 && normal.dot(turned.cross(motion.t)) > 0)
        return true;
    const double dx = turned[0] / turned[2] - x2[0] / x2[2],
                 dy = turned[1] / turned[2] - x2[1] / x2[2];
    return turned[2] > 0 && dx * dx + dy * dy <= threshold * threshold;
}

}  // namespace usacv20
}  // namespace cv
