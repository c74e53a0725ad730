// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_READ_ARRAYS_HPP
#define OPENCV_USACV20_READ_ARRAYS_HPP

#include "opencv2/usac/arena.hpp"

namespace cv {
namespace usacv20 {

/** @brief Reads the points of one of the caller's arrays, in any layout and depth that some
function of OpenCV accepts.
@param points N points
@param coordinates coordinates per point, 1 to 3; 2-D points can also be given by three homogeneous
coordinates
@param name name of the argument, for messages
@param scope memory for converted points
@param floats true: the result can be of depth CV_32F; `points` are then not copied
@return N x coordinates, CV_64F, continuous; the data are in memory of the scope or of `points`.
Raises cv::Exception for other layouts. */
Mat readPoints(const Mat& points, int coordinates, const char* name, Arena::Scope& scope,
               bool floats = false);

/** @brief Reads a camera matrix.
@param array 3x3, any depth; multiples of a camera matrix describe the same camera
@param name name of the argument, for messages
@return the matrix, scaled to the last row 0 0 1. Raises cv::Exception if `array` is not a camera
matrix. */
Matx33d readCamera(InputArray array, const char* name);

/** @brief Reads distortion coefficients as cv::undistortPoints accepts them.
@param array 4, 5, 8, 12 or 14 coefficients, or an empty array
@param name name of the argument, for messages
@return the coefficients; empty if there is no distortion. Raises cv::Exception for other arrays. */
Mat readDistortion(InputArray array, const char* name);

}  // namespace usacv20
}  // namespace cv

#endif
