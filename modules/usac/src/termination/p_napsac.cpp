// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** P-NAPSAC: the standard criterion for a model with significantly more inliers than the best one, that is with
(1 + Params::relaxation) times as many @cite barath2019progressive. Those of the sample do not count here: any model has them, so
that of a few points a wrong one has not many less than the right one. */
class PNapsacTermination : public Termination
{
public:
    int iterations(const Context& context, const State& state) const CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize(), n = context.points.size;
        const int inliers = state.bestQuality.inliers;
        if (inliers <= m)
            return INT_MAX;
        const double significant = std::min(m + (inliers - m) * (1 + context.params.relaxation), (double)n);
        return samplesNeeded(goodModelProbability(context, state, significant), std::log(1 - context.params.confidence));
    }

    bool countsAll() const CV_OVERRIDE { return false; }
    int reason() const CV_OVERRIDE { return STOP_P_NAPSAC; }
};

} // namespace

Ptr<Termination> createPNapsacTermination()
{
    return makePtr<PNapsacTermination>();
}

} // namespace usacv20
} // namespace cv
