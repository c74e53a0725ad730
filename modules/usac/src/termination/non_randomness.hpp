// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NON_RANDOMNESS_HPP
#define OPENCV_USACV20_NON_RANDOMNESS_HPP

namespace cv {
namespace usacv20 {

/** @brief Probability that a wrong model, computed from m of n points, has at least this many
inliers: P(Binomial(n - m, randomRatio) >= inliers - m) @cite chum2005matching.

The points of the sample are inliers in any case; each other point is an inlier by chance with
probability `randomRatio`. See binomialTail(). */
double chanceOf(int inliers, int n, int m, double randomRatio);

}  // namespace usacv20
}  // namespace cv

#endif
