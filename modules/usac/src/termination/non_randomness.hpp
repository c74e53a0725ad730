// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NON_RANDOMNESS_HPP
#define OPENCV_USACV20_NON_RANDOMNESS_HPP

namespace cv {
namespace usacv20 {

/** @brief Probability that a wrong model of m of n points has this many inliers: P(Binomial(n - m,
randomRatio) >= inliers - m) @cite chum2005matching.

The points of the sample are inliers in any case; each other one is, by chance, with probability
`randomRatio`. Exact sum: the first term in the form of @cite loader2000fast, which cancels nothing,
the others by their ratios, from the side of the distribution where they decrease. 0 where the
probability is smaller than a double can be. At most O(n) time, mostly O(sqrt(n)). */
double chanceOf(int inliers, int n, int m, double randomRatio);

}  // namespace usacv20
}  // namespace cv

#endif
