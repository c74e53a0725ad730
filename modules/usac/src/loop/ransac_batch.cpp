// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "loop/ransac.hpp"

// Computes and scores the models of a batch of samples with several threads.

namespace cv {
namespace usacv20 {

namespace {

//! Work of each thread between two checks of the clock in a run with a time limit or a
//! ProgressScope, in point tests (two milliseconds). The value only affects when such a run ends.
constexpr double TOGETHER = 1e6;

}  // namespace

//! Divides the batch among the threads, each of which has its own memory. If the run has a time
//! limit or a ProgressScope, the batch is processed in parts, and the clock is checked after each
//! part.
void Ransac::hypothesizeBatch()
{
    const bool watched = context.watch && context.watch->isActive();
    const int part = watched ? std::max((int)(TOGETHER / sampleWork), 1) * threads : size;
    for (int done = 0; done < size; done += part)
    {
        hypothesizePart(done, std::min(part, size - done));
        if (stop(TOGETHER))
            size = std::min(size, done + part);
    }
}

void Ransac::hypothesizePart(int first, int count)
{
    parallel_for_(
        Range(0, threads),
        [this, first, count](const Range& range) {
            for (int t = range.start; t < range.end; ++t)
            {
                float* const row = errorRows ? errorRows + (size_t)t * context.points.size : 0;
                const int begin = first + (int)((int64)count * t / threads),
                          end = first + (int)((int64)count * (t + 1) / threads);
                for (int i = begin; i < end; ++i)
                {
                    if ((i - begin) % ahead == 0)
                        solve(samples + i, std::min(ahead, end - i), batch + i);
                    hypothesize(i, batch[i], row);
                }
            }
        },
        threads);
}

}  // namespace usacv20
}  // namespace cv
