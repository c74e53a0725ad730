// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_CALIBRATION_HPP
#define OPENCV_USACV20_BENCHMARK_CALIBRATION_HPP

#include <string>
#include "known_scene.hpp"

namespace benchmark {

/** How well covariances describe the errors of models: counts over scenes. */
class Calibration
{
public:
    Calibration();

    //! Makes a scene, estimates, and counts the result. @param widening see KnownScene::run
    void add(const SceneCell& cell, int seed, const cv::usacv20::Params& params, double widening);
    void add(const Calibration& other);

    int models() const { return determined; }
    //! Mean squared Mahalanobis distance over the degrees of freedom: 1 if calibrated.
    double mean() const { return sum / determined; }
    //! Part of the models within the region of 95 %.
    double inside() const { return (double)within / determined; }
    //! Mean estimated noise over the true one, of the scenes where it was estimated.
    double sigma() const { return sigmas / estimated; }

    static std::string header();  //!< of a Markdown table, after the column that names the row
    std::string row() const;

private:
    int scenes, none, wrong, unknown;
    int determined, within, estimated;
    double sum, sigmas;
};

}  // namespace benchmark

#endif
