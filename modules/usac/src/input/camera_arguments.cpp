// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "input/camera_arguments.hpp"

namespace cv {
namespace usacv20 {

Matx33d readCamera(InputArray array, const char* name)
{
    Mat camera = array.getMat();
    if (camera.rows != 3 || camera.cols != 3 || camera.channels() != 1)
        CV_Error_(Error::StsBadArg, ("%s: a 3x3 matrix is expected, not %dx%d with %d channel(s)",
                                     name, camera.rows, camera.cols, camera.channels()));
    Matx33d K;
    camera.convertTo(Mat(3, 3, CV_64F, K.val), CV_64F);
    const double focalProduct = K(0, 0) * K(1, 1);
    if (!checkRange(Mat(3, 3, CV_64F, K.val)) || K(0, 0) == 0 || K(1, 1) == 0 || K(2, 0) != 0 ||
        K(2, 1) != 0 || !(std::abs(determinant(K)) > 1e-12 * std::abs(focalProduct * K(2, 2))))
        CV_Error_(Error::StsBadArg,
                  ("%s: an invertible matrix with focal lengths other than 0, last row 0 0 1, is "
                   "expected, fx = %g, "
                   "fy = %g, determinant = %g, last row %g %g %g",
                   name, K(0, 0), K(1, 1), determinant(K), K(2, 0), K(2, 1), K(2, 2)));
    return K * (1 / K(2, 2));  // a multiple of K describes the same camera
}

Mat readDistortion(InputArray array, const char* name)
{
    const Mat coefficients = array.getMat();
    if (coefficients.empty())
        return Mat();
    const size_t count = coefficients.total();
    const bool known = count == 4 || count == 5 || count == 8 || count == 12 || count == 14;
    if (!known || (coefficients.rows != 1 && coefficients.cols != 1) ||
        coefficients.channels() != 1)
        CV_Error_(Error::StsBadArg,
                  ("%s: 4, 5, 8, 12 or 14 coefficients are expected, not %dx%d with %d channel(s)",
                   name, coefficients.rows, coefficients.cols, coefficients.channels()));
    if (!checkRange(coefficients))
        CV_Error_(Error::StsBadArg, ("%s: finite coefficients are expected", name));
    return countNonZero(coefficients) ? coefficients : Mat();
}

}  // namespace usacv20
}  // namespace cv
