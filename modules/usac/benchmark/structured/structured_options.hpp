// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_STRUCTURED_OPTIONS_HPP
#define OPENCV_USACV20_BENCHMARK_STRUCTURED_OPTIONS_HPP

#include <string>
#include <vector>
#include "arguments.hpp"
#include "method.hpp"
#include "scene_kind.hpp"

namespace benchmark {

/** The options of usac_structured's command line. */
struct StructuredOptions
{
    bool search, accuracy, random;  //!< the mode (option --mode): exactly one of these is true
    std::vector<std::string> methods;
    std::vector<ProblemType> problems;
    std::vector<std::string> motions, kinds, orders, by;
    std::vector<int> sizes;
    std::vector<double> ratios;
    std::vector<double> noises;  //!< ratios of noise to threshold for mode=accuracy
    bool ratiosGiven, brief;
    bool startsTrue;  //!< true: if a method of this module returns a model that misses the true
                      //!< one, this counts as a search failure only if the same call, started from
                      //!< the true model, does not miss it
    double noise, threshold, confidence;
    int maxIterations, maxIterationsInverted, spare, runs, seed, threads;
    std::string csv;  //!< output file; empty: none

    //! The settings that the methods get in a cell.
    Settings settings(const Cell& cell) const;

    /** Reads the command line. @return false if the command line is empty or asks for help; the
    help text has then been printed. Wrong options raise std::runtime_error. */
    bool parse(int argc, char** argv);

private:
    void parseGrid(const cv::CommandLineParser& parser, const Arguments& arguments);
    void parseNumbers(const cv::CommandLineParser& parser);
};

}  // namespace benchmark

#endif
