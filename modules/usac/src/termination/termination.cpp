// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

double goodSampleProbability(double inliers, int n, int m, bool exact)
{
    double p = 1;
    for (int i = 0; i < m; ++i)
        p *= exact ? std::max(inliers - i, 0.0) / (n - i) : inliers / n;
    return std::min(p, 1.0);
}

double keptProbability(const Context& context, double inliers)
{
    if (context.params.verification != VERIFICATION_TDD)
        return 1;
    const int n = context.points.size;
    const bool exact = (context.params.termination & TERMINATION_EXACT) != 0;
    return goodSampleProbability(inliers, n, std::min(context.params.tddPoints, n), exact);
}

double copiesOf(const State& state, int n, int m)
{
    if (state.repeatedSamples == 0)
        return 1;
    const double passed = (state.countedSamples + 1.) / (state.countedSamples + state.repeatedSamples + 1.);
    return 1 - std::log(passed) / (m * (m - 1) / 2) * (n - 1);
}

double goodSampleProbability(const Context& context, const State& state, double inliers)
{
    const int m = context.components.minimalSolver->sampleSize(), n = context.points.size;
    if ((context.params.termination & TERMINATION_EXACT) == 0)
        return goodSampleProbability(inliers, n, m, false) * state.yield;
    const double different = std::max(n / copiesOf(state, n, m), (double)std::min(n, m + 1));
    double p = 1;
    for (int i = 0; i < m; ++i)
        p *= std::max(inliers / n * different - i, 0.0) / (different - i);
    return std::min(p, 1.0) * state.yield;
}

double goodModelProbability(const Context& context, const State& state, double inliers)
{
    return goodSampleProbability(context, state, inliers) * keptProbability(context, inliers);
}

int samplesNeeded(double p, double logFailure)
{
    if (!(p > 0))
        return INT_MAX;
    if (p >= 1 || logFailure >= 0)
        return logFailure >= 0 ? 0 : 1;
    const double k = std::ceil(logFailure / std::log1p(-p));
    return k < INT_MAX ? (int)k : INT_MAX;
}

} // namespace usacv20
} // namespace cv
