// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_WATCH_HPP
#define OPENCV_USACV20_WATCH_HPP

#include "opencv2/usac/components.hpp"
#include "opencv2/usac/progress.hpp"

namespace cv {
namespace usacv20 {

/** Points: a run that has to end takes as many as there are where the time is for that, and not
more than these where it does not matter much. 50 000 take 20 ms where Report::chance takes longest.
Half, double: as much earlier, later. */
constexpr int ENOUGH = 50000;

/** @brief Says when a run has to end before its criteria do: Params::maxTime is over, or a
ProgressScope says no.

The loops of a run ask it. Without a limit and a scope that is the test of a flag. With them the
clock is looked at whenever as much work has been done as takes a fraction of a millisecond, and the
scopes are asked every few milliseconds. For the thread that began the run. */
class Watch
{
public:
    /** @param maxTime milliseconds, 0: no limit
    @param spent ticks that the run has taken before now */
    Watch(double maxTime, int64 spent);

    //! What the run knows, for the report; as long as the watch is asked.
    void begin(const State& state, int points);
    /** Has the run to end? Once it has, the answer stays the same.
    @param work since the question before, in tests of a point, see SampleCost */
    bool stop(double work)
    {
        return active && (reason != STOP_NOT_RUN || (enough(work) && look()));
    }
    /** The same before a step that cannot be left: has the run to end, or would this step end after
    the limit?
    @param work of the step */
    bool stopBefore(double work)
    {
        return active && (reason != STOP_NOT_RUN || lacks(work) || stop(work));
    }
    //! Would a step that can be left out end before the limit? The run goes on in either case.
    bool fits(double work) const;
    //! The last answer.
    bool stopped() const { return reason != STOP_NOT_RUN; }
    //! Can it ever say yes?
    bool isActive() const { return active; }
    //! @ref StopReason of a run that it has stopped.
    int stopReason() const { return reason; }
    //! The search has ended: some milliseconds are left for what has to be done with its model.
    void finish();

private:
    bool enough(double work)
    {
        done += work;
        return done >= WORK;
    }
    bool look();
    bool lacks(double work);
    Report present(int64 now) const;

    //! Tests of a point, 2 ns each: 0.4 ms of work between two looks at the clock, which take 25
    //! ns. Half: runs end as late, within the noise; double: not measured.
    static constexpr double WORK = 2e5;

    const bool active;
    const ProgressScope* const scopes;  //!< null: none
    const int64 start;
    int64 deadline, next;  //!< ticks: end of the run, and when the scopes are asked again
    double done;
    int reason;
    const State* state;
    int points;
};

}  // namespace usacv20
}  // namespace cv

#endif
