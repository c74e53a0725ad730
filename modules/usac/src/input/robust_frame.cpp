// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/instruction_set.hpp"
#include "numeric/selection.hpp"
#include "input/robust_frame.hpp"

namespace cv {
namespace usacv20 {

namespace {

// Limits for extreme input.

//! The median deviation of the first SAMPLE values is compared with the mean deviation of all
//! values.
constexpr int SAMPLE = 31;
//! A value that is more than FAR_OUT mean deviations from the mean dominates the mean. A mean
//! deviation above SPOILT times the median deviation of the first SAMPLE values is caused by values
//! far out. In both cases medians are used instead of means.
constexpr double FAR_OUT = 20, SPOILT = 100;

//! Computes the median of the values (`center`) and the median of the nonzero distances of the
//! values from `center` (`deviation`, 0 if all values are equal).
void medianFrame(const double* values, int count, double& center, double& deviation, Arena& arena)
{
    Arena::Scope scope(arena);
    double* const copy = scope.take<double>(count);
    std::copy(values, values + count, copy);
    center = median(copy, count);
    int others = 0;
    for (int i = 0; i < count; ++i)
        if (values[i] != center)
            copy[others++] = std::abs(values[i] - center);
    deviation = others > 0 ? median(copy, others) : 0;
}

//! Number of partial sums and of partial extremes, which compilers compute in one vector register.
constexpr int LANES = 4;

double sumOf(const double* lanes) { return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]); }

double meanAndExtremes(const double* values, int count, double& lowest, double& highest)
{
    const double part = 1. / count;  // factor of each value, because the plain sum can overflow
    double sums[LANES] = {0}, low[LANES], high[LANES];
    std::fill(low, low + LANES, values[0]);
    std::fill(high, high + LANES, values[0]);
    const int whole = count - count % LANES;
    for (int i = 0; i < whole; i += LANES)
    {
        USAC_SIMD
        for (int k = 0; k < LANES; ++k)
        {
            const double value = values[i + k];
            sums[k] += value * part;
            low[k] = value < low[k] ? value : low[k];
            high[k] = value > high[k] ? value : high[k];
        }
    }
    for (int i = whole; i < count; ++i)
    {
        sums[0] += values[i] * part;
        low[0] = std::min(low[0], values[i]);
        high[0] = std::max(high[0], values[i]);
    }
    lowest = *std::min_element(low, low + LANES);
    highest = *std::max_element(high, high + LANES);
    return sumOf(sums);
}

double meanDistance(const double* values, int count, double center)
{
    const double part = 1. / count;
    double sums[LANES] = {0};
    const int whole = count - count % LANES;
    for (int i = 0; i < whole; i += LANES)
    {
        USAC_SIMD
        for (int k = 0; k < LANES; ++k)
            sums[k] += std::abs(values[i + k] - center) * part;
    }
    for (int i = whole; i < count; ++i)
        sums[0] += std::abs(values[i] - center) * part;
    return sumOf(sums);
}

}  // namespace

void robustFrame(const double* values, int count, double& center, double& deviation, double& low,
                 double& high, Arena& arena)
{
    center = deviation = low = high = 0;
    if (count == 0)
        return;
    center = meanAndExtremes(values, count, low, high);
    deviation = meanDistance(values, count, center);
    double sampleCenter, sampleDeviation;
    medianFrame(values, std::min<int>(count, SAMPLE), sampleCenter, sampleDeviation, arena);
    const double largest = std::max(high - center, center - low);
    if (!(largest <= FAR_OUT * deviation) ||
        (sampleDeviation > 0 && deviation > SPOILT * sampleDeviation))
        medianFrame(values, count, center, deviation, arena);
}

}  // namespace usacv20
}  // namespace cv
