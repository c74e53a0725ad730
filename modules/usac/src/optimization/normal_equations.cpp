// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "scoring/kernels.hpp"
#include "optimization/normal_equations.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Normal equations of the error of a projection by a 3 x N matrix, from the sums of its kernel:
the upper triangle of p p^T for the homogeneous point p, times 1, u, v, u^2 + v^2; the gradient; the
cost. */
template <int N>
void fromProjectionSums(const double* sums, NormalEquationsOf<3 * N>& equations)
{
    enum { PRODUCTS = N * (N + 1) / 2 };
    equations.JtJ.setZero();
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j)
        {
            const int low = std::min(i, j), n = low * N - low * (low - 1) / 2 + std::abs(i - j);
            equations.JtJ(i, j) = equations.JtJ(N + i, N + j) = sums[n];
            equations.JtJ(2 * N + i, j) = -sums[PRODUCTS + n];
            equations.JtJ(2 * N + i, N + j) = -sums[2 * PRODUCTS + n];
            equations.JtJ(2 * N + i, 2 * N + j) = sums[3 * PRODUCTS + n];
        }
    for (int i = 0; i < 3 * N; ++i)
        equations.Jtr[i] = sums[4 * PRODUCTS + i];
    equations.JtJ.template triangularView<Eigen::StrictlyUpper>() = equations.JtJ.transpose();
    equations.cost = sums[4 * PRODUCTS + 3 * N];
}

//! Normal equations of the Sampson or the symmetric epipolar distance, from the sums of its kernel.
//! The residual is the tenth column of J, so the last row of the triangle is gradient and cost.
void fromEpipolarSums(const double* sums, NormalEquations& equations)
{
    for (int row = 0, n = 0; row < 9; ++row)
        for (int col = 0; col <= row; ++col)
            equations.JtJ(row, col) = sums[n++];
    for (int i = 0; i < 9; ++i)
        equations.Jtr[i] = sums[45 + i];
    equations.JtJ.triangularView<Eigen::StrictlyUpper>() = equations.JtJ.transpose();
    equations.cost = sums[54];
}

/** Adds the normal equations of the transfer error in image 1, which are in the entries of
G = H^-1. As dG = -G dH G, the derivatives with respect to H (entries in row-major order) are the
derivatives with respect to G times the Kronecker product -G (x) G^T. */
void addInverse(const NormalEquations& inverse, const Matx33d& G, NormalEquations& equations)
{
    Eigen::Matrix<double, 9, 9, Eigen::RowMajor> L;
    for (int i = 0; i < 9; ++i)
        for (int j = 0; j < 9; ++j)
            L(i, j) = -G(i / 3, j / 3) * G(j % 3, i % 3);
    equations.JtJ += L.transpose() * inverse.JtJ * L;
    equations.Jtr += L.transpose() * inverse.Jtr;
    equations.cost += inverse.cost;
}

//! Normal equations of a residual without kernels, point by point.
template <int SIZE>
void addPoints(const Residual& residual, const PointChunks& points, const Model& model,
               NormalEquationsOf<SIZE>& equations)
{
    double datum[MAX_COLUMNS], weight, error[Residual::MAX_COMPONENTS],
        derivative[Residual::MAX_COMPONENTS * SIZE];
    equations.JtJ.setZero();
    equations.Jtr.setZero();
    equations.cost = 0;
    for (int i = 0; points.get(i, datum, weight); ++i)
    {
        const int components = residual.linearize(model, datum, error, derivative);
        for (int k = 0; k < components; ++k)
        {
            const Eigen::Map<const Eigen::Matrix<double, SIZE, 1>> row(derivative + SIZE * k);
            equations.JtJ += weight * row * row.transpose();
            equations.Jtr += weight * error[k] * row;
            equations.cost += weight * error[k] * error[k];
        }
    }
}

double costOfPoints(const Residual& residual, const PointChunks& points, const Model& model)
{
    double datum[MAX_COLUMNS], weight, error[Residual::MAX_COMPONENTS], cost = 0;
    for (int i = 0; points.get(i, datum, weight); ++i)
    {
        const int components = residual.error(model, datum, error);
        for (int k = 0; k < components; ++k)
            cost += weight * error[k] * error[k];
    }
    return cost;
}

}  // namespace

template <>
void NormalEquationsOf<9>::accumulate(const Residual& residual, const PointChunks& points,
                                      const Model& model)
{
    const Residual::Kind kind = residual.kind();
    if (kind == Residual::CUSTOM)
    {
        addPoints(residual, points, model, *this);
        return;
    }
    const SumsKernel kernel = kernels().sums[kind];
    double sums[EPIPOLAR_SUMS];
    if (kind == Residual::SAMPSON || kind == Residual::SYMMETRIC_EPIPOLAR)
    {
        points.sum(kernel, EPIPOLAR_SUMS, model.val, false, sums);
        fromEpipolarSums(sums, *this);
        return;
    }
    points.sum(kernel, TRANSFER_SUMS, model.val, false, sums);
    fromProjectionSums<3>(sums, *this);
    if (kind == Residual::SYMMETRIC_TRANSFER)
    {
        const Matx33d G = Matx33d(model).inv();
        NormalEquations inverse;
        points.sum(kernel, TRANSFER_SUMS, G.val, true, sums);
        fromProjectionSums<3>(sums, inverse);
        addInverse(inverse, G, *this);
    }
}

template <>
void NormalEquationsOf<12>::accumulate(const Residual& residual, const PointChunks& points,
                                       const Model& model)
{
    if (residual.kind() != Residual::REPROJECTION)
    {
        addPoints(residual, points, model, *this);
        return;
    }
    double sums[REPROJECTION_SUMS];
    points.sum(kernels().sums[Residual::REPROJECTION], REPROJECTION_SUMS, model.val, false, sums);
    fromProjectionSums<4>(sums, *this);
}

template <int SIZE>
double NormalEquationsOf<SIZE>::costOf(const Residual& residual, const PointChunks& points,
                                       const Model& model)
{
    const Residual::Kind kind = residual.kind();
    const SumsKernel kernel = kind == Residual::CUSTOM ? 0 : kernels().costs[kind];
    if (!kernel)
        return costOfPoints(residual, points, model);
    double cost, back = 0;
    points.sum(kernel, 1, model.val, false, &cost);
    if (kind == Residual::SYMMETRIC_TRANSFER)
        points.sum(kernel, 1, Matx33d(model).inv().val, true, &back);
    return cost + back;
}

template struct NormalEquationsOf<9>;
template struct NormalEquationsOf<12>;

}  // namespace usacv20
}  // namespace cv
