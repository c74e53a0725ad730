// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_JOINT_CELLS_HPP
#define OPENCV_USACV20_JOINT_CELLS_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! The box of the points of an array is divided into CELL_DIVISIONS cells along each of two axes,
//! which gives CELLS cells in total. See doc/constants.md.
constexpr int CELL_DIVISIONS = 8, CELLS = CELL_DIVISIONS * CELL_DIVISIONS;

//! Finds the cell of each point from its first two coordinates in an array; a single coordinate
//! gives one row of cells.
void assignCells(const Correspondences& points, int array, ushort* cells);

//! Counts pairs of points that lie in the same cell.
struct CellPairs
{
    //! Counts pairs among the points whose entry of `mask` equals `value`. The side of the cells is
    //! enlarged by a factor of `merged`; CELL_DIVISIONS must be a multiple of `merged`.
    CellPairs(const Correspondences& points, const uchar* mask, uchar value, Arena& arena,
              int merged = 1);

    int cells;         //!< number of (enlarged) cells of an array
    double all;        //!< number of pairs of counted points
    double in[2];      //!< numbers of pairs in the same cell of the first array, and of the second
                       //!< array
    double both;       //!< number of pairs in the same cell in both arrays
    double expected;   //!< expected value of `both` if positions in the arrays are independent
    double coherence;  //!< `both` / geometric mean of in[0] and in[1]; 0 if this mean is 0
};

}  // namespace usacv20
}  // namespace cv

#endif
