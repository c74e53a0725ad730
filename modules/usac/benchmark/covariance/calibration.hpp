// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_CALIBRATION_HPP
#define OPENCV_USACV20_BENCHMARK_CALIBRATION_HPP

#include <cmath>
#include <string>
#include "known_scene.hpp"

namespace benchmark {

/** Statistics over many scenes on how well covariances describe the errors of models. */
class Calibration
{
public:
    Calibration();

    //! Makes a scene, estimates its model, and counts the result. @param widening see
    //! KnownScene::run
    void add(const SceneCell& cell, int seed, const cv::usacv20::Params& params, double widening);
    void add(const Calibration& other);

    //! Number of models that are not wrong and whose covariance is determined.
    int models() const { return determined; }
    //! Mean of the squared Mahalanobis distance divided by the number of parameters; 1 if the
    //! covariance is calibrated.
    double mean() const { return sum / determined; }
    //! Fraction of the models() whose 95 % confidence region contains the true model.
    double inside() const { return (double)within / determined; }
    //! Mean ratio of estimated to true noise, over the scenes whose model is not wrong and whose
    //! noise was estimated.
    double sigma() const { return sigmas / estimated; }
    //! Geometric mean over scenes of the ratio of the model's error to that of weighted least
    //! squares over the right matches. It is defined only if SceneCell::spread is not 1. A scene is
    //! left out if its model is wrong or missing, or if the estimator without Params::sigmas has no
    //! model, or one with an error above 1000 thresholds.
    double relativeError() const { return std::exp(logs[0] / compared); }
    //! The same ratio for the estimator without Params::sigmas.
    double relativeErrorWithoutSigmas() const { return std::exp(logs[1] / compared); }

    //! The header of a Markdown table without the first two columns. @param withErrors whether the
    //! table has columns for the two relative errors
    static std::string header(bool withErrors);
    //! A row of this table. A mean over no scene is "-".
    std::string row(bool withErrors) const;

private:
    void compare(const KnownScene& scene, double error, const cv::usacv20::Params& params,
                 double widening);

    int scenes, none, wrong, unknown;  //!< numbers of scenes: all; without a model; with a wrong
                                       //!< model; with an undetermined covariance
    int determined, within, estimated;
    double sum, sigmas;
    int compared;
    double logs[2];  //!< sums of the logarithms of the two ratios
};

}  // namespace benchmark

#endif
