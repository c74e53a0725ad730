// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/chi_square.hpp"
#include "scoring/mixture.hpp"

namespace cv {
namespace usacv20 {

//! Expectation maximization takes at most MAX_ITERATIONS steps. It ends earlier if a step changes
//! the inlier ratio by less than SETTLED.
constexpr int MAX_ITERATIONS = 50;
constexpr double SETTLED = 1e-4;

double logDensityRatio(double extent, double sigma, int degrees)
{
    const double k = thresholdInSigmas(degrees), least = 0.5 * k * k / degrees;
    return std::max(std::log(extent / (std::sqrt(2 * CV_PI) * sigma)), least);
}

double mixingWeight(const float* ratios, int near, int count)
{
    double weight = 0.5;
    for (int k = 0; k < MAX_ITERATIONS; ++k)
    {
        double expected = 0;
        for (int i = 0; i < near; ++i)
            expected += weight * ratios[i] / (1 + weight * (ratios[i] - 1));
        const double change = expected / count - weight;
        weight += change;
        if (std::abs(change) < SETTLED)
            break;
    }
    return std::min(weight, 1.0);
}

}  // namespace usacv20
}  // namespace cv
