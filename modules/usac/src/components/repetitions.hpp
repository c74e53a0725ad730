// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_REPETITIONS_HPP
#define OPENCV_USACV20_REPETITIONS_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Time per point to find repetitions in both arrays, in tests of a point, the unit of Watch: 150
//! ns with a million points. It affects only how late a run with a time limit ends.
constexpr double REPETITION_WORK = 75;

/** @brief Number of independent inliers: those at the same place count once.

A place is a cell of side `threshold1` in array 1 and of side `threshold2` in array 2, which have
`coordinates` numbers per point. The inliers occupy some places in each array; the smaller of these
two numbers is returned, so that neither repeated matches nor many points matched to a single one
support a model. `mask` marks the inliers among the `count` points. O(count). */
int independentInliers(const double* const* columns, const int* coordinates, const uchar* mask,
                       int count, double threshold1, double threshold2, Arena& arena);

/** Marks in `repeated` the inliers of one array that lie in the same cell as an earlier inlier.
@param side of the cells; 0: only equal points are repeated
@param order indices of the points that `mask` and `repeated` are for; null: 0, 1, 2, ...
@return number of marked points, including those marked before */
int markRepeated(const double* const* columns, int dimensions, const int* order, const uchar* mask,
                 int count, double side, uchar* repeated, Arena& arena);
//! Does so for both arrays: marks inliers that repeat an earlier one in either array. The side is
//! the threshold, but 0 in the first array if its unit differs, see Problem::commonUnit.
int markRepeated(const Correspondences& points, const int* order, const uchar* mask, int count,
                 double threshold, uchar* repeated, Arena& arena);

}  // namespace usacv20
}  // namespace cv

#endif
