// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/absolute_pose/camera.hpp"
#include "problems/camera_arguments.hpp"

namespace cv {
namespace usacv20 {

namespace {

double meanFocal(const Matx33d& K) { return (std::abs(K(0, 0)) + std::abs(K(1, 1))) / 2; }

Matx33d withoutCenter(const Matx33d& K)
{
    const double f = meanFocal(K);
    return Matx33d(K(0, 0) / f, K(0, 1) / f, 0, K(1, 0) / f, K(1, 1) / f, 0, 0, 0, 1);
}

}  // namespace

PoseCamera::PoseCamera(InputArray cameraMatrix, InputArray distCoeffs)
    : K(readCamera(cameraMatrix, "cameraMatrix")), distortion(readDistortion(distCoeffs, "distCoeffs")),
      matrix(withoutCenter(K)), inverse(matrix.inv()), focal(meanFocal(K)), distorted(!distortion.none())
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
    for (int i = 0; distorted && i < count; ++i)
    {
        const Vec2d seen(inverse(0, 0) * u[i] + inverse(0, 1) * v[i], inverse(1, 0) * u[i] + inverse(1, 1) * v[i]);
        Vec2d point;
        if (!distortion.undistort(seen, point))
            point = Vec2d(NAN, NAN);
        u[i] = matrix(0, 0) * point[0] + matrix(0, 1) * point[1];
        v[i] = matrix(1, 0) * point[0] + matrix(1, 1) * point[1];
    }
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
