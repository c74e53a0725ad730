// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/essential/cameras.hpp"

namespace cv {
namespace usacv20 {

namespace {

Matx33d readCamera(InputArray array, const char* name)
{
    Mat camera = array.getMat();
    if (camera.rows != 3 || camera.cols != 3 || camera.channels() != 1)
        CV_Error_(Error::StsBadArg, ("%s: a 3x3 matrix is expected, not %dx%d with %d channel(s)", name, camera.rows,
                                     camera.cols, camera.channels()));
    Matx33d K;
    camera.convertTo(Mat(3, 3, CV_64F, K.val), CV_64F);
    const double focalProduct = K(0, 0) * K(1, 1);
    if (!checkRange(Mat(3, 3, CV_64F, K.val)) || K(0, 0) == 0 || K(1, 1) == 0 || K(2, 0) != 0 || K(2, 1) != 0 ||
        !(std::abs(determinant(K)) > 1e-12 * std::abs(focalProduct * K(2, 2))))
        CV_Error_(Error::StsBadArg,
                  ("%s: an invertible matrix with focal lengths and the last row 0 0 1 is expected, fx = %g, "
                   "fy = %g, determinant = %g, last row %g %g %g",
                   name, K(0, 0), K(1, 1), determinant(K), K(2, 0), K(2, 1), K(2, 2)));
    return K * (1 / K(2, 2));  // a multiple is the same camera
}

//! Coefficients as cv::undistortPoints takes them; empty where there is no distortion.
Mat readDistortion(InputArray array, const char* name)
{
    const Mat coefficients = array.getMat();
    if (coefficients.empty())
        return Mat();
    const size_t count = coefficients.total();
    const bool known = count == 4 || count == 5 || count == 8 || count == 12 || count == 14;
    if (!known || (coefficients.rows != 1 && coefficients.cols != 1) || coefficients.channels() != 1)
        CV_Error_(Error::StsBadArg, ("%s: 4, 5, 8, 12 or 14 coefficients are expected, not %dx%d with %d channel(s)",
                                     name, coefficients.rows, coefficients.cols, coefficients.channels()));
    if (!checkRange(coefficients))
        CV_Error_(Error::StsBadArg, ("%s: finite coefficients are expected", name));
    return countNonZero(coefficients) ? coefficients : Mat();
}

/** From pixels to the normalized image plane, in place. cv::undistortPoints knows no skew, so that the camera matrix is
taken off before. */
void undistort(const Matx33d& K, const Mat& distCoeffs, double* x, double* y, int count)
{
    const Matx33d inverse = K.inv();
    for (int i = 0; i < count; ++i)
    {
        const Vec3d p = inverse * Vec3d(x[i], y[i], 1);
        x[i] = p[0] / p[2];
        y[i] = p[1] / p[2];
    }
    if (count == 0 || distCoeffs.empty())
        return;
    std::vector<Point2d> points(count);
    for (int i = 0; i < count; ++i)
        points[i] = Point2d(x[i], y[i]);
    undistortPoints(points, points, Matx33d::eye(), distCoeffs);
    for (int i = 0; i < count; ++i)
    {
        x[i] = points[i].x;
        y[i] = points[i].y;
    }
}

}  // namespace

Cameras::Cameras(InputArray cameraMatrix1, InputArray cameraMatrix2, InputArray distCoeffs1, InputArray distCoeffs2)
    : K1(readCamera(cameraMatrix1, "cameraMatrix1")),
      K2(cameraMatrix2.empty() ? K1 : readCamera(cameraMatrix2, "cameraMatrix2")),
      distortion1(readDistortion(distCoeffs1, "distCoeffs1")), distortion2(readDistortion(distCoeffs2, "distCoeffs2"))
{}

double Cameras::toImagePlane(double* const* columns, int count) const
{
    undistort(K1, distortion1, columns[X1], columns[Y1], count);
    undistort(K2, distortion2, columns[X2], columns[Y2], count);
    return (std::abs(K1(0, 0)) + std::abs(K1(1, 1)) + std::abs(K2(0, 0)) + std::abs(K2(1, 1))) / 4;
}

}  // namespace usacv20
}  // namespace cv
