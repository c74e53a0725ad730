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

/** @brief Where the same camera would see points if its lens had no distortion.

The inverse of cv::projectPoints to double precision, by Newton's method to the end;
cv::undistortPoints takes five steps of another one by default, and is up to a tenth of a pixel off
in the corners of an ordinary lens. Estimation removes the distortion of E and of absolute poses in
the same way.

@param points N points of the image as it was taken, pixels; any layout and depth that
usacv20::estimateHomography takes
@param cameraMatrix 3x3, any depth
@param distCoeffs 4, 5, 8, 12 or 14 coefficients as for cv::undistortPoints; empty: none
@return Nx2, CV_64F, pixels; NaN where the lens shows nothing: beyond the radius at which the radial
terms fold the plane back upon itself, and for points that are not finite.

Raises cv::Exception for points of a wrong shape and for what is no camera.
*/
CV_EXPORTS_W Mat removeDistortion(InputArray points, InputArray cameraMatrix,
                                  InputArray distCoeffs);

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
