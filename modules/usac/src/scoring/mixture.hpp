// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_MIXTURE_HPP
#define OPENCV_USACV20_MIXTURE_HPP

namespace cv {
namespace usacv20 {

/** Log of how much more likely an inlier without error is than an outlier, divided by the degrees
of freedom: log(extent / (sqrt(2 pi) sigma)). Not less than what makes both equally likely at the
threshold, thresholdInSigmas: wide thresholds on points that hardly differ would ask for more. */
double logDensityRatio(double extent, double sigma, int degrees);

/** The part of inliers among `count` points that makes them most likely, by expectation and
maximization. The density as an inlier of the first `near` points is `ratios` times that as an
outlier; that of the others is 0. */
double mixingWeight(const float* ratios, int near, int count);

}  // namespace usacv20
}  // namespace cv

#endif
