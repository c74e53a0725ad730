// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "core/chi_square.hpp"
#include "optimization/noise_scale.hpp"

namespace cv {
namespace usacv20 {

double NoiseScale::estimate(const float* squaredErrors, int count, double threshold, int degrees)
{
    int members[BINS] = {0}, size = 0;
    double near[BINS] = {0};  // sums of squared errors in units of the threshold, then their means
    const double scale = 1 / (threshold * threshold), limit = REACH * REACH;
    for (int i = 0; i < count && size < MOST; ++i)
    {
        const double square = squaredErrors[i] * scale;
        if (!(square <= limit))  // or NaN
            continue;
        const int bin = std::min((int)(std::sqrt(square) * BINS / REACH), BINS - 1);
        near[bin] += square;
        ++members[bin];
        ++size;
    }
    if (size < LEAST)
        return 1 / thresholdInSigmas(degrees);
    for (int i = 0; i < BINS; ++i)
        near[i] /= std::max(members[i], 1);
    const double outlier = degrees == 1 ? 1. / REACH
                                        : 1 / limit;  // densities; of the square for two degrees of freedom
    double variance = 0.15, part = 0.7;
    for (int step = 0; step < 4; ++step)
    {
        const double peak = degrees == 1 ? std::sqrt(2 / (CV_PI * variance)) : 1 / (2 * variance);
        double sum = 0, squares = 0;
        for (int i = 0; i < BINS; ++i)
        {
            if (members[i] == 0)
                continue;
            const double inlier = part * peak * std::exp(-near[i] / (2 * variance));
            const double weight = members[i] * inlier / (inlier + (1 - part) * outlier);
            sum += weight;
            squares += weight * near[i];
        }
        part = std::min(std::max(sum / size, 0.01), 0.99);
        variance = std::max(squares / (degrees * std::max(sum, 1e-9)), 1e-6);
    }
    const double sigma = std::sqrt(variance);
    return sigma < leastSigma() && hasTail(members, sigma, degrees) ? leastSigma() : sigma;
}

bool NoiseScale::hasTail(const int* members, double sigma, int degrees)
{
    const int first = std::min((int)(4 * sigma * INSIDE) + 1, (int)INSIDE);
    int core = 0, tail = 0, outside = 0;
    for (int i = 0; i < BINS; ++i)
        (i < first ? core : i < INSIDE ? tail : outside) += members[i];
    const double inner = degrees == 1 ? INSIDE - first : INSIDE * INSIDE - first * first;
    const double outer = degrees == 1 ? BINS - INSIDE : BINS * BINS - INSIDE * INSIDE;
    const double expected = outside * inner / outer;
    return tail >
           expected + 2 * std::sqrt(expected) + 0.02 * core;  // two standard deviations, and a fiftieth of the inliers
}

}  // namespace usacv20
}  // namespace cv
