// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Number of distinct inliers outside the sample at which r (see PNapsacTermination) is half of
Params::relaxation. */
constexpr int HALF = 30;

}  // namespace

double significantInliers(const Context& context, const State& state)
{
    const int m = context.components.minimalSolver->sampleSize(), n = context.points.size;
    const double beside = state.bestQuality.inliers - m, different = beside / copiesOf(state, n, m);
    const double more = state.successProbability < 1
                            ? 0
                            : context.params.relaxation * different / (different + HALF);
    return std::min(m + beside * (1 + more), (double)n);
}

namespace {

/** P-NAPSAC: the standard criterion for a model with significantly more inliers than the best one
@cite barath2019progressive, that is, with (1 + r) times as many. In the paper, r is a constant.
Here the factor does not apply to the points of the sample, because these are inliers even of a
wrong model; if there are few points, a wrong model therefore has only slightly fewer inliers than
the right one. For the same reason, r is Params::relaxation times k / (k + #HALF) for k distinct
inliers (without copies of matches) outside the sample. r is 0 if all-inlier samples can lead to a
wrong model (State::successProbability), because such a wrong model has nearly as many inliers as
the right one. */
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
