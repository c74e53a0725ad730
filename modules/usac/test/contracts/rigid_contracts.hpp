// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_RIGID_CONTRACTS_HPP
#define OPENCV_USACV20_TEST_RIGID_CONTRACTS_HPP

#include "problems/rigid_motion/rigid_scenes.hpp"
#include "support/contracts.hpp"

namespace opencv_test {

//! The result of an estimation.
struct Estimate
{
    Mat model, mask;
    Report report;

    Matx34d motion() const { return Matx34d(model); }
};

//! Calls the estimate function of the problem.
Mat estimateMotion(ProblemType type, InputArray points1, InputArray points2, const Params& params,
                   OutputArray mask, Report& report);
Estimate estimate(ProblemType type, const RigidScene& scene, const Params& params);

//! Packs the scene and the parameters for the oracle brokenResult().
EstimatorCall callOf(ProblemType type, const RigidScene& scene, const Params& params);

//! Runs one estimation. The oracle brokenResult() must find no error, and the input must not
//! change.
Estimate checkedMotion(ProblemType type, const RigidScene& scene, const Params& params);

/** Runs every preset on the scene with the threshold `limit`. Expects no exception, a result that
satisfies all contracts, the same bits when repeated (presets for one thread: also with 2 and 4
threads), and unchanged input.
@return the motions of the presets */
std::vector<Mat> checkEveryWay(ProblemType type, const RigidScene& scene, double limit,
                               int maxIterations = 100);

}  // namespace opencv_test

#endif
