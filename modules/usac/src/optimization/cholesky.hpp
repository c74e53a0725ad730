// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CHOLESKY_HPP
#define OPENCV_USACV20_CHOLESKY_HPP

#include <Eigen/Cholesky>

namespace cv {
namespace usacv20 {

//! Computes column K of the decomposition A = L D L^T of an N x N matrix and the columns after it.
//! D is diagonal; the diagonal of L is 1.
template <int N, int K>
struct CholeskyColumns
{
    //! @param A columns of a symmetric matrix, from which the columns before K have been
    //! eliminated; overwritten
    //! @param x right-hand side, from which the unknowns before K have been eliminated; from entry
    //! K on, becomes the solution
    static bool solve(double (&A)[N][N], double (&x)[N])
    {
        const double pivot = A[K][K];
        if (!(pivot > 0 && pivot <= DBL_MAX))
            return false;
        const double inverse = 1 / pivot;
        double column[N];  // of L
        for (int i = K + 1; i < N; ++i)
            column[i] = A[K][i] * inverse;
        for (int i = K + 1; i < N; ++i)
            x[i] -= column[i] * x[K];
        // updates both triangles: with loops of constant length, this is faster than updating one
        // triangle
        for (int j = K + 1; j < N; ++j)
            for (int i = K + 1; i < N; ++i)
                A[j][i] -= column[j] * A[K][i];
        x[K] *= inverse;
        if (!CholeskyColumns<N, K + 1>::solve(A, x))
            return false;
        for (int i = K + 1; i < N; ++i)
            x[K] -= column[i] * x[i];
        return true;
    }
};

template <int N>
struct CholeskyColumns<N, N>
{
    static bool solve(double (&)[N][N], double (&)[N]) { return true; }
};

/** @brief Solves A x = b for a symmetric positive definite matrix by its Cholesky decomposition
without square roots @cite golub2013matrix. For the few unknowns of a fit, this takes a fraction of
the time of Eigen::LLT, whose loops are made for large matrices.
@param A the matrix; overwritten
@param x b, replaced by x
@return false if A is not positive definite or not finite; rounding errors can hide that A is
singular */
template <int N>
bool solvePositiveDefinite(Eigen::Matrix<double, N, N>& A, Eigen::Matrix<double, N, 1>& x)
{
    return CholeskyColumns<N, 0>::solve(*reinterpret_cast<double(*)[N][N]>(A.data()),
                                        *reinterpret_cast<double(*)[N]>(x.data()));
}

//! The same for a matrix whose size is not known at compile time.
template <class Matrix, class Vector>
bool solvePositiveDefinite(Matrix& A, Vector& x)
{
    const Eigen::LLT<Matrix> llt(A);
    llt.solveInPlace(x);
    return llt.info() == Eigen::Success;
}

}  // namespace usacv20
}  // namespace cv

#endif
