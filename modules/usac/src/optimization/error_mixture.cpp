// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/chi_square.hpp"
#include "optimization/error_mixture.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The noise of inliers in the tail has TAIL times the standard deviation of the noise of the other
//! inliers. At most the fraction LARGEST_TAIL of all inliers are in the tail.
constexpr double TAIL = 3, LARGEST_TAIL = 0.5;
//! Number of halvings of the interval that contains a quantile. Before the first halving, the
//! interval is no longer than the quantile itself or, if this is more, one standard deviation. The
//! error of the result is at most 2^-20 of this length.
constexpr int BISECTIONS = 20;
//! Number of errors whose bins are computed together, in a loop that compilers vectorize.
constexpr int BLOCK = 64;

}  // namespace

double inlierPeak(double variance, int degrees)
{
    if (degrees == 2)
        return 1 / (2 * variance);
    const double one = std::sqrt(2 / (CV_PI * variance));
    return degrees == 1 ? one : one / (3 * variance);
}

ErrorHistogram::ErrorHistogram(const float* squaredErrors, int count, double unit, int window_,
                               int most)
    : size(0), window(window_)
{
    std::fill(members, members + BINS, 0);
    std::fill(squares, squares + BINS, 0.);
    const double scale = 1 / (unit * unit), limit = window * window,
                 binsOfUnit = (double)BINS / window;
    for (int first = 0; first < count && size < most; first += BLOCK)
    {
        const int here = std::min<int>(count - first, BLOCK);
        int bins[BLOCK], used = 0;
        double values[BLOCK];
        for (int k = 0; k < here; ++k)
        {
            const double square = squaredErrors[first + k] * scale;
            const bool within = square <= limit;  // false for NaN
            values[k] = within ? square : -1;
            bins[k] = (int)(std::sqrt(within ? square : 0.) * binsOfUnit);
        }
        for (int k = 0; k < here; ++k)  // without branches, which would often be mispredicted
        {
            values[used] = values[k];
            bins[used] = bins[k];
            used += values[k] >= 0;
        }
        used = std::min(used, most - size);
        for (int k = 0; k < used; ++k)
        {
            const int bin = std::min<int>(bins[k], BINS - 1);
            squares[bin] += values[k];
            ++members[bin];
        }
        size += used;
    }
    for (int i = 0; i < BINS; ++i)
        squares[i] /= std::max(members[i], 1);
}

void ErrorMixture::fit(const ErrorHistogram& errors, int steps)
{
    for (int step = 0; step < steps; ++step)
        improve(errors);
}

void ErrorMixture::improve(const ErrorHistogram& errors)
{
    const double wide = TAIL * TAIL * variance,
                 wrong = (1 - inliers) * (1. / power(errors.window, degrees)),
                 core = inliers * (1 - tail) * inlierPeak(variance, degrees),
                 far = inliers * tail * inlierPeak(wide, degrees);
    double inCore = 0, inTail = 0, sum = 0;
    for (int i = 0; i < ErrorHistogram::BINS; ++i)
    {
        const double members = errors.members[i], square = errors.squares[i];
        if (members == 0)
            continue;
        const double a = core * std::exp(-square / (2 * variance)),
                     b = tail > 0 ? far * std::exp(-square / (2 * wide)) : 0, all = a + b + wrong;
        const double each = members / all, wa = each * a, wb = each * b;
        inCore += wa;
        inTail += wb;
        sum += (wa + wb / (TAIL * TAIL)) * square;
    }
    const double both = std::max(inCore + inTail, 1e-9);
    inliers = std::min(std::max(both / errors.size, 0.01), 0.99);
    tail = std::min(inTail / both, LARGEST_TAIL);
    variance = std::max(sum / (degrees * both), 1e-6);
}

double ErrorMixture::sigma() const { return std::sqrt(variance); }

double ErrorMixture::quantile(double part) const
{
    const auto within = [&](double radius) {
        const double square = radius * radius;
        return (1 - tail) * chiSquareDistribution(square, degrees) +
               tail * chiSquareDistribution(square / (TAIL * TAIL), degrees);
    };
    double low = 0, high = 1;  // in standard deviations
    for (; within(high) < part; high *= 2)
        low = high;
    for (int i = 0; i < BISECTIONS; ++i)
    {
        const double middle = (low + high) / 2;
        (within(middle) < part ? low : high) = middle;
    }
    return high * sigma();
}

}  // namespace usacv20
}  // namespace cv
