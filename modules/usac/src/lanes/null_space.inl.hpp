// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

/* Computes the matrices that satisfy the epipolar constraints of the points of a sample, for
several samples at once, each in one lane of the vector registers (see pack.inl.hpp). No include
guard: lanes/lane_kernels.inl.hpp includes this file once for each instruction set. */

namespace cv {
namespace usacv20 {
namespace {

//! Computes the matrix A of the constraints x2^T M x1 = 0 of ROWS points, one sample in each lane.
//! Lanes beyond `count` repeat the last sample. A is stored by columns.
template <int ROWS>
void epipolarRows(const Correspondences& points, const int* const* samples, int count,
                  Pack (&A)[9][ROWS])
{
    for (int i = 0; i < ROWS; ++i)
    {
        Pack p[4];
        for (int c = 0; c < 4; ++c)
        {
            double values[WIDTH];
            for (int k = 0; k < WIDTH; ++k)
                values[k] = points.exact[c][samples[k < count ? k : count - 1][i]];
            p[c] = load(values);
        }
        const Pack x1 = p[X1], y1 = p[Y1], x2 = p[X2], y2 = p[Y2];
        const Pack row[9] = {x2 * x1, x2 * y1, x2, y2 * x1, y2 * y1, y2, x1, y1, everywhere(1)};
        for (int k = 0; k < 9; ++k)
            A[k][i] = row[k];
    }
}

/** @brief Null space of a matrix with more columns than rows, by Gauss-Jordan elimination; the
pivot of a row is its element of largest magnitude @cite golub2013matrix.

@param A columns of the matrix; overwritten
@param basis output, 9 - ROWS vectors; each has a 1 at a position where the other vectors have a 0
@return the lanes in which the rank is ROWS, that is, the magnitudes of all pivots are more than
1e-9 times the largest magnitude in A. */
template <int ROWS>
Mask nullSpace(Pack (&A)[9][ROWS], Pack (&basis)[9 - ROWS][9])
{
    Pack scale = Pack(), chosen[ROWS];
    for (int j = 0; j < 9; ++j)
        for (int i = 0; i < ROWS; ++i)
            scale = largerOf(scale, absolute(A[j][i]));
    const Pack least = 1e-9 * scale;
    Mask full = least == least;
    for (int k = 0; k < ROWS; ++k)
    {
        Pack best = everywhere(k), most = absolute(A[k][k]);
        for (int j = k + 1; j < 9; ++j)
        {
            const Pack size = absolute(A[j][k]);
            best = size > most ? everywhere(j) : best;
            most = largerOf(most, size);
        }
        full &= most > least;  // false in a lane with NaN
        chosen[k] = best;
        for (int j = k + 1; j < 9; ++j)
            exchange(best == (double)j, 0, A[k], A[j]);
        const Pack inverse = 1. / A[k][k];
        for (int j = k + 1; j < 9; ++j)
        {
            const Pack factor = A[j][k] * inverse;
            for (int i = 0; i < ROWS; ++i)
                A[j][i] -= factor * A[k][i];
            A[j][k] = factor;
        }
    }
    Pack rows[9][9 - ROWS];
    for (int k = 0; k < 9; ++k)
        for (int v = 0; v < 9 - ROWS; ++v)
            rows[k][v] = k < ROWS ? -A[ROWS + v][k] : everywhere(k == ROWS + v);
    for (int k = ROWS - 1; k >= 0; --k)  // restores the original order of the columns
        for (int j = k + 1; j < 9; ++j)
            exchange(chosen[k] == (double)j, 0, rows[k], rows[j]);
    for (int k = 0; k < 9; ++k)
        for (int v = 0; v < 9 - ROWS; ++v)
            basis[v][k] = rows[k][v];
    return full;
}

}  // namespace
}  // namespace usacv20
}  // namespace cv
