// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CONFIRMED_ORDER_HPP
#define OPENCV_USACV20_CONFIRMED_ORDER_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Measures whether the inliers of a model come early in an order: the Mann-Whitney rank-sum
statistic of the inliers and the outliers, minus its mean over random orders, divided by its
standard deviation. The result is positive if the inliers come early, and 0 if there are no inliers
that count or no outliers.

The first m inliers do not count, because the model might have been computed from them. Inliers that
repeat an earlier inlier do not count either.
@param inliers marks the inliers among the `size` points, best point first
@param repeated marks inliers that repeat an earlier inlier
@param size number of points
@param m size of a sample */
double orderEvidence(const uchar* inliers, const uchar* repeated, int size, int m);

}  // namespace usacv20
}  // namespace cv

#endif
