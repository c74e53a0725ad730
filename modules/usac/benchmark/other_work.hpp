// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_OTHER_WORK_HPP
#define OPENCV_USACV20_BENCHMARK_OTHER_WORK_HPP

#include <algorithm>
#include <vector>
#include <opencv2/core.hpp>

namespace benchmark {

/** What a program does between two calls, as far as it slows down the next call: memory replaces
the caches' content, and unpredictable branches replace what the branch predictor has learned. */
class OtherWork
{
public:
    OtherWork() : memory(32 << 20), numbers(40000), rng(1) {}

    void work()
    {
        for (size_t i = 0; i < memory.size(); i += 64)
            ++memory[i];
        for (size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = rng.uniform(0.f, 1.f);
        std::sort(numbers.begin(), numbers.end());
    }

private:
    std::vector<unsigned char> memory;
    std::vector<float> numbers;
    cv::RNG rng;
};

}  // namespace benchmark

#endif
