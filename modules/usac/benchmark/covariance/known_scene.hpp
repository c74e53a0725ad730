// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_KNOWN_SCENE_HPP
#define OPENCV_USACV20_BENCHMARK_KNOWN_SCENE_HPP

#include <string>
#include <vector>
#include "opencv2/usac.hpp"

namespace benchmark {

//! Properties that a group of scenes (a cell) shares; its scenes differ only in their seeds.
struct SceneCell
{
    cv::usacv20::ProblemType problem;
    std::string shape;  //!< H, A, S, T: plane; F, E: general, forward, plane50; E also plane95; P,
                        //!< R, M: cloud or plane (letters: see letterOf())
    int size;           //!< number of matches
    double ratio;       //!< inlier ratio
    double noise;  //!< standard deviation of each component of a right match's error, divided by
                   //!< the threshold
    double threshold;  //!< pixels; R, M: in the unit in which the cloud is a cube of side 2
    double spread;     //!< noise of every second match, divided by that of the others; if it is not
                       //!< 1, the estimator gets these ratios as Params::sigmas
    //! True: `spread` is instead the noise of each image point along a random direction, divided by
    //! that across it; the estimator gets the points' covariances as Params::sigmas. Not for R, M.
    bool directed;
};

/** A synthetic scene with its true model, and an estimate that is compared with the true model. */
class KnownScene
{
public:
    //! @return true if the problem has scenes of this shape
    static bool has(cv::usacv20::ProblemType problem, const std::string& shape);

    KnownScene(const SceneCell& cell, int seed);

    //! Runs the estimator. @param widening ratio of the estimator's threshold to that of the cell
    //! @return false if the estimator finds no model
    bool run(const cv::usacv20::Params& options, double widening);
    /** The squared Mahalanobis distance of the true model from the estimated one under
    Report::covariance, C: x^T C^-1 x with the least-squares solution x of tangentOfModel * x =
    (entries of the true model) - (entries of the estimate). NaN if C is not determined. */
    double squaredDistance() const;
    //! Root mean square distance of the noise-free true matches from the model, in thresholds of
    //! the cell. A large value shows that the estimated model is wrong.
    double error() const { return error(model); }
    //! error() if the estimator does not get Params::sigmas. The estimator's threshold is then
    //! multiplied by SceneCell::spread, to fit the larger noise. Infinite if there is no model.
    double errorWithoutSigmas(const cv::usacv20::Params& options, double widening) const;
    //! error() of the least-squares fit to the right matches, with errors divided by their true
    //! standard deviations.
    double errorOfFit() const;

    const cv::usacv20::Report& report() const { return learned; }

private:
    void spreadNoise(const cv::Mat& exact1, const cv::Mat& exact2, int seed);
    void stretchNoise(const cv::Mat& exact, int row, double angle, cv::Mat& points);
    cv::Ptr<cv::usacv20::Usac> create(const cv::usacv20::Params& options, double threshold) const;
    double error(const cv::Mat& found) const;

    const SceneCell cell;
    cv::Mat points1, points2;    //!< matrices of N rows with 2 or 3 coordinates
    cv::Mat clean1, clean2;      //!< the true matches, without noise
    std::vector<uchar> inliers;  //!< 1 where a match is right
    std::vector<float> sigmas;   //!< Params::sigmas; empty if the noise of all matches is equal
    cv::Mat K, truth, model;     //!< truth: the true model; model: the estimate
    cv::usacv20::Report learned;
};

}  // namespace benchmark

#endif
