// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_REPEATED_LAST_HPP
#define OPENCV_USACV20_REPEATED_LAST_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** Moves matches that are the same as an earlier one of the order to its end: they say nothing new,
and a growing set of nothing but one match repeated has no sample. The others keep their order.
O(N), a hash table. */
void repeatedLast(const Context& context, int* order);

}  // namespace usacv20
}  // namespace cv

#endif
