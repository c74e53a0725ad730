// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ROBUST_FRAME_HPP
#define OPENCV_USACV20_ROBUST_FRAME_HPP

#include "opencv2/usac/arena.hpp"

namespace cv {
namespace usacv20 {

/** Center, deviation and range of values in random order. Center and deviation are means, or
medians if values far out would dominate the means: single values, or so many that the spread of the
others is negligible beside the mean deviation. */
void robustFrame(const double* values, int count, double& center, double& deviation, double& low,
                 double& high, Arena& arena);

}  // namespace usacv20
}  // namespace cv

#endif
