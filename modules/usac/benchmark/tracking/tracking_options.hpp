// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_TRACKING_OPTIONS_HPP
#define OPENCV_USACV20_BENCHMARK_TRACKING_OPTIONS_HPP

#include <string>
#include <vector>
#include "image_pair.hpp"

namespace benchmark {

/** The options of usac_tracking's command line. */
struct TrackingOptions
{
    std::vector<ProblemType> problems;
    std::vector<double> ratios;
    std::vector<int> limits;
    int frames, size, sequences, seed;
    double noise, speed;
    std::string csv;  //!< output file; empty: none

    /** Reads the command line. @return false if the command line asks for help; the help text has
    then been printed. Wrong options raise std::runtime_error. */
    bool parse(int argc, char** argv);
};

}  // namespace benchmark

#endif
