// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_STOPWATCH_HPP
#define OPENCV_USACV20_BENCHMARK_STOPWATCH_HPP

#include <chrono>
#include <ctime>

namespace benchmark {

/** Measures the processor time of the whole process (the sum over all threads) and the wall time
since the stopwatch was constructed. */
class Stopwatch
{
public:
    Stopwatch() : wallStart(std::chrono::steady_clock::now()), cpuStart(processMs()) {}

    double cpuMs() const { return processMs() - cpuStart; }

    double wallMs() const
    {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() -
                                                         wallStart)
            .count();
    }

private:
    static double processMs()
    {
#ifdef CLOCK_PROCESS_CPUTIME_ID
        timespec time;
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return time.tv_sec * 1e3 + time.tv_nsec * 1e-6;
#else
        return std::clock() * 1e3 / CLOCKS_PER_SEC;
#endif
    }

    std::chrono::steady_clock::time_point wallStart;
    double cpuStart;
};

}  // namespace benchmark

#endif
