// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLE_STATISTICS_HPP
#define OPENCV_USACV20_SAMPLE_STATISTICS_HPP

namespace cv {
namespace usacv20 {

/** Probability that a sample of m out of n points contains only inliers.
@param inliers number of inliers among the n points
@param exact true: sampling without replacement, C(inliers, m) / C(n, m); false: (inliers / n)^m */
double goodSampleProbability(double inliers, int n, int m, bool exact = true);
//! Number of samples needed: the smallest k with (1 - p)^k <= failure, where p is the probability
//! that a sample is good, and `logFailure` is the logarithm of the accepted probability `failure`
//! that no sample is good. INT_MAX if k would be larger, or if p is 0.
int samplesNeeded(double p, double logFailure);

/** @brief Probability that a wrong model, computed from m of n points, has at least `inliers`
inliers: P(Binomial(n - m, randomRatio) >= inliers - m) @cite chum2005matching.

The points of the sample are inliers in any case; each other point is an inlier by chance with
probability `randomRatio`. See binomialTail(). */
double chanceOf(int inliers, int n, int m, double randomRatio);

}  // namespace usacv20
}  // namespace cv

#endif
