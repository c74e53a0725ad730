// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ORDER_LIKELIHOOD_HPP
#define OPENCV_USACV20_ORDER_LIKELIHOOD_HPP

#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

/** @brief Measures how well the order of the points explains which of them are inliers.

The result is the logarithm of the ratio of two likelihoods of the inlier flags. For the first
likelihood, the probability of being an inlier does not increase along the order; it is fitted by
isotonic regression @cite barlow1972statistical. For the second, this probability is the same for
all points. If the order is random, the result is about log(size) / 2 or less. It is 0 if the
inliers come last.
@param inliers 1 for inliers, 0 for outliers, best point first
@param size number of points
@param blocks temporary memory for 2 * size numbers
@param ends 1 for each point that is the last one of a group of points with equal rank; null: all
ranks are different
@return natural logarithm of the likelihood ratio, at least 0 */
double orderLogLikelihood(const uchar* inliers, int size, int* blocks, const uchar* ends = 0);

}  // namespace usacv20
}  // namespace cv

#endif
