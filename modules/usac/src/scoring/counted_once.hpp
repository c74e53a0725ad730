// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_COUNTED_ONCE_HPP
#define OPENCV_USACV20_COUNTED_ONCE_HPP

#include "core/point_subset.hpp"

namespace cv {
namespace usacv20 {

/** @brief Points that are no independent evidence (one match several times, matches of one place):
lowers a quality as if no more than `kept` of those that are inliers were there.

@param kept 1: they count once; 0: not at all, as a point that is not among them stands for them
@param subset these points
@param model that the quality is of
@param quality in, out: inliers and cost of all points. The score must be a sum over the points
(Score::wholeModel()) */
void countOnce(const Context& context, int kept, PointSubset& subset, const Model& model,
               Quality& quality);

}  // namespace usacv20
}  // namespace cv

#endif
