// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "loop/stopping.hpp"
#include "control/watch.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! If this many samples, which take some seconds, have given no model at all (Report::models), the
//! points are considered degenerate, and the search ends (unless there are no criteria).
constexpr int HOPELESS = 1000000;

}  // namespace

Stopping::Stopping(const Context& context_, const State& state_)
    : context(context_), state(state_), m(context_.components.minimalSolver->sampleSize()),
      sampleWork(context_.points.problem->sampleCost().time + context_.points.size),
      exhaustive(exhaustiveSamples(context_)), required(exhaustive), requiredReason(STOP_STANDARD),
      requiredOfAll(INT_MAX), reasonOfAll(STOP_STANDARD), ending(STOP_STANDARD)
{}

bool Stopping::interrupted() const { return context.watch && context.watch->stopped(); }

bool Stopping::reached()
{
    if (interrupted())
        ending = context.watch->stopReason();
    else if (state.iteration >= context.params.maxIterations)
        ending = STOP_MAX_ITERATIONS;
    else if (samplesThatCount() >= required)
        ending = requiredReason;
    else if (state.remembered() >= requiredOfAll)
        ending = reasonOfAll;
    else if (state.iteration >= HOPELESS && state.report.models == 0 &&
             !context.components.terminations.empty())
        ending = STOP_NO_MODEL;
    else if (interrupt())
        ending = context.watch->stopReason();
    else
        return false;
    return true;
}

/* If more than half of the points outside the sample of the best model are inliers of this model, a
model with more inliers must share some of these inliers. Then all samples count, whatever points
the sampler prefers, unless the model can be degenerate. Forgotten samples (State::forgotten) and
samples that contain a match twice do not count. */
int Stopping::samplesThatCount() const
{
    // if so, a wrong model can have nearly all inliers of the right model
    const bool planar = state.degenerate || state.successProbability < 1;
    const bool most = !planar && 2 * (state.bestQuality.inliers - m) > context.points.size - m;
    return most ? state.iteration - state.forgotten - state.repeatedSamples : state.countedSamples;
}

void Stopping::update()
{
    required = exhaustive;
    requiredReason = STOP_STANDARD;
    requiredOfAll = INT_MAX;
    for (const Ptr<Termination>& criterion : context.components.terminations)
        require((double)criterion->iterations(context, state) * context.params.persistence,
                criterion->countsAll(), criterion->reason());
}

void Stopping::require(double wanted, bool all, int reason)
{
    int& least = all ? requiredOfAll : required;
    if (wanted >= least)
        return;
    least = (int)wanted;
    (all ? reasonOfAll : requiredReason) = reason;
}

bool Stopping::adapt(State& changing) const
{
    bool changed = false;
    for (const Ptr<Termination>& criterion : context.components.terminations)
        changed = criterion->adapt(context, changing) || changed;
    return changed;
}

}  // namespace usacv20
}  // namespace cv
