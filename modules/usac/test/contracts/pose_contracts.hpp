// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_POSE_CONTRACTS_HPP
#define OPENCV_USACV20_TEST_POSE_CONTRACTS_HPP

#include "problems/absolute_pose/pose_scenes.hpp"
#include "support/contracts.hpp"

namespace opencv_test {

//! Packs the scene and the parameters for the oracle brokenResult().
EstimatorCall callOf(const PoseScene& scene, const Params& params);

//! Runs one estimation. The oracle brokenResult() must find no error, and the input must not
//! change.
Mat checkedPose(const PoseScene& scene, const Params& params, Mat& mask, Report& report);

/** Runs every preset and every flag on the scene. Expects no exception, a result that satisfies all
contracts, the same bits when repeated (presets for one thread: also with 2 and 4 threads), and
unchanged input.
@return the poses of the presets */
std::vector<Mat> checkEveryWay(const PoseScene& scene, double pixels = 2, int maxIterations = 100);

}  // namespace opencv_test

#endif
