// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_REACH_HPP
#define OPENCV_USACV20_REACH_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! The reach (the ratio of the search threshold to the mask threshold, see Params::reach) changes
//! if the suitable reach is more than REACH_GROWS times or less than REACH_SHRINKS times the
//! current reach. See doc/constants.md.
constexpr double REACH_GROWS = 1.5, REACH_SHRINKS = 0.7;

//! The reach that suits the errors of the best model, between Params::reach and
//! Params::widestReach; `current` if there is no model.
//! @param current present reach of the search
double suitableReach(const Context& context, const State& state, double current);

}  // namespace usacv20
}  // namespace cv

#endif
