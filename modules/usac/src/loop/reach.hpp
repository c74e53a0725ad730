// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_REACH_HPP
#define OPENCV_USACV20_REACH_HPP

#include "input/problem_data.hpp"
#include "loop/ransac.hpp"

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

/** @brief Searches with a reach that grows if the errors of the best model show wide noise.

The noise is estimated when the search ends, and once after half of Params::maxIterations, because
with a reach that is far too small, models have few inliers, and no criterion ends the search. The
noise is not estimated earlier, because the best model might then still be a wrong model with larger
errors, for example between two planes. At the end the reach can also shrink again, because the
noise that was estimated from the errors of a poor model is too large.
@param data the points; their reach changes
@param ransac the search; it has not begun */
void searchWithReach(const Context& context, const State& state, ProblemData& data, Ransac& ransac);

}  // namespace usacv20
}  // namespace cv

#endif
