// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ORDERING_HPP
#define OPENCV_USACV20_ORDERING_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Creates an ordering by the local density of the matches, see DensityOrdering.
Ptr<Ordering> createDensityOrdering();
//! Creates an ordering by Params::scores, with the best score first.
Ptr<Ordering> createScoreOrdering();
//! Creates an ordering that keeps the order of the caller's arrays, see InputOrderOrdering.
Ptr<Ordering> createInputOrderOrdering();

}  // namespace usacv20
}  // namespace cv

#endif
