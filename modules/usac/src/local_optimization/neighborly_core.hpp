// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NEIGHBORLY_CORE_HPP
#define OPENCV_USACV20_NEIGHBORLY_CORE_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Finds the model of those inliers of a model that have neighbors in common in both images
(commonNeighbors()).

If wrong matches along the epipolar lines have made a model wrong, most of its inliers are still
right: those that have common neighbors, and hardly any others. Random samples of them are compared
by their cost on these inliers only; the best model is then fitted to its inliers among the first
points of the run, which are a random subset.
@param common common neighbors of the first `count` points
@param best the model
@param core output, in coordinates of the search
@return false if there are too few such inliers, or if no model of a sample is valid */
bool neighborlyCore(const Context& context, const uchar* common, int count, const Model& best,
                    Model& core);

}  // namespace usacv20
}  // namespace cv

#endif
