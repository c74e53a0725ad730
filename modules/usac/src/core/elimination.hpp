// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ELIMINATION_HPP
#define OPENCV_USACV20_ELIMINATION_HPP

#include <algorithm>
#include <cmath>

namespace cv {
namespace usacv20 {

/** @brief Null space of a matrix with more columns than rows, by Gauss-Jordan elimination; the
pivot of a row is its largest element @cite golub2013matrix. The matrix is stored by columns, so
that all loops over rows have a fixed length and are vectorized.

@param A columns of the matrix, ROWS elements padded with zeros; overwritten
@param basis output, COLS - ROWS vectors; each has a 1 where the others have a 0
@return false if the rank is below ROWS: a pivot is at most 1e-9 times the largest element.
*/
template <int ROWS, int COLS, int PADDED>
bool nullSpace(double (&A)[COLS][PADDED], double (&basis)[COLS - ROWS][COLS])
{
    double largest[PADDED] = {0}, scale = 0;
    for (int j = 0; j < COLS; ++j)
        for (int i = 0; i < PADDED; ++i)
            largest[i] = std::max(largest[i], std::abs(A[j][i]));
    for (int i = 0; i < ROWS; ++i)
        scale = std::max(scale, largest[i]);
    const double least = 1e-9 * scale;
    int order[COLS];  // columns after the swaps
    for (int j = 0; j < COLS; ++j)
        order[j] = j;
    for (int k = 0; k < ROWS; ++k)
    {
        int best = k;
        double most = std::abs(A[k][k]);
        for (int j = k + 1; j < COLS; ++j)
            if (std::abs(A[j][k]) > most)
            {
                best = j;
                most = std::abs(A[j][k]);
            }
        if (!(most > least))  // also for NaN
            return false;
        std::swap(order[k], order[best]);
        double pivot[PADDED];
        std::copy(A[best], A[best] + PADDED, pivot);
        std::copy(A[k], A[k] + PADDED, A[best]);
        const double inverse = 1 / pivot[k];
        for (int j = k + 1; j < COLS; ++j)
        {
            const double factor = A[j][k] * inverse;
            for (int i = 0; i < PADDED; ++i)
                A[j][i] -= factor * pivot[i];
            A[j][k] = factor;
        }
    }
    for (int v = 0; v < COLS - ROWS; ++v)
    {
        for (int k = 0; k < ROWS; ++k)
            basis[v][order[k]] = -A[ROWS + v][k];
        for (int k = ROWS; k < COLS; ++k)
            basis[v][order[k]] = k == ROWS + v;
    }
    return true;
}

}  // namespace usacv20
}  // namespace cv

#endif
