// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_SPACE_CONTRACTS_HPP
#define OPENCV_USACV20_TEST_SPACE_CONTRACTS_HPP

#include "problems/absolute_pose/pose_scenes.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"
#include "support/contracts.hpp"

// Functions for tests of absolute poses and 3-D motions.

namespace opencv_test {

struct Estimate
{
    Mat model, mask;
    Report report;

    Matx34d motion() const { return Matx34d(model); }
};

//! Packs the scene and the parameters for the following functions and for the oracle
//! brokenResult().
EstimatorCall callOf(const PoseScene& scene, const Params& params);
EstimatorCall callOf(ProblemType type, const RigidScene& scene, const Params& params);

//! Calls the estimate function of the problem.
Estimate estimate(const EstimatorCall& call);

//! Like estimate(). Expects a result that satisfies all contracts, and unchanged input.
Estimate checkedEstimate(const EstimatorCall& call);

/** Runs every preset and, for poses, every flag on the points of the call, with its threshold.
Expects no exception, a result that satisfies all contracts, the same bits when repeated (presets
for one thread: also with 2 and 4 threads), and unchanged input.
@return the models of the presets */
std::vector<Mat> checkEveryWay(const EstimatorCall& call, int maxIterations = 100);

}  // namespace opencv_test

#endif
