// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLE_STATISTICS_HPP
#define OPENCV_USACV20_SAMPLE_STATISTICS_HPP

namespace cv {
namespace usacv20 {

/** Probability that a sample of m out of n points contains only inliers, of which there are
`inliers`. `exact`: without replacement, C(inliers, m) / C(n, m); else (inliers / n)^m. */
double goodSampleProbability(double inliers, int n, int m, bool exact = true);
//! Smallest k with (1 - p)^k <= failure, for logFailure = log(failure); INT_MAX if there is none or
//! it is larger.
int samplesNeeded(double p, double logFailure);

/** @brief Probability that a wrong model, computed from m of n points, has at least this many
inliers: P(Binomial(n - m, randomRatio) >= inliers - m) @cite chum2005matching.

The points of the sample are inliers in any case; each other point is an inlier by chance with
probability `randomRatio`. See binomialTail(). */
double chanceOf(int inliers, int n, int m, double randomRatio);

}  // namespace usacv20
}  // namespace cv

#endif
