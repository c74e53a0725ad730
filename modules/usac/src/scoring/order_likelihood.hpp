// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ORDER_LIKELIHOOD_HPP
#define OPENCV_USACV20_ORDER_LIKELIHOOD_HPP

#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

/** @brief By how much does the order of the points explain which of them are inliers?

Logarithm of the ratio of two likelihoods of the inlier flags: with a probability of being an inlier
that does not increase along the order, fitted by isotonic regression @cite barlow1972statistical;
and with the same probability for all points. If the order is random, it is about log(size) / 2, or
less; if the inliers come late, 0.
@param inliers flags, best point first @param size their number
@param blocks room for 2 * size numbers
@return the logarithm, in nats, at least 0 */
double orderLogLikelihood(const uchar* inliers, int size, int* blocks);

}  // namespace usacv20
}  // namespace cv

#endif
