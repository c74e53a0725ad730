// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "control/batch_tasks.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Milliseconds between two calls of the progress functions, as in a single run, see watch.cpp.
constexpr int CALL_PERIOD = 5;

}  // namespace

BatchProgress::Worker::Worker(BatchProgress& batch_) : batch(batch_)
{
    if (!batch.scopes)
        return;
    Progress progress = [this](const Report&) { return !batch.stopped; };
    if (batch.isCaller())
        progress = [this](const Report& report) { return batch.ask(report); };
    scope.reset(new ProgressScope(progress, 0));
    if (batch.isCaller())
        return;
    const std::lock_guard<std::mutex> lock(batch.mutex);
    ++batch.working;
}

BatchProgress::Worker::~Worker()
{
    if (!batch.scopes)
        return;
    if (batch.isCaller())
    {
        batch.waitForOthers();
        return;
    }
    const std::lock_guard<std::mutex> lock(batch.mutex);
    --batch.working;
    batch.changed.notify_all();
}

BatchProgress::BatchProgress()
    : scopes(ProgressScope::current()), caller(std::this_thread::get_id()), stopped(false),
      asked(getTickCount()), working(0)
{}

bool BatchProgress::goesOn()
{
    if (scopes && isCaller())
        askNowAndThen();
    return !stopped;
}

void BatchProgress::askNowAndThen()
{
    if ((getTickCount() - asked) / getTickFrequency() * 1e3 >= CALL_PERIOD)
    {
        Report report;
        report.cost = 1;  // there is no model
        ask(report);
    }
}

bool BatchProgress::ask(const Report& report)
{
    try
    {
        if (!stopped && !scopes->ask(report))
            stopped = true;
    }
    catch (...)
    {
        thrown = std::current_exception();
        stopped = true;
    }
    asked = getTickCount();
    return !stopped;
}

void BatchProgress::waitForOthers()
{
    std::unique_lock<std::mutex> lock(mutex);
    while (!changed.wait_for(lock, std::chrono::milliseconds(CALL_PERIOD),
                             [this] { return working == 0; }))
    {
        lock.unlock();
        askNowAndThen();
        lock.lock();
    }
}

void BatchProgress::finish()
{
    if (thrown)
        std::rethrow_exception(thrown);
}

void forEachTask(int count, int threads, const std::function<void(int)>& estimate,
                 const std::function<void(int)>& leave)
{
    if (threads < 0)
        CV_Error_(Error::StsOutOfRange, ("threads: 0 or more are expected, not %d", threads));
    const int all = std::max(getNumThreads(), 1),
              workers = std::min(threads > 0 ? std::min(threads, all) : all, count);
    std::atomic<int> next(0);
    BatchProgress progress;
    const auto work = [&](const Range& range) {
        const BatchProgress::Worker member(progress);
        for (int worker = range.start; worker < range.end; ++worker)
            for (int i = next++; i < count; i = next++)
                if (progress.goesOn())
                    estimate(i);
                else
                    leave(i);
    };
    if (workers > 1)
        parallel_for_(Range(0, workers), work, workers);
    else
        work(Range(0, 1));
    progress.finish();
}

}  // namespace usacv20
}  // namespace cv
