// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ORDERING_HPP
#define OPENCV_USACV20_ORDERING_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Densest points first, see DensityOrdering.
Ptr<Ordering> createDensityOrdering();
//! Best Params::scores first.
Ptr<Ordering> createScoreOrdering();
//! In the caller's order, see InputOrderOrdering.
Ptr<Ordering> createInputOrderOrdering();

/** Moves matches that equal an earlier one to the end of the order: they add no information, and a
growing set that contains only copies of one match gives no valid sample. The other matches keep
their order. O(N), by a hash table. */
void repeatedLast(const Context& context, int* order);

}  // namespace usacv20
}  // namespace cv

#endif
