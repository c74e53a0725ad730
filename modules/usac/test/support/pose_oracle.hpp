// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_POSE_ORACLE_HPP
#define OPENCV_USACV20_TEST_POSE_ORACLE_HPP

#include "support/result_oracle.hpp"

namespace opencv_test {

/** Checks a pose that is not empty, and its mask. R must be a rotation matrix up to 1e-9. The mask
must be 1 exactly where the point is in front of the camera, the lens shows it, and its projection
by cv::projectPoints is at most `threshold` pixels from the given image point. Rows are not checked
where rounding of the pose and of the points can change the answer, according to a bound from the
derivatives of cv::projectPoints, or where the point is close to a fold of the lens.
@return a description of the mistake, or an empty string if there is none */
std::string brokenPose(const EstimatorCall& call, double threshold, const cv::Mat& model,
                       const cv::Mat& mask);

}  // namespace opencv_test

#endif
