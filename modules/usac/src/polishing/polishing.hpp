// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_POLISHING_HPP
#define OPENCV_USACV20_POLISHING_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Tests of a point, as Watch counts them, that a fit to its end takes for each: 100 ns of a
//! million. Half, double: as those of Watch.
constexpr double FIT_WORK = 50;

//! See LeastSquaresPolisher.
Ptr<Polisher> createLeastSquaresPolisher();
//! See ReweightedPolisher.
Ptr<Polisher> createReweightedPolisher();
//! See RobustPolisher.
Ptr<Polisher> createRobustPolisher();

}  // namespace usacv20
}  // namespace cv

#endif
