// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CONFIRMED_ORDER_HPP
#define OPENCV_USACV20_CONFIRMED_ORDER_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Do the inliers of a model come early in an order? Their rank sum against that of the other points (Mann,
Whitney), in standard deviations of what it is in an order that tells nothing.

The first m inliers do not count, as the model may have been made of them, nor do repeated ones.
@param inliers which of the `size` points are inliers, best point first
@param repeated which of them repeat an earlier one
@param size number of points
@param m size of a sample */
double orderEvidence(const uchar* inliers, const uchar* repeated, int size, int m);

}  // namespace usacv20
}  // namespace cv

#endif
