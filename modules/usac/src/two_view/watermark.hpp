// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_WATERMARK_HPP
#define OPENCV_USACV20_WATERMARK_HPP

#include "opencv2/usac/two_view_geometry.hpp"

namespace cv {
namespace usacv20 {

/** @brief True if the inliers of a pair come from a watermark: a frame, mark or date at the borders
of both images, whose matches have a common displacement.
@param pair the pair; if the size of an image is missing, the result is false
@param mask inliers of the pair
@param reach displacements of matches within this distance of the median displacement, in pixels,
count as equal */
bool isWatermark(const TwoViewPair& pair, const Mat& mask, double reach);

}  // namespace usacv20
}  // namespace cv

#endif
