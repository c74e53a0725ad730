// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CAMERA_ARGUMENTS_HPP
#define OPENCV_USACV20_CAMERA_ARGUMENTS_HPP

#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

/** @brief Reads a camera matrix.
@param array 3x3, any depth; multiples of a camera matrix describe the same camera
@param name of the argument, for messages
@return the matrix with the last row 0 0 1. Raises cv::Exception if it is no camera matrix. */
Matx33d readCamera(InputArray array, const char* name);

/** @brief Reads distortion coefficients as cv::undistortPoints takes them.
@param array 4, 5, 8, 12 or 14 coefficients, or none
@param name of the argument, for messages
@return the coefficients; empty if there is no distortion. Raises cv::Exception for other arrays. */
Mat readDistortion(InputArray array, const char* name);

}  // namespace usacv20
}  // namespace cv

#endif
