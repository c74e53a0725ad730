// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/absolute_pose/camera.hpp"
#include "input/read_arrays.hpp"

namespace cv {
namespace usacv20 {

namespace {

double meanFocal(const Matx33d& K) { return (std::abs(K(0, 0)) + std::abs(K(1, 1))) / 2; }

//! Applies the upper left 2x2 block of M to each point, in place.
void map(const Matx33d& M, double* u, double* v, int count)
{
    for (int i = 0; i < count; ++i)
    {
        const Vec2d p(u[i], v[i]);
        u[i] = M(0, 0) * p[0] + M(0, 1) * p[1];
        v[i] = M(1, 0) * p[0] + M(1, 1) * p[1];
    }
}

Matx33d withoutCenter(const Matx33d& K)
{
    const double f = meanFocal(K);
    return Matx33d(K(0, 0) / f, K(0, 1) / f, 0, K(1, 0) / f, K(1, 1) / f, 0, 0, 0, 1);
}

}  // namespace

PoseCamera::PoseCamera(InputArray cameraMatrix, InputArray distCoeffs)
    : K(readCamera(cameraMatrix, "cameraMatrix1")),
      distortion(readDistortion(distCoeffs, "distCoeffs1")), matrix(withoutCenter(K)),
      inverse(matrix.inv()), focal(meanFocal(K)), distorted(!distortion.none())
{}

void PoseCamera::toSearchUnits(double* u, double* v, int count) const
{
    for (int i = 0; i < count; ++i)
    {
        u[i] = (u[i] - K(0, 2)) / focal;
        v[i] = (v[i] - K(1, 2)) / focal;
    }
}

void PoseCamera::toSearch(double* u, double* v, int count) const
{
    toSearchUnits(u, v, count);
    if (!distorted)
        return;
    map(inverse, u, v, count);
    distortion.undistort(u, v, count);
    map(matrix, u, v, count);
}

bool PoseCamera::see(const Vec2d& point, Vec2d& seen, Matx22d* derivative) const
{
    Vec2d moved;
    if (!distortion.distort(point, moved, derivative))
        return false;
    const Matx22d linear(matrix(0, 0), matrix(0, 1), matrix(1, 0), matrix(1, 1));
    seen = linear * moved;
    if (derivative)
        *derivative = linear * *derivative;
    return true;
}

}  // namespace usacv20
}  // namespace cv
