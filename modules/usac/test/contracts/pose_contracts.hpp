// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_POSE_CONTRACTS_HPP
#define OPENCV_USACV20_TEST_POSE_CONTRACTS_HPP

#include "problems/absolute_pose/pose_scenes.hpp"
#include "support/contracts.hpp"

namespace opencv_test {

//! An estimation of the scene, for the oracle.
EstimatorCall callOf(const PoseScene& scene, const Params& params);

//! One estimation, of which the oracle must have nothing to say.
Mat checkedPose(const PoseScene& scene, const Params& params, Mat& mask, Report& report);

/** Every preset and every flag on the scene: no exception, what is promised of the result, the same
bits again and with any number of threads, input as it was. @return the poses of the presets */
std::vector<Mat> checkEveryWay(const PoseScene& scene, double pixels = 2, int maxIterations = 100);

}  // namespace opencv_test

#endif
