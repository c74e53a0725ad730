// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SUMMARY_HPP
#define OPENCV_USACV20_BENCHMARK_SUMMARY_HPP

#include <vector>
#include "runner.hpp"

namespace benchmark {

/** The figures of one method on one list, or averaged over lists. An unknown figure is NaN.

For times, the median over the repeats of each pair is taken first, and the figures are over pairs.
All other figures are over pairs and repeats together. */
struct Summary
{
    Summary();

    int lists;            //!< number of lists; 0: the method does not solve the problem, or no pair
                          //!< could be read
    int errorLists;       //!< number of lists that `medianError` averages
    double medianError;   //!< pixels; P, R and M: degrees; a failure counts as infinite
    double medianCenter;  //!< median of ProblemKind::centerError; a failure counts as infinite
    double failures;      //!< percent
    double medianCpu, meanCpu, medianWall, meanWall;  //!< milliseconds
    /** Mean of max(0, 1 - pose error / threshold) in percent: the area under the cumulative
    distribution of the pose error from 0 to the threshold, without interpolation between its steps.
    The threshold is 1 degree for the rotation of P, R and M, and 5, 10 and 20 degrees for E and F.
     */
    double auc1, auc5, auc10, auc20;
    double medianIterations;
    double errorRatio, medianCpuRatio, meanCpuRatio, medianWallRatio,
        meanWallRatio;  //!< relative to the baseline
};

//! Summaries of all methods on one list. @param baseline index of a method.
std::vector<Summary> summarize(const ListResult& result, int baseline);

/** Averages over lists for all methods, as in Table 2 of the paper.

The error is averaged over the lists on which every method solves more than half of the runs. Ratios
are averaged by geometric means.
@param lists the summaries of all methods for each list. */
std::vector<Summary> average(const std::vector<std::vector<Summary>>& lists);

}  // namespace benchmark

#endif
