// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** SPRT: like the standard criterion, but allows for good models that the test has rejected. The
l-th test rejects a good model with a probability of at most A_l^-h, where h is the positive root of
epsilon (delta_l / epsilon_l)^h + (1 - epsilon) ((1 - delta_l) / (1 - epsilon_l))^h = 1, and epsilon
is the inlier ratio of the best model @cite chum2008optimal. For the current test, h = 1 is used.
A_l, epsilon_l and delta_l are the parameters of the l-th test, see SequentialTest. */
class SprtTermination : public Termination
{
public:
    int iterations(const Context& context, const State& state) const CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize(), n = context.points.size;
        if (state.tests.empty() || state.bestQuality.inliers < m)
            return INT_MAX;
        const double good = goodSampleProbability(context, state, state.bestQuality.inliers);
        const double epsilon = (double)state.bestQuality.inliers / n;
        double logFailure = std::log(1 - context.params.confidence), tested = 0;
        for (int l = 0; l + 1 < state.tests.size(); ++l)
        {
            const SequentialTest& test = state.tests[l];
            const double kept = good * (1 - std::pow(test.A, -exponent(test, epsilon)));
            if (kept >= 1)
                return (int)tested;
            logFailure -= test.samples * std::log1p(-kept);
            tested += test.samples;
        }
        const int more = samplesNeeded(good * (1 - 1 / state.tests.back().A), logFailure);
        return more < INT_MAX - (int)tested ? (int)tested + more : INT_MAX;
    }

    bool countsAll() const CV_OVERRIDE { return false; }
    int reason() const CV_OVERRIDE { return STOP_SPRT; }

private:
    /** The positive root h, by Newton's method from above: the left side of the equation is convex,
    so that no step goes beyond the root. 0 if there is no positive root. In this case, the points
    of a model with this epsilon bring the model, on average, closer to rejection. */
    static double exponent(const SequentialTest& test, double epsilon)
    {
        const double inlier = std::log(test.delta / test.epsilon);
        const double outlier = std::log((1 - test.delta) / (1 - test.epsilon));
        if (epsilon * inlier + (1 - epsilon) * outlier >= 0)
            return 0;
        double h = 1;
        while (h < 1000 &&
               epsilon * std::exp(h * inlier) + (1 - epsilon) * std::exp(h * outlier) < 1)
            h *= 2;
        for (int i = 0; i < 40; ++i)
        {
            const double a = epsilon * std::exp(h * inlier),
                         b = (1 - epsilon) * std::exp(h * outlier);
            const double step = (a + b - 1) / (a * inlier + b * outlier);
            if (!(step > 1e-9 * h))
                break;
            h -= step;
        }
        return h;
    }
};

}  // namespace

Ptr<Termination> createSprtTermination() { return makePtr<SprtTermination>(); }

}  // namespace usacv20
}  // namespace cv
