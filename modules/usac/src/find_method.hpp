// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_FIND_METHOD_HPP
#define OPENCV_USACV20_FIND_METHOD_HPP

// What the functions with a `method` have in common; in find.cpp.

#include "opencv2/usac/params.hpp"

namespace cv {
namespace usacv20 {

//! The options of a flag, with the arguments that calib3d's functions have beside it. A number that
//! is no flag raises an exception; `name` is that of the argument.
Params paramsOf(UsacV20Method method, double threshold, double confidence, int maxIterations,
                const char* name = "method");

/** Whether a number is a flag of this module (true) or may be one of OpenCV's (false), which are 0
.. 38 in OpenCV 4.6 and have room up to 63. Any other number is a mistake that calib3d would not
always see, and raises an exception: F and E take what they do not know for LMedS. `name` is that of
the argument. */
bool isOurs(int method, const char* name = "method");

}  // namespace usacv20
}  // namespace cv

#endif
