// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "core/chi_square.hpp"
#include "core/repetitions.hpp"
#include "optimization/noise_scale.hpp"
#include "optimization/significant_scale.hpp"
#include "significance/agreement.hpp"
#include "significance/inlier_noise.hpp"

namespace cv {
namespace usacv20 {

namespace {

// Effects of halving and doubling each constant: doc/constants.md.

//! The smallest threshold is the widest one divided by FINEST: the noise of data without noise.
constexpr int FINEST = 1024;
//! Number of inliers beyond those of a sample that are needed to tell the noise: models of samples
//! fit some wrong matches exactly.
constexpr int BEYOND = 10;
//! Threshold of the rough estimate, in standard deviations of the noise.
constexpr double IN_SIGMAS = 2.2;
//! The mixture needs at least LEAST inliers. It is fitted in STEPS steps to the errors within
//! WINDOW times the first estimate of sigma, in BINS bins of equal width.
constexpr int LEAST = 50, STEPS = 10, BINS = 64;
constexpr double WINDOW = 8;
//! Badly located inliers have TAIL times the noise of the others, and are at most LARGEST_TAIL of
//! all inliers.
constexpr double TAIL = 3, LARGEST_TAIL = 0.5;
//! Fraction of the inliers whose errors do not exceed the threshold @cite hartley2003multiple
//! (table 4.2).
constexpr double WITHIN = 0.95;

double power(double base, int exponent)
{
    return exponent > 1 ? base * power(base, exponent - 1) : base;
}

//! The errors within the window, in units of a first estimate of sigma.
struct Histogram
{
    int members[BINS], size;
    double squares[BINS];  //!< mean squared error of the members

    Histogram(const float* squaredErrors, int count, double unit) : size(0)
    {
        std::fill(members, members + BINS, 0);
        std::fill(squares, squares + BINS, 0.);
        const double scale = 1 / (unit * unit);
        for (int i = 0; i < count; ++i)
        {
            const double square = squaredErrors[i] * scale;
            if (!(square < WINDOW * WINDOW))  // or NaN
                continue;
            const int bin = (int)(std::sqrt(square) * (BINS / WINDOW));
            squares[bin] += square;
            ++members[bin];
            ++size;
        }
        for (int i = 0; i < BINS; ++i)
            squares[i] /= std::max(members[i], 1);
    }
};

//! Inliers, badly located inliers, and wrong matches; see preciseNoise().
class Mixture
{
public:
    Mixture(const Histogram& histogram, int degrees_)
        : degrees(degrees_), variance(1), inliers(0.7), tail(0.1)
    {
        for (int step = 0; step < STEPS; ++step)
            improve(histogram);
    }

    double sigma() const { return std::sqrt(variance); }

    //! The error that a fraction `part` of the inliers of both kinds do not exceed.
    double quantile(double part) const
    {
        double low = 0, high = TAIL * std::sqrt(chiSquareQuantile(part, degrees));
        for (int i = 0; i < 30; ++i)
        {
            const double middle = (low + high) / 2, square = middle * middle;
            const double within = (1 - tail) * chiSquareDistribution(square, degrees) +
                                  tail * chiSquareDistribution(square / (TAIL * TAIL), degrees);
            (within < part ? low : high) = middle;
        }
        return high * sigma();
    }

private:
    //! A step of the EM algorithm.
    void improve(const Histogram& histogram)
    {
        const double core = inliers * (1 - tail) * inlierPeak(variance, degrees),
                     far = inliers * tail * inlierPeak(TAIL * TAIL * variance, degrees),
                     outlier = (1 - inliers) / power(WINDOW, degrees);
        double inCore = 0, inTail = 0, squares = 0;
        for (int i = 0; i < BINS; ++i)
        {
            if (histogram.members[i] == 0)
                continue;
            const double square = histogram.squares[i];
            const double a = core * std::exp(-square / (2 * variance)),
                         b = far * std::exp(-square / (2 * TAIL * TAIL * variance)),
                         weight = histogram.members[i] / (a + b + outlier);
            inCore += a * weight;
            inTail += b * weight;
            squares += (a + b / (TAIL * TAIL)) * weight * square;
        }
        const double both = std::max(inCore + inTail, 1e-9);
        inliers = std::min(std::max(both / histogram.size, 0.01), 0.99);
        tail = std::min(inTail / both, LARGEST_TAIL);
        variance = std::max(squares / (degrees * both), 1e-6);
    }

