// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SUMMARY_HPP
#define OPENCV_USACV20_BENCHMARK_SUMMARY_HPP

#include <vector>
#include "runner.hpp"

namespace benchmark {

/** The figures of one method on one list, or averaged over lists. An unknown figure is NaN.

Times: first the median over the repeats of each pair is computed, then the median or mean of these
values over the pairs. All other figures are computed from all runs (pairs and repeats) together. */
struct Summary
{
    Summary();

    int lists;            //!< number of lists; 0: the method does not solve the problem, or no pair
                          //!< could be read
    int errorLists;       //!< number of lists over which `medianError` is averaged
    double medianError;   //!< pixels; P, R and M: degrees; a failure counts as infinite
    double medianCenter;  //!< median of ProblemKind::centerError, percent; a failure counts as
                          //!< infinite
    double failures;      //!< percent of the runs
    double medianCpu, meanCpu, medianWall, meanWall;  //!< milliseconds
    /** Mean of max(0, 1 - pose error / limit) in percent: the area under the cumulative
    empirical distribution of the pose error from 0 to the limit, divided by the limit. `auc1` is
    known for P, R and M (absolute pose, motions of 3D space), the others are known for F and E; the
    number in the name is the limit in degrees. */
    double auc1, auc5, auc10, auc20;
    double medianIterations;
};

//! Summaries of all methods on one list.
std::vector<Summary> summarize(const ListResult& result);

/** Averages over lists for all methods, as in Table 2 of the USACv20 paper.

The errors (also of the center) are averaged over the lists on which every method that was run
succeeds in more than half of the runs.
@param lists for each list, the summaries of all methods */
std::vector<Summary> average(const std::vector<std::vector<Summary>>& lists);

}  // namespace benchmark

#endif
