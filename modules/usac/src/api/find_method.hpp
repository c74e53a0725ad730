// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_FIND_METHOD_HPP
#define OPENCV_USACV20_FIND_METHOD_HPP

// Shared by the functions with an argument `method`.

#include "opencv2/usac/params.hpp"

namespace cv {
namespace usacv20 {

//! The options that a flag stands for, combined with the other arguments of calib3d's functions. A
//! number that is not a flag of this module raises a cv::Exception; `name` is the name of the
//! argument in its message.
Params paramsOf(UsacV20Method method, double threshold, double confidence, int maxIterations,
                const char* name = "method");

/** True if a number is a flag of this module. False if it may be a flag of OpenCV, that is, from 0
to 63 (OpenCV 4.6 uses 0 to 38; later versions may have more). Any other number raises a
cv::Exception, because calib3d does not always do so: for F and E it treats unknown numbers as
LMedS. `name` is the name of the argument in the message. */
bool isOurs(int method, const char* name = "method");

}  // namespace usacv20
}  // namespace cv

#endif
