// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>
#include "opencv2/core/parallel/parallel_backend.hpp"

/* ThreadSanitizer sees synchronization only in instrumented code. OpenCV's thread pool is not
instrumented, so each parallel loop would be reported as a race. This backend of parallel_for_
replaces the pool before the first test: every loop starts and joins its threads in instrumented
code. No suppressions are needed, and the loop bodies of the module are fully checked. The
assignment of tasks to threads is fixed: a queue would add synchronization, which could hide races,
and the first thread would run all tasks of a loop if they are fast. */

namespace {

class ThreadsBackend : public cv::parallel::ParallelForAPI
{
public:
    ThreadsBackend() : threads(4) {}

    void parallel_for(int tasks, FN_parallel_for_body_cb_t body, void* data) override
    {
        const int count = std::min((int)threads, tasks);
        const auto work = [=](int number) {
            const int before = current;
            current = number;
            for (int task = number; task < tasks; task += count)
                body(task, task + 1, data);
            current = before;
        };
        std::vector<std::thread> others;
        for (int i = 1; i < count; ++i)
            others.emplace_back(work, i);
        work(0);
        for (auto& thread : others)
            thread.join();
    }

    int getThreadNum() const override { return current; }
    int getNumThreads() const override { return threads; }
    int setNumThreads(int count) override
    {
        const int before = threads;
        threads = count > 0 ? count : 4;
        return before;
    }
    const char* getName() const override { return "std::thread"; }

private:
    static thread_local int current;
    std::atomic<int> threads;
};

thread_local int ThreadsBackend::current = 0;

struct Install
{
    Install() { cv::parallel::setParallelForBackend(std::make_shared<ThreadsBackend>(), false); }
} install;

}  // namespace
