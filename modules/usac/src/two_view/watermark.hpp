// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_WATERMARK_HPP
#define OPENCV_USACV20_WATERMARK_HPP

#include "opencv2/usac/two_view_geometry.hpp"

namespace cv {
namespace usacv20 {

/** @brief Do the inliers of a pair come from a watermark: a frame, mark or date that stays at its
place in the image for any view?
@param pair the pair; false without the sizes of both images
@param mask inliers of the pair
@param reach motions within this many pixels of the median motion count as equal */
bool isWatermark(const TwoViewPair& pair, const Mat& mask, double reach);

}  // namespace usacv20
}  // namespace cv

#endif
