// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CONFIRMED_ORDER_HPP
#define OPENCV_USACV20_CONFIRMED_ORDER_HPP

#include "core/joint_cells.hpp"
#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Do the inliers of a model come early in an order? Their rank sum against that of the
other points (Mann, Whitney), in standard deviations of what it is in an order that tells nothing.

The first m inliers do not count, as the model may have been made of them, nor do repeated ones.
@param inliers which of the `size` points are inliers, best point first
@param repeated which of them repeat an earlier one
@param size number of points
@param m size of a sample */
double orderEvidence(const uchar* inliers, const uchar* repeated, int size, int m);

/** @brief Would another motion be seen by its neighbors that stay neighbors? Where two motions are
as smooth as each other, its matches are in the same cell of both arrays as often as those of the
best model.
@param own pairs of inliers of the best model
@param rest pairs of the points that it does not explain
@param other number of matches of the other motion among these
@param left number of these
@return true if there are fewer pairs in common cells than the other motion would have */
bool otherMotionWouldShow(const CellPairs& own, const CellPairs& rest, double other, double left);

}  // namespace usacv20
}  // namespace cv

#endif
