// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_RIGID_ORACLE_HPP
#define OPENCV_USACV20_TEST_RIGID_ORACLE_HPP

#include "support/result_oracle.hpp"

namespace opencv_test {

/** Checks the matrix [sR | t] of a 3-D motion, which is not empty, and its mask. R must be a
rotation within 1e-9, and s must be positive; for RIGID_3D, s must be 1 within 1e-9. The mask must
be 1 exactly where the distance in space 2 is at most `threshold`, and 0 where a point is not
finite. Rows for which rounding to double can change the answer are not checked.
@return a description of the mistake, or an empty string if there is none */
std::string brokenMotion(const EstimatorCall& call, double threshold, const cv::Mat& model,
                         const cv::Mat& mask);

}  // namespace opencv_test

#endif
