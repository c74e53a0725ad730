// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BATCH_TASKS_HPP
#define OPENCV_USACV20_BATCH_TASKS_HPP

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include "opencv2/usac/progress.hpp"

namespace cv {
namespace usacv20 {

/** @brief Lets the ProgressScopes of the thread that starts a batch cancel the work of all
threads of the batch.

Only this thread, the calling thread, calls the progress functions: during its own estimations,
between them, and while it waits for the other threads. The other threads only read the flag
`stopped`. Without a ProgressScope, no function is called, and no thread waits. */
class BatchProgress
{
public:
    BatchProgress();
    //! True if the calling thread has a ProgressScope, so that its estimations can be canceled.
    static bool isWatched() { return ProgressScope::current() != 0; }

    //! While an object of this class exists, its thread counts as working for the batch, unless it
    //! is the calling thread or there is no ProgressScope.
    class Worker
    {
    public:
        explicit Worker(BatchProgress& batch);
        //! The calling thread waits here until no other thread works for the batch, and calls the
        //! progress functions meanwhile.
        ~Worker();

    private:
        BatchProgress& batch;
        std::unique_ptr<ProgressScope> scope;
    };

    //! True if the next estimation can begin, false if the batch has been canceled.
    bool goesOn();
    //! Rethrows the exception that a progress function has thrown, if any.
    void finish();

private:
    bool isCaller() const { return std::this_thread::get_id() == caller; }
    //! Calls the progress functions; to be called in the calling thread only. An exception that
    //! they throw is stored for finish(), because it would otherwise be reported as an error of the
    //! current task.
    //! @return false if the batch has been canceled
    bool ask(const Report& report);
    //! Calls ask() if at least 5 ms have passed since its last call.
    void askNowAndThen();
    void waitForOthers();

    const ProgressScope* const scopes;  //!< innermost scope of the calling thread; null: none
    const std::thread::id caller;
    std::atomic<bool> stopped;
    std::exception_ptr thrown;
    int64 asked;  //!< time of the last call of the progress functions, in ticks
    std::mutex mutex;
    std::condition_variable changed;
    int working;  //!< number of other threads at work; guarded by the mutex
};

/** @brief Runs many estimations in parallel: each thread of cv::parallel_for_ begins the next
estimation when it has finished one.
@param count number of estimations
@param threads how many run at once, at most cv::getNumThreads(); 0: cv::getNumThreads(). Raises
cv::Exception if negative
@param estimate runs the estimation with a given index; must not throw
@param leave called instead of `estimate`, with the same index, after a ProgressScope has canceled
the batch */
void forEachTask(int count, int threads, const std::function<void(int)>& estimate,
                 const std::function<void(int)>& leave);

//! Calls an estimation. @return the message of the exception that it raised, or an empty string
template <class Call>
String mistakeOf(const Call& call)
{
    try
    {
        call();
    }
    catch (const Exception& mistake)
    {
        return mistake.err;
    }
    catch (const std::exception& mistake)
    {
        return mistake.what();
    }
    return String();
}

}  // namespace usacv20
}  // namespace cv

#endif
