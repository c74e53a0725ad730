// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SCALE_OPTIONS_HPP
#define OPENCV_USACV20_BENCHMARK_SCALE_OPTIONS_HPP

#include <string>
#include <vector>
#include "arguments.hpp"
#include "method.hpp"
#include "support/scenes.hpp"

namespace benchmark {

/** The options of usac_scale's command line. */
struct ScaleOptions
{
    std::vector<ProblemType> problems;
    std::vector<std::string> methods;
    std::vector<int> sizes;       //!< numbers of matches of the sweep over sizes, ascending
    std::vector<double> inliers;  //!< inlier ratios of the sweep over inliers, descending
    int size;                     //!< number of matches, except in the sweep over sizes
    double part;                  //!< inlier ratio in the sweep over sizes
    double noise;
    int repeats, seed, threads;
    double limit;  //!< milliseconds; methods with a longer median time do not run on harder scenes
    bool sweepSizes, sweepInliers;
    std::string csv;  //!< output file; empty: none

    //! The scene with the number `repeat`, from 0; all methods get the same scene.
    opencv_test::Scene scene(ProblemType problem, int size, double part, int repeat) const;
    //! The settings that the methods get.
    Settings settings(ProblemType problem) const;

    /** Reads the command line. @return false if the command line is empty or asks for help; the
    help text has then been printed. Wrong options raise std::runtime_error. */
    bool parse(int argc, char** argv);

private:
    void parseKinds(const cv::CommandLineParser& parser, const Arguments& arguments);
    void parseScenes(const cv::CommandLineParser& parser, const Arguments& arguments);

    int maxIterations;  // 0: the default of the problem
};

}  // namespace benchmark

#endif
