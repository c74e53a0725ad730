// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

double goodSampleProbability(double inliers, int n, int m)
{
    double p = 1;
    for (int i = 0; i < m; ++i)
        p *= std::max(inliers - i, 0.0) / (n - i);
    return std::min(p, 1.0);
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

namespace {

/** Standard: the samples after which at least one of inliers only has been drawn with the wanted confidence, if the best
model so far has all inliers; with the exact (hypergeometric) probability of such a sample @cite fischler1981random. */
class StandardTermination : public Termination
{
public:
    int iterations(const Context& context, const State& state) const CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize();
        return samplesNeeded(goodSampleProbability(state.bestQuality.inliers, context.points.size, m),
                             std::log(1 - context.params.confidence));
    }

    int reason() const CV_OVERRIDE { return STOP_STANDARD; }
};

/** P-NAPSAC: the standard criterion for a model with significantly more inliers than the best one, that is with
(1 + Params::relaxation) times as many @cite barath2019progressive. */
class PNapsacTermination : public Termination
{
public:
    int iterations(const Context& context, const State& state) const CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize(), n = context.points.size;
        const int inliers = state.bestQuality.inliers;
        if (inliers <= m)
            return INT_MAX;
        const double significant = std::min<double>(inliers * (1 + context.params.relaxation), n);
        return samplesNeeded(goodSampleProbability(significant, n, m), std::log(1 - context.params.confidence));
    }

    int reason() const CV_OVERRIDE { return STOP_P_NAPSAC; }
};

/** SPRT: as the standard criterion, but a good model may have been dropped by the test. Under the l-th test this happens
with a probability of at most A_l^-h, with h the root of epsilon (delta_l / epsilon_l)^h + (1 - epsilon) ((1 - delta_l) /
(1 - epsilon_l))^h = 1 for the inlier ratio epsilon of the best model @cite chum2008optimal. */
class SprtTermination : public Termination
{
public:
    int iterations(const Context& context, const State& state) const CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize(), n = context.points.size;
        if (state.tests.empty() || state.bestQuality.inliers < m)
            return INT_MAX;
        const double good = goodSampleProbability(state.bestQuality.inliers, n, m);
        const double epsilon = (double)state.bestQuality.inliers / n;
        double logFailure = std::log(1 - context.params.confidence), tested = 0;
        for (size_t l = 0; l < state.tests.size(); ++l)
        {
            const SequentialTest& test = state.tests[l];
            if (l + 1 == state.tests.size())
            {
                const int more = samplesNeeded(good * (1 - 1 / test.A), logFailure);
                return more < INT_MAX - (int)tested ? (int)tested + more : INT_MAX;
            }
            const double kept = good * (1 - std::pow(test.A, -exponent(test, epsilon)));
            if (kept >= 1)
                return (int)tested;
            logFailure -= test.samples * std::log1p(-kept);
            tested += test.samples;
        }
        return INT_MAX;
    }

    int reason() const CV_OVERRIDE { return STOP_SPRT; }

private:
    //! The positive root h, by bisection; 0 if the test would more often than not drop a model with this epsilon.
    static double exponent(const SequentialTest& test, double epsilon)
    {
        const double inlier = std::log(test.delta / test.epsilon);
        const double outlier = std::log((1 - test.delta) / (1 - test.epsilon));
        if (epsilon * inlier + (1 - epsilon) * outlier >= 0)
            return 0;
        double low = 0, high = 1;
        while (high < 1000 && epsilon * std::exp(high * inlier) + (1 - epsilon) * std::exp(high * outlier) < 1)
            high *= 2;
        for (int i = 0; i < 40; ++i)
        {
            const double h = 0.5 * (low + high);
            (epsilon * std::exp(h * inlier) + (1 - epsilon) * std::exp(h * outlier) < 1 ? low : high) = h;
        }
        return low;
    }
};

} // namespace

Ptr<Termination> createStandardTermination()
{
    return makePtr<StandardTermination>();
}

Ptr<Termination> createSprtTermination()
{
    return makePtr<SprtTermination>();
}

Ptr<Termination> createPNapsacTermination()
{
    return makePtr<PNapsacTermination>();
}

} // namespace usacv20
} // namespace cv
