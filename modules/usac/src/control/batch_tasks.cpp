// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include <atomic>
#include "control/batch_progress.hpp"
#include "control/batch_tasks.hpp"

namespace cv {
namespace usacv20 {

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
