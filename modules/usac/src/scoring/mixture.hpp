// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_MIXTURE_HPP
#define OPENCV_USACV20_MIXTURE_HPP

namespace cv {
namespace usacv20 {

/** Logarithm of the density of an inlier without error over that of an outlier, divided by the
degrees of freedom: log(extent / (sqrt(2 pi) sigma)). If this is too low for an inlier at the
threshold (thresholdInSigmas) to be as likely as an outlier, because the threshold is wide and the
points lie close together, the value for which both are equally likely is returned instead. */
double logDensityRatio(double extent, double sigma, int degrees);

/** Maximum-likelihood inlier ratio of `count` points, by expectation maximization. For the first
`near` points, `ratios` are the densities as inliers divided by the densities as outliers; the ratio
of the other points is 0. */
double mixingWeight(const float* ratios, int near, int count);

}  // namespace usacv20
}  // namespace cv

#endif
