// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "input/read_arrays.hpp"
#include "problems/distortion.hpp"

namespace cv {
namespace usacv20 {

Mat removeDistortion(InputArray points, InputArray cameraMatrix, InputArray distCoeffs)
{
    const Matx33d K = readCamera(cameraMatrix, "cameraMatrix"), inverse = K.inv();
    const Distortion distortion(readDistortion(distCoeffs, "distCoeffs"));
    Arena arena;
    Arena::Scope scope(arena);
    Mat result = readPoints(points.getMat(), 2, "points", scope).clone();
    for (int i = 0; i < result.rows; ++i)
    {
        double* const pixel = result.ptr<double>(i);
        Vec2d point(NAN, NAN);
        const Vec3d seen = inverse * Vec3d(pixel[0], pixel[1], 1);
        const bool any = distortion.undistort(Vec2d(seen[0], seen[1]), point);
        const Vec3d ideal = K * Vec3d(point[0], point[1], 1);
        const bool finite = any && std::abs(ideal[0]) <= DBL_MAX &&
                            std::abs(ideal[1]) <= DBL_MAX;  // a NaN makes this false
        pixel[0] = finite ? ideal[0] : NAN;
        pixel[1] = finite ? ideal[1] : NAN;
    }
    return result;
}

}  // namespace usacv20
}  // namespace cv
