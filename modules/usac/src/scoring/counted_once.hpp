// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_COUNTED_ONCE_HPP
#define OPENCV_USACV20_COUNTED_ONCE_HPP

#include "components/point_subset.hpp"

namespace cv {
namespace usacv20 {

/** @brief Lowers the quality (inliers and cost) of a model as if a subset had at most `kept`
inliers. Its points are no independent evidence: repetitions of a match, or matches at one place.

@param kept 1: they count once; 0: not at all, because a point outside the subset represents them
@param subset the dependent points
@param model the model that was scored
@param quality input and output: inliers and cost of all points. The score must be a sum over the
points, see Score::wholeModel() */
void countOnce(const Context& context, int kept, PointSubset& subset, const Model& model,
               Quality& quality);

}  // namespace usacv20
}  // namespace cv

#endif
