// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_JOINT_CELLS_HPP
#define OPENCV_USACV20_JOINT_CELLS_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Cells of each array along its sides, and in all. For the order by density, 4 and 16: errors of H
//! +1 and +2 %, of E +5 and +3 %; 16: time +2 to +3 %.
constexpr int CELL_DIVISIONS = 8, CELLS = CELL_DIVISIONS * CELL_DIVISIONS;

//! The cell of each point by the first two coordinates of an array; where there are less, there is
//! one row of cells.
void assignCells(const Correspondences& points, int array, ushort* cells);

//! Pairs of points that have the same cell.
struct CellPairs
{
    //! Of the points whose `mask` has this value, in cells with `merged` times the sides, a divisor
    //! of CELL_DIVISIONS.
    CellPairs(const Correspondences& points, const uchar* mask, uchar value, Arena& arena,
              int merged = 1);

    int cells;         //!< of an array
    double all;        //!< pairs of points
    double in[2];      //!< those in one cell of array 1, of array 2
    double both;       //!< those in one cell of each
    double expected;   //!< `both`, on average, if the two have nothing to do with each other
    double coherence;  //!< part of the pairs in one cell of either array that are so in both; 0
                       //!< where there are none
};

}  // namespace usacv20
}  // namespace cv

#endif
