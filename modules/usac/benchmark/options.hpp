// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_OPTIONS_HPP
#define OPENCV_USACV20_BENCHMARK_OPTIONS_HPP

#include <string>
#include <vector>
#include "method.hpp"

namespace benchmark {

/** The command line. */
struct Options
{
    std::vector<std::string> lists, methods;
    std::string baseline;      //!< name of a method
    std::string csv, runsCsv;  //!< files to write, empty: none
    char problem;              //!< a letter, or '\0': as the name of each list says
    int repeats, seed, threads;

    //! What the methods are given; what the command line leaves open is that of the paper.
    Settings settings(ProblemType of) const;

    /** Reads the command line. @return false if only help was asked for, which has been printed
    then. A mistake raises std::runtime_error. */
    bool parse(int argc, char** argv);

private:
    double threshold, confidence;  // 0: not given
    int maxIterations;             // 0: not given
};

}  // namespace benchmark

#endif
