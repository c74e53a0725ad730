// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Inliers. Search failures of F with r = 0.5 over 15 to 1000 points, generic / each point five
times: 3.9 / 6.0 % with 0 (and r = 0.4), 1.7 / 2.8 with 30, 0.7 / 1.9 with 40 (and r = 0.4). On the
lists half and double change next to nothing; USACV20_FAST: 60 takes 8 to 19 % more samples on
scenes of 30 to 300 points, 15 6 to 12 % less. */
constexpr int HALF = 30;

}  // namespace

double significantInliers(const Context& context, const State& state)
{
    const int m = context.components.minimalSolver->sampleSize(), n = context.points.size;
    const double beside = state.bestQuality.inliers - m, different = beside / copiesOf(state, n, m);
    const double more = state.yield < 1
                            ? 0
                            : context.params.relaxation * different / (different + HALF);
    return std::min(m + beside * (1 + more), (double)n);
}

namespace {

/** P-NAPSAC: the standard criterion for a model with significantly more inliers than the best one
@cite barath2019progressive, that is with a part r more of them. There r is a constant. Here those
of the sample do not count: any model has them, so that of a few points a wrong one has not many
less than the right one. For the same reason r is Params::relaxation k / (k + #HALF) for k different
inliers beside the sample; and 0 where samples of inliers only may lead to a wrong model
(State::yield), which then has nearly as many as the right one. */
class PNapsacTermination : public Termination
{
public:
    int iterations(const Context& context, const State& state) const CV_OVERRIDE
    {
        if (state.bestQuality.inliers <= context.components.minimalSolver->sampleSize())
            return INT_MAX;
        return samplesNeeded(
            goodModelProbability(context, state, significantInliers(context, state)),
            std::log(1 - context.params.confidence));
    }

    bool countsAll() const CV_OVERRIDE { return false; }
    int reason() const CV_OVERRIDE { return STOP_P_NAPSAC; }
};

}  // namespace

Ptr<Termination> createPNapsacTermination() { return makePtr<PNapsacTermination>(); }

}  // namespace usacv20
}  // namespace cv
