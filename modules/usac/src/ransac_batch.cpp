// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "ransac.hpp"

// The models of a batch of samples, by several threads.

namespace cv {
namespace usacv20 {

namespace {

//! Tests of a point: so many for each thread between two looks at the clock, if a run may be
//! stopped: two milliseconds. The result is the same.
constexpr double TOGETHER = 1e6;

}  // namespace

//! A part of the batch for each thread, as each has memory of its own. A run that may have to stop
//! looks up now and then.
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
                const int end = first + (int)((int64)count * (t + 1) / threads);
                for (int i = first + (int)((int64)count * t / threads); i < end; ++i)
                    hypothesize(i, batch[i], row);
            }
        },
        threads);
}

}  // namespace usacv20
}  // namespace cv
