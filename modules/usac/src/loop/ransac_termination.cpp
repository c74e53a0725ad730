// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "loop/ransac.hpp"

// Decides when the search ends: line 2 of Algorithm 1.

namespace cv {
namespace usacv20 {

namespace {

//! If this many samples, which take some seconds, have given no model at all, the points are
//! considered degenerate, and the search ends (unless there are no criteria).
constexpr int HOPELESS = 1000000;

}  // namespace

bool Ransac::terminate()
{
    if (stopped())
        ending = context.watch->stopReason();
    else if (state.iteration >= context.params.maxIterations)
        ending = STOP_MAX_ITERATIONS;
    else if (samplesThatCount() >= required)
        ending = requiredReason;
    else if (state.remembered() >= requiredOfAll)
        ending = reasonOfAll;
    else if (state.iteration >= HOPELESS && !anyModel && !parts.terminations.empty())
        ending = STOP_NO_MODEL;
    else if (stop(sampleWork))
        ending = context.watch->stopReason();
    else
        return false;
    return true;
}

/* If more than half of the points outside the sample of the best model are inliers of this model, a
model with more inliers must share some of these inliers. Then all samples count, whatever points
the sampler prefers, unless the model can be degenerate. Forgotten samples (forgetSamples()) and
samples that contain a match twice do not count. */
int Ransac::samplesThatCount() const
{
    // if so, a wrong model can have nearly all inliers of the right model
    const bool planar = state.degenerate || state.successProbability < 1;
    const bool most = !planar && 2 * (state.bestQuality.inliers - m) > context.points.size - m;
    return most ? state.iteration - state.forgotten - state.repeatedSamples : state.countedSamples;
}

void Ransac::updateTermination()
{
    required = exhaustive;
    requiredReason = STOP_STANDARD;
    requiredOfAll = INT_MAX;
    for (size_t t = 0; t < parts.terminations.size(); ++t)
        require((double)parts.terminations[t]->iterations(context, state) *
                    context.params.persistence,
                parts.terminations[t]->countsAll(), parts.terminations[t]->reason());
}

bool Ransac::adaptTerminations()
{
    const int wanted = state.wanted;
    bool changed = false;
    for (size_t t = 0; t < parts.terminations.size(); ++t)
        changed = parts.terminations[t]->adapt(context, state) || changed;
    if (state.wanted != wanted && state.iteration > 0)
        improveRunnersUp();
    if (changed)
        updateTermination();
    return changed;
}

void Ransac::require(double wanted, bool all, int reason)
{
    int& least = all ? requiredOfAll : required;
    if (wanted >= least)
        return;
    least = (int)wanted;
    (all ? reasonOfAll : requiredReason) = reason;
}

}  // namespace usacv20
}  // namespace cv
