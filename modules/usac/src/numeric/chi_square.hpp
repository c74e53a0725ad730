// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CHI_SQUARE_HPP
#define OPENCV_USACV20_CHI_SQUARE_HPP

#include "opencv2/usac/params.hpp"

namespace cv {
namespace usacv20 {

/** Probability that the squared error of an inlier, in units of the variance, is at most x.
@param x squared error divided by the variance
@param degrees degrees of freedom of the error, any positive number; in Satterthwaite's
approximation of a sum of squares with different variances, it is not an integer */
double chiSquareDistribution(double x, double degrees);
//! The x for which chiSquareDistribution(x, degrees) is p; 0 <= p < 1.
double chiSquareQuantile(double p, double degrees);

/** The threshold divided by the largest standard deviation of the noise, sigma_max: the square root
of the 0.99 quantile of the chi-square distribution with `degrees` (1 to 3) degrees of freedom, as
in @cite barath2019magsac. The search threshold thus defines sigma_max, and losses that are
marginalized over noise levels up to sigma_max are constant beyond the threshold. */
double thresholdInSigmas(int degrees);

}  // namespace usacv20
}  // namespace cv

#endif
