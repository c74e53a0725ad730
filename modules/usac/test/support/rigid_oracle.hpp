// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_RIGID_ORACLE_HPP
#define OPENCV_USACV20_TEST_RIGID_ORACLE_HPP

#include "support/result_oracle.hpp"

namespace opencv_test {

/** Checks a 3-D motion that is not empty, and its mask. @return a description of the mistake, or an
empty string if there is none. The motion must be a rotation within 1e-9, for SIMILARITY_3D times a
positive scale, and a translation. The mask must be 1 exactly where the distance in space 2 is at
most `threshold`. Rows for which rounding to double may change this are not checked. */
std::string brokenMotion(const EstimatorCall& call, double threshold, const cv::Mat& model,
                         const cv::Mat& mask);

}  // namespace opencv_test

#endif
