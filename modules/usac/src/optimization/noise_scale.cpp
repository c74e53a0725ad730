// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/chi_square.hpp"
#include "optimization/error_mixture.hpp"
#include "optimization/noise_scale.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The EM algorithm starts with this variance (in squared thresholds) and this inlier ratio, and
//! takes STEPS steps. Halving any one of the three constants raises the errors of estimated H by 3
//! to 8 % on the scenes of doc/structured.md, and changes them by at most 1 % on real image pairs.
constexpr double FIRST_VARIANCE = 0.15, FIRST_PART = 0.7;
constexpr int STEPS = 4;
//! The tail consists of the errors from CORE standard deviations of the noise up to the threshold.
//! The tail is significant if it has more errors than the expected number of outliers in the tail,
//! plus DEVIATIONS standard deviations of this number, plus PART_OF_CORE times the number of
//! smaller errors. Halving or doubling any one of the three constants changes the errors of models
//! on real image pairs by at most 1 %.
constexpr double CORE = 4, DEVIATIONS = 2, PART_OF_CORE = 0.02;

}  // namespace

double NoiseScale::estimate(const float* squaredErrors, int count, double threshold, int degrees)
{
    const ErrorHistogram errors(squaredErrors, count, threshold, REACH, MOST);
    if (errors.size < LEAST)
        return 1 / thresholdInSigmas(degrees);
    ErrorMixture mixture(degrees, FIRST_VARIANCE, FIRST_PART, 0);
    mixture.fit(errors, STEPS);
    const double sigma = mixture.sigma();
    return sigma < leastSigma() && hasTail(errors.members, sigma, degrees) ? leastSigma() : sigma;
}

bool NoiseScale::hasTail(const int* members, double sigma, int degrees)
{
    const int first = std::min((int)(CORE * sigma * (int)INSIDE) + 1, (int)INSIDE);
    int core = 0, tail = 0, outside = 0;
    for (int i = 0; i < BINS; ++i)
        (i < first ? core : i < INSIDE ? tail : outside) += members[i];
    const double inner = power(INSIDE, degrees) - power(first, degrees);
    const double outer = power(BINS, degrees) - power(INSIDE, degrees);
    const double expected = outside * inner / outer;
    return tail > expected + DEVIATIONS * std::sqrt(expected) + PART_OF_CORE * core;
}

}  // namespace usacv20
}  // namespace cv
