// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_RIGID_ORACLE_HPP
#define OPENCV_USACV20_TEST_RIGID_ORACLE_HPP

#include "support/result_oracle.hpp"

namespace opencv_test {

/** Says in words what is wrong with a motion of space that is not empty, or with its mask, "" if
nothing is: a rotation within 1e-9, times a scale above 0 where the problem has one, and a
translation; 1 in the mask exactly where the distance in space 2 is at most `threshold`, as far as
the rounding to double leaves it decided. */
std::string brokenMotion(const EstimatorCall& call, double threshold, const cv::Mat& model,
                         const cv::Mat& mask);

}  // namespace opencv_test

#endif
