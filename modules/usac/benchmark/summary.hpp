// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SUMMARY_HPP
#define OPENCV_USACV20_BENCHMARK_SUMMARY_HPP

#include <vector>
#include "runner.hpp"

namespace benchmark {

/** What a table says about one method on one list, or on average over lists. A figure that is not
known is NaN.

The time of a pair is the median over its repeats; the times below are over pairs. All else is over
pairs and repeats alike. */
struct Summary
{
    Summary();

    int lists;       //!< how many it is about; 0: the method does not solve the problem, or no pair
                     //!< could be read
    int errorLists;  //!< how many `medianError` is about
    double medianError;   //!< pixels, for P, R and M degrees; a failure has an infinite error
    double medianCenter;  //!< of ProblemKind::centerError; a failure has an infinite one
    double failures;      //!< percent
    double medianCpu, meanCpu, medianWall, meanWall;  //!< ms
    /** Mean of max(0, 1 - pose error / threshold) for 1 degree (P, R, M, of the rotation) or for 5,
    10 and 20 degrees (E and F), in percent: the area under the cumulative distribution of the pose
    error from 0 to the threshold, without interpolation between its steps. */
    double auc1, auc5, auc10, auc20;
    double medianIterations;
    double errorRatio, medianCpuRatio, meanCpuRatio, medianWallRatio,
        meanWallRatio;  //!< to the baseline
};

//! Summaries of all methods on one list. @param baseline index of a method.
std::vector<Summary> summarize(const ListResult& result, int baseline);

/** Means over lists for all methods, as the paper's Table 2.

The error is that of the lists where no method failed on half of the runs or more. Ratios: geometric
means.
@param lists of each list the summaries of all methods. */
std::vector<Summary> average(const std::vector<std::vector<Summary>>& lists);

}  // namespace benchmark

#endif
