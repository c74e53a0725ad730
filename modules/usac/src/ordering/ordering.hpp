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

}  // namespace usacv20
}  // namespace cv

#endif
