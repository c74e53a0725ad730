// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_REPETITIONS_HPP
#define OPENCV_USACV20_REPETITIONS_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Time per point to find repetitions in both arrays, in point tests of 2 ns, the unit of Watch:
//! 150 ns per point if there are a million points. The value only affects when a run with a time
//! limit ends.
constexpr double REPETITION_WORK = 75;

/** @brief Number of independent inliers: inliers in the same cell of an array count once.

Array 1 is divided into cells of side `threshold1` and array 2 into cells of side `threshold2`. The
cells that contain inliers are counted in each array, and the smaller of the two numbers is
returned, so that neither repeated matches nor many points matched to a single point add support to
a model. Takes O(count) time.
@param columns columns of array 1, then of array 2
@param coordinates number of coordinates per point in each array
@param mask marks the inliers among the `count` points
@param threshold1, threshold2 sides of the cells; 0: only equal points count as one */
int independentInliers(const double* const* columns, const int* coordinates, const uchar* mask,
                       int count, double threshold1, double threshold2, Arena& arena);

/** Marks in `repeated` the inliers of one array that lie in the same cell as an earlier inlier.
@param order entry i of `mask` and of `repeated` is for the point order[i]; null: for point i
@param mask marks the inliers
@param side side of the cells; 0: only points equal to an earlier point are marked
@return number of marked points, including points that were marked before the call */
int markRepeated(const double* const* columns, int dimensions, const int* order, const uchar* mask,
                 int count, double side, uchar* repeated, Arena& arena);

//! True if there is only one array and an error has as many components as a point has coordinates,
//! so that all inliers of a model are near one point. They then share a few cells, although they
//! are independent; therefore only equal points count as repetitions.
bool inliersAreNearAPoint(const Problem& problem);

//! markRepeated() for both arrays: marks inliers that repeat an earlier inlier in one of the
//! arrays. The side of the cells is `threshold`, in the coordinates of the last array (converted
//! for the first array), but 0 in the first array if its unit differs (see Problem::commonUnit),
//! and 0 if inliersAreNearAPoint().
int markRepeated(const Correspondences& points, const int* order, const uchar* mask, int count,
                 double threshold, uchar* repeated, Arena& arena);

//! Maximum number of frequent matches, see frequentMatches().
constexpr int MOST_FREQUENT = 9;

/** Finds frequent matches. All occurrences of a match are inliers of every model fitted to it, so
that repetitions of such a match would be much evidence for wrong models.
@param columns, numbers columns of the matches, and their number
@param rows, count rows of the matches, in random order
@param frequent output: a row of each frequent match
@return number of frequent matches */
int frequentMatches(const double* const* columns, int numbers, const int* rows, int count,
                    int* frequent);

//! True if the match in a row equals one of the frequent matches in other rows.
bool repeatsAny(const double* const* columns, int numbers, int row, const int* frequent, int count);

}  // namespace usacv20
}  // namespace cv

#endif
