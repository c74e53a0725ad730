// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ROBUST_FRAME_HPP
#define OPENCV_USACV20_ROBUST_FRAME_HPP

#include "opencv2/usac/arena.hpp"

namespace cv {
namespace usacv20 {

/** Computes mean (`center`), mean absolute deviation from the mean (`deviation`), minimum (`low`)
and maximum (`high`) of values. If outlying values would dominate the means, `center` and
`deviation` are medians instead. Outlying values dominate if a single value is very far out, or if
the mean deviation is far larger than the spread of most values. This spread is estimated from the
first values, so the values must be in random order. All results are 0 if `count` is 0. */
void robustFrame(const double* values, int count, double& center, double& deviation, double& low,
                 double& high, Arena& arena);

}  // namespace usacv20
}  // namespace cv

#endif
