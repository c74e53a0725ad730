// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PRIOR_HPP
#define OPENCV_USACV20_PRIOR_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Densest points first, see DensityPrior.
Ptr<Prior> createDensityPrior();
//! Best Params::scores first.
Ptr<Prior> createScorePrior();
//! As the caller sorted them.
Ptr<Prior> createInputOrderPrior();

} // namespace usacv20
} // namespace cv

#endif
