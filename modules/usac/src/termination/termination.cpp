// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

//! Probability that a particular sample has not been drawn after exhaustiveSamples() samples. It
//! matters only if there are very few points.
constexpr double MISSED = 1e-6;
//! Minimum result of exhaustiveSamples(); so few samples take almost no time.
constexpr int LEAST_EXHAUSTIVE = 100;

double keptProbability(const Context& context, double inliers)
{
    const Ptr<Verifier>& verifier = context.components.verifier;
    const bool exact = (context.params.termination & TERMINATION_EXACT) != 0;
    return verifier ? verifier->keptProbability(context, inliers, exact) : 1;
}

double copiesOf(const State& state, int n, int m)
{
    if (state.repeatedSamples == 0)
        return 1;
    const double passed = (state.countedSamples + 1.) /
                          (state.countedSamples + state.repeatedSamples + 1.);
    return 1 - std::log(passed) / (m * (m - 1) / 2) * (n - 1);
}

double goodSampleProbability(const Context& context, const State& state, double inliers)
{
    const int m = context.components.minimalSolver->sampleSize(), n = context.points.size;
    if ((context.params.termination & TERMINATION_EXACT) == 0)
        return goodSampleProbability(inliers, n, m, false) * state.successProbability;
    const double different = std::max(n / copiesOf(state, n, m), (double)std::min(n, m + 1));
    double p = 1;
    for (int i = 0; i < m; ++i)
        p *= std::max(inliers / n * different - i, 0.0) / (different - i);
    return std::min(p, 1.0) * state.successProbability;
}

double goodModelProbability(const Context& context, const State& state, double inliers)
{
    return goodSampleProbability(context, state, inliers) * keptProbability(context, inliers);
}

int exhaustiveSamples(const Context& context)
{
    const int n = context.points.size, m = context.components.minimalSolver->sampleSize();
    if (context.components.terminations.empty())
        return INT_MAX;
    return std::max(
        samplesNeeded(goodSampleProbability(m, n, m, true) * keptProbability(context, m),
                      std::log(MISSED)),
        LEAST_EXHAUSTIVE);
}

}  // namespace usacv20
}  // namespace cv
