// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "input/read_arrays.hpp"
#include "problems/essential/cameras.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Converts pixels to undistorted points of the normalized image plane, in place.
void normalize(const Matx33d& K, const Distortion& distortion, double* x, double* y, int count)
{
    const Matx33d inverse = K.inv();
    for (int i = 0; i < count; ++i)
    {
        const Vec3d p = inverse * Vec3d(x[i], y[i], 1);
        x[i] = p[0] / p[2];
        y[i] = p[1] / p[2];
    }
    distortion.undistort(x, y, count);
}

}  // namespace

double meanFocalLength(const Matx33d& K1, const Matx33d& K2)
{
    const double f1 = (std::abs(K1(0, 0)) + std::abs(K1(1, 1))) / 2,
                 f2 = (std::abs(K2(0, 0)) + std::abs(K2(1, 1))) / 2;
    return 2 * f1 / (1 + f1 / f2);
}

Cameras::Cameras(InputArray cameraMatrix1, InputArray cameraMatrix2, InputArray distCoeffs1,
                 InputArray distCoeffs2)
    : K1(readCamera(cameraMatrix1, "cameraMatrix1")),
      K2(cameraMatrix2.empty() ? K1 : readCamera(cameraMatrix2, "cameraMatrix2")),
      distortion1(readDistortion(distCoeffs1, "distCoeffs1")),
      distortion2(readDistortion(distCoeffs2, "distCoeffs2"))
{}

double Cameras::toImagePlane(double* const* columns, int count) const
{
    normalize(K1, distortion1, columns[X1], columns[Y1], count);
    normalize(K2, distortion2, columns[X2], columns[Y2], count);
    return meanFocalLength(K1, K2);
}

}  // namespace usacv20
}  // namespace cv
