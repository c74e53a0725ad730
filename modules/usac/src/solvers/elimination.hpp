// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ELIMINATION_HPP
#define OPENCV_USACV20_ELIMINATION_HPP

#include <algorithm>
#include <cmath>

namespace cv {
namespace usacv20 {

/** @brief Null space of a matrix with more columns than rows, by Gauss-Jordan elimination with full pivoting.

@param A the matrix; destroyed
@param basis output, COLS - ROWS vectors; each has a 1 where the others have a 0
@return false if the rank is lower than ROWS: no pivot above 1e-9 times the first one. @cite golub2013matrix */
template <int ROWS, int COLS>
bool nullSpace(double (&A)[ROWS][COLS], double (&basis)[COLS - ROWS][COLS])
{
    int column[COLS];
    for (int j = 0; j < COLS; ++j)
        column[j] = j;
    double first = 0;
    for (int k = 0; k < ROWS; ++k)
    {
        int row = k, col = k;
        double largest = -1;
        for (int i = k; i < ROWS; ++i)
            for (int j = k; j < COLS; ++j)
                if (std::abs(A[i][j]) > largest)
                {
                    largest = std::abs(A[i][j]);
                    row = i;
                    col = j;
                }
        if (k == 0)
            first = largest;
        if (!(largest > 1e-9 * first))  // also for NaN
            return false;
        if (row != k)
            std::swap_ranges(A[row], A[row] + COLS, A[k]);
        if (col != k)
        {
            for (int i = 0; i < ROWS; ++i)
                std::swap(A[i][col], A[i][k]);
            std::swap(column[col], column[k]);
        }
        const double inverse = 1 / A[k][k];
        for (int j = k + 1; j < COLS; ++j)
            A[k][j] *= inverse;
        for (int i = 0; i < ROWS; ++i)
        {
            if (i == k)
                continue;
            const double factor = A[i][k];
            for (int j = k + 1; j < COLS; ++j)
                A[i][j] -= factor * A[k][j];
        }
    }
    for (int v = 0; v < COLS - ROWS; ++v)
    {
        for (int j = 0; j < ROWS; ++j)
            basis[v][column[j]] = -A[j][ROWS + v];
        for (int j = ROWS; j < COLS; ++j)
            basis[v][column[j]] = j == ROWS + v;
    }
    return true;
}

} // namespace usacv20
} // namespace cv

#endif
