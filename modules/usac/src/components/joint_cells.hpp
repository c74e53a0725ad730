// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_JOINT_CELLS_HPP
#define OPENCV_USACV20_JOINT_CELLS_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Numbers of cells of an array: along each axis, and in total. See doc/constants.md.
constexpr int CELL_DIVISIONS = 8, CELLS = CELL_DIVISIONS * CELL_DIVISIONS;

//! Finds the cell of each point by its first two coordinates in an array; a single coordinate gives
//! one row of cells.
void assignCells(const Correspondences& points, int array, ushort* cells);

//! Numbers of pairs of points that lie in the same cell.
struct CellPairs
{
    //! Counts pairs of the points whose `mask` equals `value`, in cells with `merged` times the
    //! side; CELL_DIVISIONS must be a multiple of `merged`.
    CellPairs(const Correspondences& points, const uchar* mask, uchar value, Arena& arena,
              int merged = 1);

    int cells;         //!< number of cells of an array
    double all;        //!< all pairs of points
    double in[2];      //!< pairs that share a cell of array 1, and pairs that share one of array 2
    double both;       //!< pairs that share a cell in both arrays
    double expected;   //!< mean of `both` if the positions in the two arrays are independent
    double coherence;  //!< `both` divided by the geometric mean of `in`; 0 if that mean is 0
};

}  // namespace usacv20
}  // namespace cv

#endif