    const int degrees;
    double variance, inliers, tail;
};

//! The errors of the first points and the scale that stands out from those of wrong matches.
class Errors
{
public:
    Errors(const Context& context, const Model& model, double widest, int most, bool once)
        : scope(context.arena), size(std::min<int>(context.points.size, most)),
          squared(scope.take<float>(size)), degrees(context.points.problem->errorDimension()),
          sampleSize(context.components.minimalSolver->sampleSize())
    {
        const Correspondences& p = context.points;
        const Residual& residual = *context.components.residual;
        residual.squaredErrors(p, model, 0, size, squared);
        float* const memory = scope.take<float>((size_t)WRONG_PARTNERS * size);
        wrong = memory;
        wrongCount = wrongErrors(residual, model, p, size, memory, context.arena);
        unit = 4 * widest / FINEST;  // SignificantScale begins with a quarter of it
        Correspondences narrow = p;
        narrow.threshold = unit;
        chance = p.problem->randomInlierRatio(narrow);
        find();
        if (once && found.sigma > 0 && dropRepeated(p, IN_SIGMAS * found.sigma, context.arena))
            find();
    }

    //! Noise over errors, as the model was fitted to the inliers.
    double correction() const
    {
        return std::sqrt((double)found.inliers / std::max(found.inliers - sampleSize, 1));
    }

    InlierNoise noise(double sigma, double threshold, double widest) const
    {
        if (!(sigma > 0 && sigma <= DBL_MAX) || found.inliers < sampleSize + BEYOND)
            return InlierNoise();
        const InlierNoise result = {
            sigma * correction(),
            std::max(widest / FINEST, std::min(threshold * correction(), widest)),
            (double)found.inliers / std::max(size, 1)};
        return result;
    }

    Arena::Scope scope;
    int size;
    float* const squared;
    const int degrees, sampleSize;
    SignificantScale::Found found;

private:
    void find()
    {
        found = SignificantScale::estimate(squared, size, wrong, wrongCount, unit, chance, degrees,
                                           sampleSize, FINEST / 4);
    }

    //! Of inliers in one place of an array, leaves one: copies of a match have the same error,
    //! which may look like small noise. @return false if there are none
    bool dropRepeated(const Correspondences& p, double threshold, Arena& arena)
    {
        Arena::Scope local(arena);
        uchar *const mask = local.take<uchar>(size), *const repeated = local.take<uchar>(size);
        for (int i = 0; i < size; ++i)
            mask[i] = squared[i] <= threshold * threshold;
        std::fill(repeated, repeated + size, (uchar)0);
        if (markRepeated(p, 0, mask, size, threshold, repeated, arena) == 0)
            return false;
        int kept = 0;
        for (int i = 0; i < size; ++i)
            if (!repeated[i])
                squared[kept++] = squared[i];
        size = kept;
        return true;
    }

    const float* wrong;  //!< squared errors of wrong matches
    int wrongCount;
    double unit;    //!< unit of SignificantScale
    double chance;  //!< probability that a point is within one unit of a wrong model
};

}  // namespace

InlierNoise roughNoise(const Context& context, const Model& model, double widest, int most,
                       bool once)
{
    const Errors errors(context, model, widest, most, once);
    return errors.noise(errors.found.sigma, IN_SIGMAS * errors.found.sigma, widest);
}

InlierNoise preciseNoise(const Context& context, const Model& model, double widest)
{
    const Errors errors(context, model, widest, SignificantScale::MOST, true);
    const double unit = errors.found.sigma;
    if (!(unit > 0) || errors.found.inliers < LEAST)
        return errors.noise(unit, std::sqrt(chiSquareQuantile(WITHIN, errors.degrees)) * unit,
                            widest);
    const Mixture mixture(Histogram(errors.squared, errors.size, unit), errors.degrees);
    return errors.noise(mixture.sigma() * unit, mixture.quantile(WITHIN) * unit, widest);
}

}  // namespace usacv20
}  // namespace cv
