// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_TRACKER_HPP
#define OPENCV_USACV20_BENCHMARK_TRACKER_HPP

#include <string>
#include <vector>
#include "method.hpp"
#include "opencv2/usac.hpp"

namespace benchmark {

//! What a tracker makes of the model of the frame before.
enum Beginning {
    BEGIN_ANEW,       //!< nothing
    BEGIN_WITH_LAST,  //!< each frame begins with it
    /** The same; where there is none, or the new one has less than half of its inliers, the frame
    is estimated again, as without it and with the limit of the problem. */
    BEGIN_WITH_LAST_OR_AGAIN
};

/** A way to estimate the models of a sequence, and what it has given so far. */
class Tracker
{
public:
    //! @param maxIterations of a frame
    Tracker(ProblemType problem, Beginning beginning, int maxIterations);

    //! The next frame. @param afterJump whether it is the first one behind the jump, or a later one
    void track(const ImagePair& frame, int seed, bool afterJump);
    //! Another sequence begins.
    void restart();

    Beginning begins() const { return beginning; }
    int limit() const { return params.maxIterations; }

    double medianError() const;  //!< a failure counts as infinite
    double failures() const;     //!< percent
    double meanSamples() const;  //!< a frame
    double meanCpuMs() const;    //!< a frame
    double meanRecovery()
        const;  //!< frames behind a jump until the first that is no failure, all of them if none is
    int frames() const { return (int)errors.size(); }

private:
    Estimate estimate(const ImagePair& frame, const cv::usacv20::Params& with);
    //! Adds the samples of an estimate, which is made again for that.
    void count(const ImagePair& frame, const cv::usacv20::Params& with);
    void judge(const ImagePair& frame, const Estimate& found, bool afterJump);

    const ProblemType problem;
    const Beginning beginning;
    cv::usacv20::Params params;
    cv::Mat last;  //!< model of the frame before; empty: none
    int lastInliers;
    std::vector<double> errors;
    double samples, cpuMs;  //!< sums
    int failed, sequences, lost;
    bool isLost;  //!< in all frames since the jump, so far
};

}  // namespace benchmark

#endif
