// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_JUDGE_HPP
#define OPENCV_USACV20_BENCHMARK_JUDGE_HPP

#include "image_pair.hpp"
#include "method.hpp"
#include "support/scenes.hpp"

namespace benchmark {

//! What is to be said about one model.
struct Verdict
{
    bool worse;   //!< costs more than the true model
    bool failed;  //!< a search failure: worse, and another model than the true one
    bool far;  //!< RMS distance of the right matches without noise above three thresholds and three
               //!< times the noise
    bool wrong;    //!< H, F: `far`, even if its cost is lower; E: the pose is off by more than 5
                   //!< degrees
    bool none;     //!< no model; counts as worse, failed, far and wrong, too
    double error;  //!< RMS distance of the right matches without noise, pixels; infinite without a
                   //!< model
    double poseError;  //!< degrees; negative for H and F
};

/** Compares models with the one that made a scene.

The true model is the cheaper one of two: that which made the scene, and its least-squares fit to
the right matches. The cost is that of MSAC, the sum of min(1, (error / threshold)^2) over all
matches. */
class Judge
{
public:
    //! @param noise of the scene, pixels
    Judge(const opencv_test::Scene& scene, const ImagePair& pair, const Settings& settings,
          double noise);

    Verdict judge(const Estimate& estimate) const;

    const cv::Mat& trueModel() const { return best; }

    //! The least-squares fit to all right matches: what accuracy is measured by.
    const cv::Mat& leastSquares() const { return fit; }

private:
    double costOf(const cv::Mat& model) const;
    //! Distance of a match with noise from a model.
    double distance(const cv::Mat& model, int row) const;
    void offer(const cv::Mat& model);
    bool sameInliers(const cv::Mat& model) const;

    const opencv_test::Scene& scene;
    const ImagePair& pair;
    const Settings& settings;
    const double farLimit;  //!< pixels
    cv::Mat fit, best;
    double bestCost;
};

}  // namespace benchmark

#endif
