// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ELIMINATION_HPP
#define OPENCV_USACV20_ELIMINATION_HPP

#include <algorithm>
#include <cmath>

namespace cv {
namespace usacv20 {

/** @brief Null space of a matrix with more columns than rows, by Gauss-Jordan elimination; the pivot of a row is its largest
element @cite golub2013matrix. The matrix is given column by column: all loops over rows have a fixed length and become vector code.

@param A columns of the matrix, the ROWS elements filled up with zeros; destroyed
@param basis output, COLS - ROWS vectors; each has a 1 where the others have a 0
@return false if the rank is lower than ROWS: a pivot is not above 1e-9 times the largest element. */
template <int ROWS, int COLS, int PADDED>
bool nullSpace(double (&A)[COLS][PADDED], double (&basis)[COLS - ROWS][COLS])
{
    double least = 0;
    for (int j = 0; j < COLS; ++j)
        for (int i = 0; i < ROWS; ++i)
            least = std::max(least, std::abs(A[j][i]));
    least *= 1e-9;
    int order[COLS];  // of the columns
    for (int j = 0; j < COLS; ++j)
        order[j] = j;
    for (int k = 0; k < ROWS; ++k)
    {
        int best = k;
        for (int j = k + 1; j < COLS; ++j)
            if (std::abs(A[order[j]][k]) > std::abs(A[order[best]][k]))
                best = j;
        std::swap(order[k], order[best]);
        double pivot[PADDED];
        std::copy(A[order[k]], A[order[k]] + PADDED, pivot);
        if (!(std::abs(pivot[k]) > least))  // also for NaN
            return false;
        const double inverse = 1 / pivot[k];
        for (int j = k + 1; j < COLS; ++j)
        {
            double* const column = A[order[j]];
            const double factor = column[k] * inverse;
            for (int i = 0; i < PADDED; ++i)
                column[i] -= factor * pivot[i];
            column[k] = factor;
        }
    }
    for (int v = 0; v < COLS - ROWS; ++v)
    {
        for (int k = 0; k < ROWS; ++k)
            basis[v][order[k]] = -A[order[ROWS + v]][k];
        for (int k = ROWS; k < COLS; ++k)
            basis[v][order[k]] = k == ROWS + v;
    }
    return true;
}

} // namespace usacv20
} // namespace cv

#endif
