// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include <Eigen/LU>
#include "numeric/selection.hpp"
#include "optimization/closest_rotation.hpp"
#include "two_view/pixels.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Maximum number of points from which an area is computed.
constexpr int TELL_AREA = 200;

Eigen::Matrix3d toEigen(const Matx33d& A)
{
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(A.val);
}

Matx33d toMatx(const Eigen::Matrix3d& A)
{
    Matx33d result;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(result.val) = A;
    return result;
}

//! Squared Sampson distance of a match: the squared distance to the nearest match that H maps
//! exactly, to first order, from the Jacobian of the map at the point. `w` is the third component
//! of H times the homogeneous point `from`.
double squaredDistance(const Matx33d& H, const Point2d& from, double w, const Point2d& to)
{
    const double u = (H(0, 0) * from.x + H(0, 1) * from.y + H(0, 2)) / w;
    const double v = (H(1, 0) * from.x + H(1, 1) * from.y + H(1, 2)) / w;
    const double ux = (H(0, 0) - u * H(2, 0)) / w, uy = (H(0, 1) - u * H(2, 1)) / w;
    const double vx = (H(1, 0) - v * H(2, 0)) / w, vy = (H(1, 1) - v * H(2, 1)) / w;
    const double a = 1 + ux * ux + uy * uy, b = ux * vx + uy * vy,
                 c = 1 + vx * vx + vy * vy;  // (a, b; b, c): covariance of (eu, ev) for unit noise
    const double eu = to.x - u, ev = to.y - v;
    return (c * eu * eu - 2 * b * eu * ev + a * ev * ev) / (a * c - b * b);
}

}  // namespace

std::vector<double> sampsonDistances(const Matx33d& F, const Points& points1, const Points& points2)
{
    std::vector<double> result(points1.size());
    for (size_t i = 0; i < points1.size(); ++i)
    {
        const Point2d &p = points1[i], &q = points2[i];
        const double a2 = F(0, 0) * p.x + F(0, 1) * p.y + F(0, 2),
                     b2 = F(1, 0) * p.x + F(1, 1) * p.y + F(1, 2);
        const double a1 = F(0, 0) * q.x + F(1, 0) * q.y + F(2, 0),
                     b1 = F(0, 1) * q.x + F(1, 1) * q.y + F(2, 1);
        const double algebraic = q.x * a2 + q.y * b2 + F(2, 0) * p.x + F(2, 1) * p.y + F(2, 2);
        result[i] = std::abs(algebraic) / std::sqrt(a1 * a1 + b1 * b1 + a2 * a2 + b2 * b2);
    }
    return result;
}

std::vector<double> mapDistances(const Matx33d& H, const Points& points1, const Points& points2)
{
    const size_t count = points1.size();
    std::vector<double> result(count), w(count);
    for (size_t i = 0; i < count; ++i)
        w[i] = H(2, 0) * points1[i].x + H(2, 1) * points1[i].y + H(2, 2);
    for (size_t i = 0; i < count; ++i)
        result[i] = std::sqrt(std::max(squaredDistance(H, points1[i], w[i], points2[i]), 0.));
    std::vector<double> finite;
    std::copy_if(w.begin(), w.end(), std::back_inserter(finite),
                 [](double each) { return std::abs(each) <= DBL_MAX; });
    if (finite.empty())
        return std::vector<double>(count, HUGE_VAL);
    const double side = median(finite.data(), (int)finite.size());
    for (size_t i = 0; i < count; ++i)
        if (!(w[i] * side > 0 && result[i] <= DBL_MAX))
            result[i] = HUGE_VAL;
    return result;
}

double squaredArea(const Points& points)
{
    const size_t step = points.size() / TELL_AREA + 1;
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (size_t i = 0; i < points.size(); i += step, ++n)
    {
        const Point2d p = points[i] - points[0];
        x += p.x;
        y += p.y;
        xx += p.x * p.x;
        xy += p.x * p.y;
        yy += p.y * p.y;
    }
    const double vx = xx / n - x * x / (n * n), vxy = xy / n - x * y / (n * n),
                 vy = yy / n - y * y / (n * n);
    return vx * vy - vxy * vxy;
}

Matx33d essentialOf(const Matx33d& F, const Matx33d& camera1, const Matx33d& camera2)
{
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(toEigen(camera2.t() * F * camera1),
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    return toMatx(svd.matrixU() * Eigen::Vector3d(1, 1, 0).asDiagonal() *
                  svd.matrixV().transpose());
}

Matx33d nearestRotation(const Matx33d& matrix)
{
    return toMatx(ClosestRotation(toEigen(matrix)).rotation);
}

Matx33d fitRotation(const std::vector<Vec3d>& directions1, const std::vector<Vec3d>& directions2)
{
    Matx33d sum = Matx33d::zeros();
    for (size_t i = 0; i < directions1.size(); ++i)
        sum += directions2[i] * directions1[i].t() *
               (1 / (norm(directions1[i]) * norm(directions2[i])));
    return nearestRotation(sum);
}

}  // namespace usacv20
}  // namespace cv
