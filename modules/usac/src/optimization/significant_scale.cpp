// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "optimization/significant_scale.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The bins of the squared errors, in units of the squared threshold, are [2^e, 1.5 * 2^e) and
//! [1.5 * 2^e, 2^(e+1)) for e = LOWEST, LOWEST + 1, ...; the first bin also has all smaller errors.
constexpr int LOWEST = -4, BINS = 128;
//! Median error within the estimated radius r, in standard deviations of the noise, for one to
//! three degrees of freedom; see the comment of the class SignificantScale. The estimated sigma is
//! inversely proportional to this value.
constexpr double MEDIANS[] = {0.64, 1.15, 1.52};

//! Index of the bin of a squared error, from the exponent and the first bit of the mantissa. The
//! result is #BINS or more if the error is too large for all bins or is NaN.
int binOf(float square)
{
    unsigned bits;
    std::memcpy(&bits, &square, sizeof(bits));
    return std::max((int)(bits >> 22) - 2 * (127 + LOWEST), 0);
}

double endOf(int bin) { return std::ldexp(bin % 2 ? 2. : 1.5, LOWEST + bin / 2); }

//! Exponent of Chernoff's bound, without its sign: n D(k/n, p) if k/n > p, else 0; D is the
//! Kullback-Leibler divergence.
double surprise(double k, double n, double p)
{
    const double q = k / n;
    if (q <= p)
        return 0;
    return n * (q * std::log(q / p) + (q < 1 ? (1 - q) * std::log((1 - q) / (1 - p)) : 0));
}

//! Multiplies the squared errors by `scale` and adds the number of products in each bin to
//! `members`.
void countInBins(const float* squaredErrors, int count, float scale, int* members)
{
    for (int i = 0; i < count; ++i)
    {
        const float square = squaredErrors[i] * scale;
        const int bin = square >= 0 ? binOf(square) : BINS;  // NaN is in no bin
        if (bin < BINS)
            ++members[bin];
    }
}

//! r^degrees for the radius r = sqrt(`square`). This is proportional to the length, area or volume
//! within r (one to three degrees of freedom).
double volumeOf(double square, int degrees)
{
    return degrees == 2 ? square : degrees == 1 ? std::sqrt(square) : square * std::sqrt(square);
}

//! The median error of the points in the bins up to `last`, in thresholds. Within a bin, errors are
//! assumed to be uniformly distributed over the length, area or volume of the bin.
//! @param members number of points in each bin
//! @param within number of points in the bins up to `last`
double medianOf(const int* members, int last, int within, int degrees)
{
    const double half = 0.5 * within;
    int bin = 0, before = 0;
    while (bin < last && before + members[bin] < half)
        before += members[bin++];
    const double part = (half - before) / std::max(members[bin], 1),
                 begin = bin > 0 ? endOf(bin - 1) : 0, end = endOf(bin);
    const double first = volumeOf(begin, degrees),
                 volume = first + part * (volumeOf(end, degrees) - first);
    return degrees == 2 ? std::sqrt(volume) : degrees == 1 ? volume : std::cbrt(volume);
}

}  // namespace

SignificantScale::Found SignificantScale::estimate(const float* squaredErrors, int count,
                                                   const float* wrongErrors, int wrongCount,
                                                   double threshold, double chance, int degrees,
                                                   int sampleSize, double widest)
{
    const int size = std::min<int>(count, MOST);
    int members[BINS] = {0}, wrong[BINS] = {0};
    const float scale = (float)(1 / (threshold * threshold));
    countInBins(squaredErrors, size, scale, members);
    countInBins(wrongErrors, wrongCount, scale, wrong);
    double best = sampleSize * std::log((double)size);
    int found = -1, foundWithin = 0;
    for (int bin = 0, within = 0, wrongWithin = 0; bin < BINS; ++bin)
    {
        within += members[bin];
        wrongWithin += wrong[bin];
        const double p = std::max(chance * volumeOf(endOf(bin), degrees),
                                  (double)wrongWithin / std::max(wrongCount, 1));
        if (p >= 1 || endOf(bin) > widest * widest)
            break;
        const double value = within > sampleSize
                                 ? surprise(within - sampleSize, size - sampleSize, p)
                                 : 0;
        if (value > best)
        {
            best = value;
            found = bin;
            foundWithin = within;
        }
    }
    const double median = found < 0 ? 0 : medianOf(members, found, foundWithin, degrees);
    const Found result = {median / MEDIANS[degrees - 1] * threshold, foundWithin};
    return result;
}

}  // namespace usacv20
}  // namespace cv
