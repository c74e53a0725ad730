// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_MIXTURE_HPP
#define OPENCV_USACV20_MIXTURE_HPP

namespace cv {
namespace usacv20 {

/** Logarithm of the ratio of two densities, divided by the degrees of freedom: the density of an
inlier at an error of 0 and that of an outlier. It is log(extent / (sqrt(2 pi) sigma)). If the
threshold is wide and the points lie close together, an inlier with an error equal to the threshold
(sigma times thresholdInSigmas()) would be less likely than an outlier. Then the value for which
both are equally likely is returned instead.
@param extent side of the cube in which errors of outliers are uniform, see Problem::outlierExtent
@param sigma standard deviation of the noise, in the same unit
@param degrees degrees of freedom of the error */
double logDensityRatio(double extent, double sigma, int degrees);

/** Maximum-likelihood inlier ratio of `count` points, by expectation maximization. `ratios` has,
for each of the first `near` points, the density of its error as an inlier divided by the density as
an outlier; for the other points this ratio is 0. */
double mixingWeight(const float* ratios, int near, int count);

}  // namespace usacv20
}  // namespace cv

#endif
