// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_PROGRESS_HPP
#define OPENCV_USACV20_BENCHMARK_PROGRESS_HPP

#include <string>

namespace benchmark {

/** A progress bar on the standard error. Nothing is printed if the standard error is not a
terminal. */
class Progress
{
public:
    explicit Progress(int total);
    ~Progress() { clear(); }

    //! Starts the next of `total` steps. @param what text that names the step.
    void step(const std::string& what);
    //! Removes the bar, so that a message can be printed on its line.
    void clear();

private:
    int total, done;
    bool active, drawn;
};

}  // namespace benchmark

#endif
