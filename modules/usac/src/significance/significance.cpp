// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "significance/significance.hpp"
#include "numeric/tails.hpp"
#include "components/repetitions.hpp"
#include "control/watch.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The first test has so many points that FIRST_INLIERS inliers outside the sample are expected
//! among them. As long as no test decides, each test has MORE times as many points as the one
//! before. The final tests, of all points, make about PAIRS wrong matches or more, unless there are
//! fewer than 65 points. The inlier probability of a wrong match, estimated from PAIRS wrong
//! matches, has a standard deviation of at most 0.01.
constexpr int FIRST_INLIERS = 14, MORE = 2, PAIRS = 4096;
//! Wider thresholds that are also tried, as multiples of the given threshold.
constexpr double WIDE[] = {4, 16};
//! Work of look() per point, in point tests of 2 ns, the unit of Watch: 90 ns per point if there
//! are a million points. The value only affects when a run with a time limit ends.
constexpr double LOOK_WORK = 45;
//! Maximum number of passes over all points that remain after the tests of some of the points:
//! three calls of look(), and decisive().
constexpr int LOOKS = 4;

//! The number T of trials, see Significance.
double trialsOf(const SearchEffort& effort, int points)
{
    const double m = effort.sampleSize, n = std::max<double>(points, m);
    const double logSamples = logFactorial(n) - logFactorial(m) - logFactorial(n - m);
    const double drawn = std::max(effort.samples, 1.);
    const double models = std::max(effort.models, 1.) * std::min(1., std::exp(logSamples) / drawn);
    const double more = std::max((n - m) / (m + 1), 1.),
                 optimized = effort.countsInliers ? more : std::sqrt(more);
    return std::max(models, 1.) * optimized * (effort.ownThreshold ? std::max(n - m, 1.) : 1.);
}

}  // namespace

const double Significance::MAIN_SHARE = 0.8, Significance::WIDE_SHARE = 0.1;

Significance::Significance(const Residual& residual_, const Model& model_,
                           const Correspondences& points_, double threshold_,
                           const SearchEffort& effort, Arena& arena_, const Context* context_)
    : residual(residual_), model(model_), points(points_), threshold(threshold_),
      sampleSize(effort.sampleSize), trials(trialsOf(effort, points_.size)), arena(arena_),
      context(context_), size(points_.size), last()
{}

bool Significance::shorten(double count)
{
    if (!context || count <= ENOUGH || size <= ENOUGH || !context->stopBefore(count * LOOK_WORK))
        return false;
    size = ENOUGH;
    return true;
}

double Significance::chance(int inliers, double clear)
{
    const double first = std::ceil((sampleSize + FIRST_INLIERS) * (double)points.size /
                                   std::max(inliers, 1));
    for (double count = first; count < MORE * size && !shorten(count); count *= MORE)
    {
        last = look((int)std::min<double>(count, size), 1, 0);
        const double bound = chanceOf(last);
        if (bound <= clear)
            return bound;
    }
    shorten(LOOKS * (double)size);
    last = look(size, 1, PAIRS);
    double least = chanceOf(last);
    for (int i = 0; i < 2 && least > clear; ++i)
        least = std::min(least, chanceOf(look(size, WIDE[i], PAIRS), WIDE_SHARE));
    return least;
}

bool Significance::decisive(double inlierRatio, double limit) const
{
    // The fraction of independent matches is that of the inliers, or that of all matches if the
    // latter fraction is larger: a model that maps everything to a single point has few independent
    // inliers, even if many matches are independent.
    const double inliers = size - last.points + last.inliers,
                 different = inliers > 0 ? last.inliers / inliers : 1;
    Arena::Scope scope(arena);
    uchar *const all = scope.take<uchar>(size), *const repeated = scope.take<uchar>(size);
    std::fill(all, all + size, (uchar)1);
    std::fill(repeated, repeated + size, (uchar)0);
    Agreement few = last;
    few.points = std::max(size - markRepeated(points, 0, all, size, threshold, repeated, arena),
                          (int)(different * size));
    few.inliers = (int)(inlierRatio * few.points);
    return chanceOf(few) <= limit;
}

Agreement Significance::look(int count, double scale, int pairs) const
{
    return countAgreement(residual, model, points, count, scale * threshold, pairs, arena);
}

double Significance::chanceOf(const Agreement& found, double share) const
{
    if (found.inliers <= sampleSize)
        return 1;
    const double p = betaBinomialTail(found.inliers - sampleSize, found.points - sampleSize,
                                      found.agreeing, found.pairs);
    return -std::expm1(trials / share * std::log1p(-p));
}

}  // namespace usacv20
}  // namespace cv
