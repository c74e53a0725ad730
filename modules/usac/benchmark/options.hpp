// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_OPTIONS_HPP
#define OPENCV_USACV20_BENCHMARK_OPTIONS_HPP

#include <string>
#include <vector>
#include "method.hpp"

namespace benchmark {

/** The options of usac_benchmark's command line. */
struct Options
{
    std::vector<std::string> lists, methods;
    std::string csv, runsCsv;  //!< output files; empty: none
    char problem;              //!< a letter; '\0': taken from the name of each list
    int repeats, seed, threads;
    bool cold;  //!< other work before each timed call, see OtherWork

    //! The settings that the methods get for a problem. If the threshold or the limit of iterations
    //! is not on the command line, it is the problem's default.
    Settings settings(ProblemType of) const;

    /** Reads the command line. @return false if the command line is empty or asks for help; the
    help text has then been printed. Wrong options raise std::runtime_error. */
    bool parse(int argc, char** argv);

private:
    double threshold, confidence;  // threshold 0: the default of the problem
    int maxIterations;             // 0: the default of the problem
};

}  // namespace benchmark

#endif
