// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_JUDGE_HPP
#define OPENCV_USACV20_BENCHMARK_JUDGE_HPP

#include "image_pair.hpp"
#include "method.hpp"
#include "support/scenes.hpp"

namespace benchmark {

//! The judgment on one model.
struct Verdict
{
    bool worse;    //!< the cost exceeds that of the true model by more than half the cost of an
                   //!< outlier
    bool failed;   //!< a search failure: worse, and more than 1 % of the true model's inliers have
                   //!< errors of more than two thresholds
    bool far;      //!< `error` is above three thresholds and above three standard deviations of the
                   //!< noise
    bool wrong;    //!< H, F: same as `far`, whatever the cost is; E: pose error above 5 degrees
    bool none;     //!< there is no model; `worse`, `failed`, `far` and `wrong` are then true, too
    double error;  //!< RMS distance of the noise-free right matches from the model, pixels;
                   //!< infinite without a model
    double poseError;  //!< degrees; negative for H and F
};

/** Compares models with the true model of a scene.

Two models are candidates for the true model: the model that the scene was made with, and its
least-squares fit to the right matches. The one with the lower cost is used. The cost is that of
MSAC, the sum of min(1, (error / threshold)^2) over all matches. */
class Judge
{
public:
    //! @param noise standard deviation of the scene's noise, pixels
    Judge(const opencv_test::Scene& scene, const ImagePair& pair, const Settings& settings,
          double noise);

    Verdict judge(const Estimate& estimate) const;

    const cv::Mat& trueModel() const { return best; }

    //! The least-squares fit to all right matches. The errors of methods are compared with the
    //! errors of this model.
    const cv::Mat& leastSquares() const { return fit; }

private:
    double costOf(const cv::Mat& model) const;
    //! Distance in pixels of a match, with its noise, from a model.
    double distance(const cv::Mat& model, int row) const;
    //! Makes this model the true model if its cost is lower.
    void offer(const cv::Mat& model);
    //! True if nearly all inliers of the true model are close to this model, too.
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
