// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PROGRESS_HPP
#define OPENCV_USACV20_PROGRESS_HPP

#ifndef OPENCV_BINDING_PARSER  // other languages have functions of their own for it

#include <functional>
#include "opencv2/usac/report.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

/** @brief Sees how far a run is. @return true: go on; false: stop, with what has been found so far
and #STOP_CANCELLED in the report. Of the report, `stop` is #STOP_NOT_RUN, `inliers` and `cost` are
those of the best model before it is polished (0 and 1: there is none), and `searchMs` is what has
passed since the run began. */
typedef std::function<bool(const Report& report)> Progress;

/** @brief While it lives, all estimations that its thread begins ask a function every 5
milliseconds whether to go on.

It holds for whatever estimates: the functions with a flag, #estimateHomography and its kin,
#estimateBatch, Usac::run.
@code
    std::atomic<bool> cancelled(false);  // which another thread may set
    const usacv20::ProgressScope scope([&](const usacv20::Report&) { return !cancelled; });
    Mat H = findHomography(points1, points2, USACV20, 3.0, mask);
@endcode
The function is called by the thread that began the estimation, also if others help
(Params::threads, #estimateBatch), and never before 5 milliseconds have passed; #estimateBatch asks
it between two tasks, too, with an empty report. Between two calls is at most one step that takes
all points: 0.15 s with a million, 0.4 s with a kd-tree (#NEIGHBORHOOD_KNN, #NEIGHBORHOOD_RADIUS);
what follows a no takes up to 0.1 s. A function that returns true changes no bit of the result. An
exception of it ends the run and comes out of the call; a Usac can be run again afterwards. Scopes
may be nested: each is asked, the innermost first, until one says no. Destroy them in reverse order,
by the thread that made them. */
class CV_EXPORTS ProgressScope
{
public:
    //! Begins: `progress` is asked until the end of the scope.
    explicit ProgressScope(const Progress& progress);
    ~ProgressScope();

private:
    friend class BatchProgress;
    friend class Watch;
    //! `outer` is asked after it.
    ProgressScope(const Progress& progress, const ProgressScope* outer);
    ProgressScope(const ProgressScope&);
    ProgressScope& operator=(const ProgressScope&);

    //! The innermost one of this thread; null: none.
    static const ProgressScope* current();
    bool ask(const Report& report) const;

    const Progress progress;
    const ProgressScope *const outer, *const before;
};

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
