// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_WATCH_HPP
#define OPENCV_USACV20_WATCH_HPP

#include "opencv2/usac/components.hpp"
#include "opencv2/usac/progress.hpp"

namespace cv {
namespace usacv20 {

/** Maximum number of points for steps that only compute details of the report, if a run must stop
and there is no time for more points. For 50 000 points, the slowest of these steps, which computes
Report::chance, takes 20 ms. */
constexpr int ENOUGH = 50000;

/** @brief Stops a run before its termination criteria do: when Params::maxTime is exceeded, or when
the function of a ProgressScope returns false.

The loops of a run call stop(). If there is neither a time limit nor a ProgressScope, stop() only
tests a flag. Otherwise, the clock is read after every 0.4 ms of work, and the progress functions
are called every 5 ms. To be used only by the thread that began the run. */
class Watch
{
public:
    /** @param maxTime milliseconds, 0: no limit
    @param spent ticks that the run has already taken */
    Watch(double maxTime, int64 spent);

    //! Sets the state and the number of points from which the reports to progress functions are
    //! made. The state must stay valid while the watch is in use.
    void begin(const State& state, int points);
    /** True if the run must end; later calls then return true, too, until finish().
    @param work work done since the last call, in point tests, see SampleCost */
    bool stop(double work)
    {
        return active && (reason != STOP_NOT_RUN || (enough(work) && look()));
    }
    /** To be called before a step that cannot be interrupted: true if the run must end now, or if
    this step would exceed the time limit.
    @param work work of the step, in point tests */
    bool stopBefore(double work)
    {
        return active && (reason != STOP_NOT_RUN || lacks(work) || stop(work));
    }
    //! True if a step with this work would end within the time limit. For steps that can be
    //! skipped: unlike stopBefore(), this function does not end the run.
    bool fits(double work) const;
    //! True if the run must end, without reading the clock: the result of the last call of stop()
    //! or stopBefore().
    bool stopped() const { return reason != STOP_NOT_RUN; }
    //! False if nothing can stop the run: neither a time limit nor a ProgressScope.
    bool isActive() const { return active; }
    //! @ref StopReason, once stopped() is true.
    int stopReason() const { return reason; }
    //! To be called when the search has ended. If the run was stopped, allows two more milliseconds
    //! for polishing the model.
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

    //! Work between two readings of the clock, in point tests of 2 ns; this is 0.4 ms. A reading
    //! takes 25 ns.
    static constexpr double WORK = 2e5;

    const bool active;
    const int64 start;
    int64 deadline, next;  //!< in ticks: end of the run, and next call of the progress functions
    double done;           //!< work since the last reading of the clock
    int reason;            //!< @ref StopReason; STOP_NOT_RUN: the run continues
    const State* state;
    int points;
};

}  // namespace usacv20
}  // namespace cv

#endif
