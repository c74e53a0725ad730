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
    /** As BEGIN_WITH_LAST. If this gives no model, or a model with less than half the number of
    inliers of the previous frame's model, the frame is estimated again without an initial model and
    with the problem's default limit of iterations. If the previous frame has no model, only this
    second estimate is made. */
    BEGIN_WITH_LAST_OR_AGAIN
};

/** A way to estimate the models of a sequence, and statistics of its results so far. */
class Tracker
{
public:
    //! @param maxIterations limit of iterations for each frame
    Tracker(ProblemType problem, Beginning beginning, int maxIterations);

    //! Estimates the model of the next frame. @param afterJump true for all frames after the sudden
    //! change of the camera's pose in the sequence
    void track(const ImagePair& frame, int seed, bool afterJump);
    //! Starts a sequence; must be called before its first frame.
    void restart();

    Beginning begins() const { return beginning; }
    int limit() const { return params.maxIterations; }

    double medianError() const;   //!< median over the frames; the error of a failure is infinite
    double failures() const;      //!< percentage of frames that failed
    double meanSamples() const;   //!< per frame
    double meanCpuMs() const;     //!< per frame
    double meanRecovery() const;  //!< number of frames between the jump and the first success after
                                  //!< it (all frames after the jump if none succeeds); mean over
                                  //!< the sequences
    int frames() const { return (int)errors.size(); }

private:
    Estimate estimate(const ImagePair& frame, const cv::usacv20::Params& with);
    //! Repeats an estimate, outside of the measured time, to add its number of samples to
    //! `samples`.
    void count(const ImagePair& frame, const cv::usacv20::Params& with);
    void judge(const ImagePair& frame, const Estimate& found, bool afterJump);

    const ProblemType problem;
    const Beginning beginning;
    cv::usacv20::Params params;
    cv::Mat last;  //!< model of the previous frame; empty: none
    int lastInliers;
    std::vector<double> errors;
    double samples, cpuMs;        //!< sums over the frames
    int failed, sequences, lost;  //!< lost: sum of the numbers that meanRecovery() averages
    bool isLost;                  //!< true if all frames since the jump have failed so far
};

}  // namespace benchmark

#endif
