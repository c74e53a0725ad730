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

/** The command line of usac_scale. */
struct ScaleOptions
{
    std::vector<ProblemType> problems;
    std::vector<std::string> methods;
    std::vector<int> sizes;            //!< sweep over the number of matches, upwards
    std::vector<double> inliers;       //!< sweep over the part of right matches, downwards
    std::vector<double> boundInliers;  //!< where the lower bound is measured
    int size;                          //!< where the number of matches is fixed
    double part;                       //!< where the part of right matches is fixed
    double noise;
    int repeats, seed, threads;
    double limit;  //!< milliseconds
    bool sweepSizes, sweepInliers, bound;
    std::string csv, boundCsv;  //!< files to write, empty: none

    //! The `repeat`-th scene; the same for all methods.
    opencv_test::Scene scene(ProblemType problem, int size, double part, int repeat) const;
    //! What the methods are given.
    Settings settings(ProblemType problem) const;

    /** Reads the command line. @return false if only help was asked for, which has been printed
    then. A mistake raises std::runtime_error. */
    bool parse(int argc, char** argv);

private:
    void parseKinds(const cv::CommandLineParser& parser, const Arguments& arguments);
    void parseScenes(const cv::CommandLineParser& parser, const Arguments& arguments);

    int maxIterations;  // 0: not given
};

}  // namespace benchmark

#endif
