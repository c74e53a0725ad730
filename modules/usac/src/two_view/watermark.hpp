// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_WATERMARK_HPP
#define OPENCV_USACV20_WATERMARK_HPP

#include "opencv2/usac/two_view_geometry.hpp"

namespace cv {
namespace usacv20 {

/** @brief A picture's frame, mark or date stays where it is in the image, whatever the camera sees.
@param pair with the sizes of both images, else it has none
@param mask its inliers
@param reach pixels; motions that differ by less are one and the same */
bool isWatermark(const TwoViewPair& pair, const Mat& mask, double reach);

}  // namespace usacv20
}  // namespace cv

#endif
