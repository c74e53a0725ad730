// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_REPETITIONS_HPP
#define OPENCV_USACV20_REPETITIONS_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Tests of a point, as Watch counts them, that each point takes of which both arrays are looked
//! at: 150 ns of a million. Half, double: as those of Watch.
constexpr double REPETITION_WORK = 75;

/** @brief Number of inliers that are independent of each other: those of one place count once.

A place is a cell of side `threshold1` in array 1 and `threshold2` in array 2, of `coordinates`
numbers each; the smaller of the numbers of places counts, so that neither repeated matches nor many
points that match one give a model support. `mask` marks the inliers among the `count` points.
O(count). */
int independentInliers(const double* const* columns, const int* coordinates, const uchar* mask,
                       int count, double threshold1, double threshold2, Arena& arena);

/** Marks in `repeated` those inliers of one array that lie in a cell of side `side` with an earlier
one; 0: that are equal to it. `mask` and `repeated` are in the order of `order`, null for 0, 1, 2,
... @return their number, those marked before included. */
int markRepeated(const double* const* columns, int dimensions, const int* order, const uchar* mask,
                 int count, double side, uchar* repeated, Arena& arena);
//! Those of either array, whose points are the same within the threshold, see Problem::commonUnit.
int markRepeated(const Correspondences& points, const int* order, const uchar* mask, int count,
                 double threshold, uchar* repeated, Arena& arena);

}  // namespace usacv20
}  // namespace cv

#endif
