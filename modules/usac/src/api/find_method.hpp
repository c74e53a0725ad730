// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_FIND_METHOD_HPP
#define OPENCV_USACV20_FIND_METHOD_HPP

// Shared by the functions that have a flag as argument `method` or `flags`.

#include "opencv2/usac/params.hpp"

namespace cv {
namespace usacv20 {

//! The options that a flag selects, combined with the other arguments of calib3d's functions. A
//! number that is not a flag of this module raises a cv::Exception; `name` is the argument's name
//! in the message.
Params paramsOf(UsacV20Method method, double threshold, double confidence, int maxIterations,
                const char* name = "method");

/** True for a flag of this module. False for the numbers 0 to 63, which might be flags of OpenCV
(OpenCV 4.6 uses 0 to 38; later versions might use more). Any other number raises a cv::Exception;
`name` is the argument's name in the message. calib3d does not always raise an exception: for F and
E, it treats unknown numbers as LMedS. */
bool isOurs(int method, const char* name = "method");

}  // namespace usacv20
}  // namespace cv

#endif
