// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "motion_kind.hpp"

#include <cmath>

namespace benchmark {

namespace {

const double MAX_ROTATION_ERROR = 5;  //!< degrees; an estimate with a larger error is a failure
const double MAX_CENTER_ERROR = 5;    //!< percent; an estimate with a larger error is a failure

}  // namespace

double MotionKind::failureLimit(const ImagePair&) const { return MAX_ROTATION_ERROR; }

double MotionKind::poseError(const ImagePair& pair, const Estimate& estimate) const
{
    const double error = modelError(pair, estimate.model);
    return std::isfinite(error) ? error : 180;
}

bool MotionKind::failed(const ImagePair& pair, double error, double center) const
{
    return ProblemKind::failed(pair, error, center) || !(center <= MAX_CENTER_ERROR);
}

}  // namespace benchmark
