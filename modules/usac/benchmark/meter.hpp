// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_METER_HPP
#define OPENCV_USACV20_BENCHMARK_METER_HPP

#include <set>
#include <string>
#include "method.hpp"
#include "progress.hpp"

namespace benchmark {

//! One call of one method.
struct Run
{
    int pair, repeat;  //!< pair: index into ListResult::pairs
    double error;      //!< pixels, for P, R and M degrees; infinite without a model
    bool failed;
    double poseError;    //!< degrees; negative if there is no true pose
    double centerError;  //!< see ProblemKind::centerError; negative for problems without one
    double cost;         //!< the cost that estimators minimize, see modelCost
    double cpuMs, wallMs;
    int iterations;  //!< negative: the method does not report it
    int inliers;
};

/** Measures time and error of single calls.

A method that throws an exception counts as failed. The message is printed to the standard error
once for each method and problem. */
class Meter
{
public:
    explicit Meter(Progress& progress_) : progress(progress_) {}

    //! @param repeat added to the seed. @return everything except Run::pair.
    Run measure(Method& method, const ImagePair& pair, Settings settings, int repeat);

private:
    void complain(const Method& method, ProblemType problem, const ImagePair& pair,
                  const std::string& what);

    Progress& progress;
    std::set<std::string> complaints;
};

}  // namespace benchmark

#endif
