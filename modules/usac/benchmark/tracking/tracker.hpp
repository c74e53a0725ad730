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

//! How a tracker uses the model of the previous frame.
enum Beginning {
    BEGIN_ANEW,       //!< not at all
    BEGIN_WITH_LAST,  //!< as the initial model of each frame
    /** As BEGIN_WITH_LAST. If there is no model, or if it has less than half as many inliers as the
    model of the previous frame, the frame is estimated again without an initial model and with the
    problem's default limit of iterations. */
    BEGIN_WITH_LAST_OR_AGAIN
};

/** A way to estimate the models of a sequence, and statistics of its results so far. */
class Tracker
{
public:
    //! @param maxIterations limit of iterations for each frame
    Tracker(ProblemType problem, Beginning beginning, int maxIterations);

    //! Estimates the model of the next frame. @param afterJump true for all frames after the jump
    void track(const ImagePair& frame, int seed, bool afterJump);
    //! Starts another sequence.
    void restart();

    Beginning begins() const { return beginning; }
    int limit() const { return params.maxIterations; }

    double medianError() const;   //!< median of the errors; failures count as infinite
    double failures() const;      //!< percentage of frames that failed
    double meanSamples() const;   //!< per frame
    double meanCpuMs() const;     //!< per frame
    double meanRecovery() const;  //!< mean number of failed frames after a jump before the first
                                  //!< success; without a success, all frames after the jump count
    int frames() const { return (int)errors.size(); }

private:
    Estimate estimate(const ImagePair& frame, const cv::usacv20::Params& with);
    //! Adds the number of samples of an estimate, which is repeated for this purpose.
    void count(const ImagePair& frame, const cv::usacv20::Params& with);
    void judge(const ImagePair& frame, const Estimate& found, bool afterJump);

    const ProblemType problem;
    const Beginning beginning;
    cv::usacv20::Params params;
    cv::Mat last;  //!< model of the previous frame; empty: none
    int lastInliers;
    std::vector<double> errors;
    double samples, cpuMs;  //!< sums
    int failed, sequences, lost;
    bool isLost;  //!< true if all frames since the jump have failed so far
};

}  // namespace benchmark

#endif
