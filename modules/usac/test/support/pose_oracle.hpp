// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_POSE_ORACLE_HPP
#define OPENCV_USACV20_TEST_POSE_ORACLE_HPP

#include "support/result_oracle.hpp"

namespace opencv_test {

/** Checks a pose that is not empty, and its mask. @return what is wrong in words, "" if nothing is
The pose must be a rotation within 1e-9 and a translation. The mask must be 1 exactly where a point
is in front of the camera, the lens shows it, and the distance of its image by cv::projectPoints is
at most `threshold` (pixels). Rows are not checked if the rounding of the pose and of the points may
move the image across the threshold, by the derivatives of cv::projectPoints. */
std::string brokenPose(const EstimatorCall& call, double threshold, const cv::Mat& model,
                       const cv::Mat& mask);

}  // namespace opencv_test

#endif
