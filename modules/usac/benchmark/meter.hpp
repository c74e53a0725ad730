// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_METER_HPP
#define OPENCV_USACV20_BENCHMARK_METER_HPP

#include <set>
#include <string>
#include "method.hpp"
#include "other_work.hpp"
#include "progress.hpp"

namespace benchmark {

//! One call of one method.
struct Run
{
    int pair, repeat;  //!< pair: index into ListResult::pairs
    double error;      //!< pixels (P, R, M: degrees), see modelError; infinite without a model
    bool failed;
    double poseError;    //!< degrees, see poseError(); negative if the true pose is unknown
    double centerError;  //!< see ProblemKind::centerError; negative for problems without a center
    double cost;         //!< see modelCost
    double cpuMs, wallMs;
    int iterations;  //!< negative: the method does not report the number
    int inliers;     //!< number of inliers in the method's mask
};

/** Measures time and error of single calls.

A call that throws an exception counts as a failure. For each method and problem, only the message
of the first exception is printed to the standard error. */
class Meter
{
public:
    //! @param cold_ true: OtherWork before each call
    explicit Meter(Progress& progress_, bool cold_ = false) : progress(progress_), cold(cold_) {}

    //! Runs a method once. @param repeat number that is added to the seed. @return the results;
    //! the caller must set Run::pair.
    Run measure(Method& method, const ImagePair& pair, Settings settings, int repeat);

private:
    void complain(const Method& method, ProblemType problem, const ImagePair& pair,
                  const std::string& what);

    Progress& progress;
    const bool cold;
    OtherWork other;
    std::set<std::string> complaints;
};

}  // namespace benchmark

#endif
