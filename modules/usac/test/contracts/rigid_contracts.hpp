// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_RIGID_CONTRACTS_HPP
#define OPENCV_USACV20_TEST_RIGID_CONTRACTS_HPP

#include "problems/rigid_motion/rigid_scenes.hpp"
#include "support/contracts.hpp"

namespace opencv_test {

//! What an estimation gives.
struct Estimate
{
    Mat model, mask;
    Report report;

    Matx34d motion() const { return Matx34d(model); }
};

//! By the public function of the problem.
Mat estimateMotion(ProblemType type, InputArray points1, InputArray points2, const Params& params,
                   OutputArray mask, Report& report);
Estimate estimate(ProblemType type, const RigidScene& scene, const Params& params);

//! An estimation of the scene, for the oracle.
EstimatorCall callOf(ProblemType type, const RigidScene& scene, const Params& params);

//! One estimation, of which the oracle must have nothing to say.
Estimate checkedMotion(ProblemType type, const RigidScene& scene, const Params& params);

/** Every preset on the scene: no exception, what is promised of the result, the same bits again and
with any number of threads, input as it was. @return the motions of the presets */
std::vector<Mat> checkEveryWay(ProblemType type, const RigidScene& scene, double limit,
                               int maxIterations = 100);

}  // namespace opencv_test

#endif
