// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "control/watch.hpp"

namespace cv {
namespace usacv20 {

namespace {

// If there is neither a time limit nor a ProgressScope, results do not depend on these constants,
// see doc/constants.md.

//! Milliseconds between two calls of the progress functions: about a third of the time for which a
//! 60-Hz display shows a frame.
constexpr double LOOK_PERIOD = 5;
//! Milliseconds that a point test is assumed to take. If this is half the actual time, a run can
//! end too late, by at most half the duration of a step that cannot be interrupted; if it is double
//! the actual time, a run can end too early, by at most the duration of such a step.
constexpr double TEST = 2e-6;
//! Milliseconds that polishing is allowed to take after a run was stopped; for a thousand points,
//! it needs a third of a millisecond. With 10 000 points or more, it takes all of this time, so
//! that the run ends this much after it was stopped.
constexpr double GRACE = 2;

int64 ticks(double milliseconds)
{
    const double count = milliseconds * 1e-3 * getTickFrequency();
    return count < (double)(INT64_MAX / 4) ? (int64)count : INT64_MAX / 4;
}

}  // namespace

constexpr double Watch::WORK;

Watch::Watch(double maxTime, int64 spent)
    : active(maxTime > 0 || ProgressScope::current()), start(active ? getTickCount() - spent : 0),
      deadline(maxTime > 0 ? start + ticks(maxTime) : INT64_MAX), next(start + ticks(LOOK_PERIOD)),
      done(0), reason(STOP_NOT_RUN), state(0), points(0)
{}

void Watch::begin(const State& state_, int points_)
{
    state = &state_;
    points = points_;
}

bool Watch::fits(double work) const
{
    return work < WORK || deadline == INT64_MAX || getTickCount() + ticks(work * TEST) <= deadline;
}

bool Watch::lacks(double work)
{
    if (!fits(work))
        reason = STOP_TIME;
    return stopped();
}

bool Watch::look()
{
    done = 0;
    const int64 now = getTickCount();
    const ProgressScope* const scopes = now >= next ? ProgressScope::current() : 0;
    if (scopes)  // read anew each time, because a component can end or begin a scope
    {
        if (!scopes->ask(present(now)))
            reason = STOP_CANCELLED;
        next = getTickCount() + ticks(LOOK_PERIOD);
    }
    if (reason == STOP_NOT_RUN && now >= deadline)
        reason = STOP_TIME;
    return stopped();
}

Report Watch::present(int64 now) const
{
    Report report = state ? state->report : Report();
    report.stop = STOP_NOT_RUN;
    report.searchMs = (now - start) / getTickFrequency() * 1e3;
    report.cost = 1;
    if (!state)
        return report;
    report.iterations = state->iteration;
    if (points > 0 && state->bestQuality.cost <= points)  // there is a model
    {
        report.inliers = state->bestQuality.inliers;
        report.inlierRatio = (double)report.inliers / points;
        report.cost = state->bestQuality.cost / points;
    }
    return report;
}

void Watch::finish()
{
    if (!stopped())
        return;
    deadline = getTickCount() + ticks(GRACE);
    done = WORK;
    next = INT64_MAX;  // so that the progress functions are not called again
    reason = STOP_NOT_RUN;
}

}  // namespace usacv20
}  // namespace cv
