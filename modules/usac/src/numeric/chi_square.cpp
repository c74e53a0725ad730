// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/chi_square.hpp"
#include "numeric/gamma.hpp"

namespace cv {
namespace usacv20 {

//! Fraction of the inliers whose errors are within the threshold if the standard deviation of their
//! noise is sigma_max (see thresholdInSigmas()), as in @cite barath2019magsac.
constexpr double QUANTILE = 0.99;

double chiSquareDistribution(double x, double degrees)
{
    return lowerGamma(0.5 * degrees, 0.5 * x) / gammaFunction(0.5 * degrees);
}

//! Computes the quantile by bisection, until the bounds are adjacent doubles.
double chiSquareQuantile(double p, double degrees)
{
    CV_Assert(p >= 0 && p < 1 && degrees > 0);
    double low = 0, high = degrees;
    while (chiSquareDistribution(high, degrees) < p)
        high *= 2;
    for (;;)
    {
        const double x = 0.5 * (low + high);
        if (x <= low || x >= high)
            return x;
        (chiSquareDistribution(x, degrees) < p ? low : high) = x;
    }
}

double thresholdInSigmas(int degrees)
{
    static const double SIGMAS[] = {std::sqrt(chiSquareQuantile(QUANTILE, 1)),
                                    std::sqrt(chiSquareQuantile(QUANTILE, 2)),
                                    std::sqrt(chiSquareQuantile(QUANTILE, 3))};
    CV_Assert(degrees >= 1 && degrees <= 3);
    return SIGMAS[degrees - 1];
}

}  // namespace usacv20
}  // namespace cv
