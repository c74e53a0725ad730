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
element @cite golub2013matrix. All loops over columns have a fixed length and become vector code.

@param A the matrix; destroyed
@param basis output, COLS - ROWS vectors; each has a 1 where the others have a 0
@return false if the rank is lower than ROWS: a pivot is not above 1e-9 times the largest element. */
template <int ROWS, int COLS>
bool nullSpace(double (&A)[ROWS][COLS], double (&basis)[COLS - ROWS][COLS])
{
    int column[COLS];
    for (int j = 0; j < COLS; ++j)
        column[j] = j;
    double least = 0;
    for (int i = 0; i < ROWS; ++i)
        for (int j = 0; j < COLS; ++j)
            least = std::max(least, std::abs(A[i][j]));
    least *= 1e-9;
    for (int k = 0; k < ROWS; ++k)
    {
        int col = k;
        for (int j = k + 1; j < COLS; ++j)
            if (std::abs(A[k][j]) > std::abs(A[k][col]))
                col = j;
        if (!(std::abs(A[k][col]) > least))  // also for NaN
            return false;
        if (col != k)
        {
            for (int i = 0; i < ROWS; ++i)
                std::swap(A[i][col], A[i][k]);
            std::swap(column[col], column[k]);
        }
        const double inverse = 1 / A[k][k];
        for (int j = k + 1; j < COLS; ++j)
            A[k][j] *= inverse;
        for (int i = k + 1; i < ROWS; ++i)
        {
            const double factor = A[i][k];
            for (int j = k + 1; j < COLS; ++j)
                A[i][j] -= factor * A[k][j];
        }
    }
    for (int v = 0; v < COLS - ROWS; ++v)
    {
        double x[ROWS];
        for (int i = ROWS - 1; i >= 0; --i)
        {
            x[i] = -A[i][ROWS + v];
            for (int j = i + 1; j < ROWS; ++j)
                x[i] -= A[i][j] * x[j];
        }
        for (int j = 0; j < ROWS; ++j)
            basis[v][column[j]] = x[j];
        for (int j = ROWS; j < COLS; ++j)
            basis[v][column[j]] = j == ROWS + v;
    }
    return true;
}

} // namespace usacv20
} // namespace cv

#endif
