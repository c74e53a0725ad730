// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NEIGHBORLY_CORE_HPP
#define OPENCV_USACV20_NEIGHBORLY_CORE_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Finds a model of those inliers of the best model that have neighbors in common in both
images (commonNeighbors()).

If wrong matches along the epipolar lines have made the best model wrong, most of its inliers are
still right matches. The inliers that have common neighbors are hardly ever wrong. Models of random
samples of these inliers are compared by their cost on these inliers only. The model of lowest cost
is then fitted to its inliers among the first points of the run, which are a random subset.
@param common commonNeighbors() of the first `count` points
@param best the best model
@param core output, in coordinates of the search
@return false if there are too few such inliers, if no model of a sample is valid, or if there is no
NonMinimalSolver */
bool neighborlyCore(const Context& context, const uchar* common, int count, const Model& best,
                    Model& core);

}  // namespace usacv20
}  // namespace cv

#endif
