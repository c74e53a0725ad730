// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BATCH_PROGRESS_HPP
#define OPENCV_USACV20_BATCH_PROGRESS_HPP

#include <atomic>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include "opencv2/usac/progress.hpp"

namespace cv {
namespace usacv20 {

/** @brief The scopes of the thread that calls estimateBatch, for all threads that work for it.

Only that thread asks them: while it estimates, between its estimations, and while it waits for
those of the others. The others look at the answer. Without a scope nothing is asked, and nobody
waits. */
class BatchProgress
{
public:
    BatchProgress();
    //! Has the calling thread a scope, so that an estimation of its may be cancelled?
    static bool isWatched() { return ProgressScope::current() != 0; }

    //! A thread while it works for the batch.
    class Worker
    {
    public:
        explicit Worker(BatchProgress& batch);
        //! The calling thread waits here until all others that have begun are done, and asks in the
        //! meantime.
        ~Worker();

    private:
        BatchProgress& batch;
        std::unique_ptr<ProgressScope> scope;
    };

    //! Shall the next estimation begin?
    bool goesOn();
    //! Raises what a scope has thrown.
    void finish();

private:
    bool isCaller() const { return std::this_thread::get_id() == caller; }
    //! By the calling thread: an exception is kept, as those of an estimation are its task's.
    bool ask(const Report& report);
    //! The same if it is time.
    void askNowAndThen();
    void waitForOthers();

    const ProgressScope* const scopes;  //!< of the calling thread; null: none
    const std::thread::id caller;
    std::atomic<bool> stopped;
    std::exception_ptr thrown;
    int64 asked;  //!< when, ticks
    std::mutex mutex;
    std::condition_variable changed;
    int working;  //!< other threads; guarded by the mutex
};

}  // namespace usacv20
}  // namespace cv

#endif
