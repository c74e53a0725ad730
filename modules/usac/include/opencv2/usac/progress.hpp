// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PROGRESS_HPP
#define OPENCV_USACV20_PROGRESS_HPP

#ifndef OPENCV_BINDING_PARSER  // not for the bindings, which have functions of their own

#include <functional>
#include "opencv2/usac/report.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

/** @brief Function that estimations call to report their progress. @return true: continue; false:
stop, with the best model so far and #STOP_CANCELLED in the returned Report. In the argument
`report`, `stop` is #STOP_NOT_RUN, and `searchMs` is the time since the run began. `inliers`,
`inlierRatio` and `cost` are those of the best model before polishing (0, 0 and 1 if there is none);
with more than 32768 points, they refer to the random part of the points that is searched. */
typedef std::function<bool(const Report& report)> Progress;

/** @brief While an object of this class exists, all estimations that its thread begins call a
function every 5 milliseconds. The function decides whether to continue.

This applies to all functions that estimate a model: those with a flag, #estimateHomography and
similar functions, #estimateBatch, #fitModel, #refineModel, and the methods of Usac.
@code
    std::atomic<bool> canceled(false);  // another thread can set it
    const usacv20::ProgressScope scope([&](const usacv20::Report&) { return !canceled; });
    Mat H = findHomography(points1, points2, USACV20, 3.0, mask);
@endcode
The function is called by the thread that began the estimation, even if other threads help
(Params::threads, #estimateBatch), and not before 5 milliseconds have passed; #estimateBatch also
calls it between two tasks, with the report of a run without a model. Between two calls there is at
most one step over all points; such a step cannot be interrupted and takes up to 0.15 s for a
million points, 0.4 s with a kd-tree (#NEIGHBORHOOD_KNN, #NEIGHBORHOOD_RADIUS). After the function
has returned false, the estimation takes up to 0.1 s to return. If the function always returns true,
the result is bit-identical to that without a ProgressScope. An exception from the function ends the
run and is passed on to the caller; a Usac can be run again afterward. Scopes can be nested: their
functions are called from the innermost outward until one returns false. They can be destroyed in
any order, but only by the thread that created them, and neither by a progress function nor, in
#estimateBatch, by a component. */
class CV_EXPORTS ProgressScope
{
public:
    //! Makes the estimations of this thread call `progress` until the scope ends.
    explicit ProgressScope(const Progress& progress);
    ~ProgressScope();

private:
    friend class BatchProgress;
    friend class Watch;
    ProgressScope(const Progress& progress, ProgressScope* outer);
    ProgressScope(const ProgressScope&);
    ProgressScope& operator=(const ProgressScope&);

    //! The innermost scope of this thread, or null if there is none.
    static ProgressScope* current();
    bool ask(const Report& report) const;

    const Progress progress;
    ProgressScope* outer;   //!< scope whose function is called after `progress`; null: none
    ProgressScope* before;  //!< scope that was the innermost one when this scope was created
};

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
