// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_PROBLEM_SET_HPP
#define OPENCV_USACV20_BENCHMARK_PROBLEM_SET_HPP

#include <string>
#include "image_pair.hpp"

namespace benchmark {

//! The set of problems that a method solves.
class ProblemSet
{
public:
    //! @param letters letters of problemLetters(), for example "HF". An empty string or another
    //! letter raises std::runtime_error.
    ProblemSet(const char* letters = "HFE");

    bool has(ProblemType problem) const
    {
        return letters.find(letterOf(problem)) != std::string::npos;
    }

private:
    std::string letters;
};

}  // namespace benchmark

#endif
