// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SUMMARY_HPP
#define OPENCV_USACV20_BENCHMARK_SUMMARY_HPP

#include <string>
#include <vector>
#include "runner.hpp"

namespace benchmark {

enum { POSE_THRESHOLDS = 3 };
//! Degrees.
const double POSE_THRESHOLD[POSE_THRESHOLDS] = { 5, 10, 20 };

/** What a table says about one method on one list.

The time of a pair is the median over its repeats; `medianCpu`, `meanCpu` and `medianWall` are over pairs.
All else is over pairs and repeats alike. A failure has an infinite error. */
struct Summary
{
    bool ran;              //!< false: the method does not solve the problem, or no pair could be read
    double medianError;    //!< pixels
    double failures;       //!< percent
    double medianCpu, meanCpu, medianWall;  //!< ms
    bool hasPose;
    /** Mean of max(0, 1 - error / threshold), in percent: the area under the cumulative distribution of the
    pose error from 0 to the threshold, without interpolation between its steps. */
    double auc[POSE_THRESHOLDS];
    double medianIterations;  //!< negative where the method does not tell
};

Summary summarise(const ListResult& result, int method);

/** Means over lists, as the paper's Table 2. */
struct Average
{
    int lists;                //!< that the method ran on
    double error;             //!< of the medians, over the lists where no method failed on more than half; NaN without any
    int errorLists;           //!< number of those
    double failures, medianCpu, meanCpu, medianWall;
    bool hasPose;
    double auc[POSE_THRESHOLDS];  //!< over the lists with poses
    //! Geometric means of the ratios to the baseline; NaN without any list where both are known.
    double errorRatio, medianCpuRatio, meanCpuRatio;
};

//! @param summaries of each list, of each method. @param method, baseline indices into them.
Average average(const std::vector<std::vector<Summary> >& summaries, int method, int baseline);

} // namespace benchmark

#endif
