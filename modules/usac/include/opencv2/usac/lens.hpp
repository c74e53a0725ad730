// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_LENS_HPP
#define OPENCV_USACV20_LENS_HPP

#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

/** @brief Removes lens distortion: returns the pixels at which the same camera without distortion
would see the points.

Inverts the distortion model of cv::projectPoints to double precision, by Newton's method until
convergence. cv::undistortPoints makes five fixed-point iterations by default, which leave errors of
up to a tenth of a pixel in the image corners of an ordinary lens. The estimation of E and of
absolute poses removes the distortion in the same way as this function.

@param points N points of the original (distorted) image in pixels; any layout and depth that
usacv20::estimateHomography accepts
@param cameraMatrix 3x3 camera matrix, any depth
@param distCoeffs 4, 5, 8, 12 or 14 coefficients as for cv::undistortPoints; empty: none
@return Nx2, CV_64F, pixels; NaN for points that are not finite or are outside the field of view of
the lens, that is, beyond the radius up to which the radial distortion is monotonic.

Raises cv::Exception for points of the wrong shape and for an invalid camera or distortion. */
CV_EXPORTS_W Mat removeDistortion(InputArray points, InputArray cameraMatrix,
                                  InputArray distCoeffs);

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
