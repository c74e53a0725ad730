// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "solvers/normal_equations.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Transfer error: residuals (u - x2, v - y2) with (u, v) = p(H x1). The derivatives by the rows of H are p / w times
(1, 0, -u) and (0, 1, -v), with p = (x1, y1, 1): all blocks of JtJ are multiples of p p^T / w^2. */
void accumulateTransfer(const Correspondences& c, const int* indices, int count, const double* weights,
                        const Model& model, NormalEquations& sums)
{
    const double* m = model.val;
    // p p^T as 6 numbers, times 1, u, v, u^2 + v^2
    double S[4][6] = {{0}}, g[3][3] = {{0}}, cost = 0;
    for (int k = 0; k < count; ++k)
    {
        const int i = indices[k];
        const double x = c.dx1[i], y = c.dy1[i];
        const double w = 1 / (m[6] * x + m[7] * y + m[8]);
        const double u = (m[0] * x + m[1] * y + m[2]) * w, v = (m[3] * x + m[4] * y + m[5]) * w;
        const double ru = u - c.dx2[i], rv = v - c.dy2[i], weight = weights ? weights[k] : 1;
        const double ww = weight * w * w;
        const double pp[6] = {ww * x * x, ww * x * y, ww * x, ww * y * y, ww * y, ww};
        const double q = u * u + v * v;
        for (int j = 0; j < 6; ++j)
        {
            S[0][j] += pp[j];
            S[1][j] += u * pp[j];
            S[2][j] += v * pp[j];
            S[3][j] += q * pp[j];
        }
        const double a = weight * w * ru, b = weight * w * rv, d = -(u * a + v * b);
        g[0][0] += a * x; g[0][1] += a * y; g[0][2] += a;
        g[1][0] += b * x; g[1][1] += b * y; g[1][2] += b;
        g[2][0] += d * x; g[2][1] += d * y; g[2][2] += d;
        cost += weight * (ru * ru + rv * rv);
    }
    static const int AT[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    sums.JtJ.setZero();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
        {
            const int n = AT[i][j];
            sums.JtJ(i, j) = sums.JtJ(3 + i, 3 + j) = S[0][n];
            sums.JtJ(6 + i, j) = -S[1][n];
            sums.JtJ(6 + i, 3 + j) = -S[2][n];
            sums.JtJ(6 + i, 6 + j) = S[3][n];
        }
    for (int i = 0; i < 9; ++i)
        sums.Jtr[i] = g[i / 3][i % 3];
    sums.cost = cost;
}

/** Sampson distance: residual r = N / sqrt(D) with N = x2^T F x1 and D = a^2 + b^2 + d^2 + e^2, where (a, b) are the
first two entries of F x1 and (d, e) those of F^T x2. dr/dF = (x2 x1^T - N/D ((a, b, 0)^T x1^T + x2 (d, e, 0))) / sqrt(D). */
void accumulateSampson(const Correspondences& c, const int* indices, int count, const double* weights,
                       const Model& model, NormalEquations& sums)
{
    const double* m = model.val;
    double A[9][9] = {{0}}, g[9] = {0}, cost = 0;
    for (int k = 0; k < count; ++k)
    {
        const int i = indices[k];
        const double x1 = c.dx1[i], y1 = c.dy1[i], x2 = c.dx2[i], y2 = c.dy2[i], weight = weights ? weights[k] : 1;
        const double a = m[0] * x1 + m[1] * y1 + m[2], b = m[3] * x1 + m[4] * y1 + m[5];
        const double d = m[0] * x2 + m[3] * y2 + m[6], e = m[1] * x2 + m[4] * y2 + m[7];
        const double N = x2 * a + y2 * b + m[6] * x1 + m[7] * y1 + m[8];
        const double D = a * a + b * b + d * d + e * e;
        if (!(D > 1e-300))
            continue;  // both points at the epipoles: no information
        const double s = 1 / std::sqrt(D), q = N / D, r = N * s;
        const double left[3] = {s * (x2 - q * a), s * (y2 - q * b), s};
        const double right[3] = {s * q * d, s * q * e, 0};
        const double J[9] = {left[0] * x1 - x2 * right[0], left[0] * y1 - x2 * right[1], left[0],
                             left[1] * x1 - y2 * right[0], left[1] * y1 - y2 * right[1], left[1],
                             left[2] * x1 - right[0], left[2] * y1 - right[1], left[2]};
        for (int row = 0; row < 9; ++row)
        {
            const double wJ = weight * J[row];
            g[row] += wJ * r;
            for (int col = 0; col <= row; ++col)
                A[row][col] += wJ * J[col];
        }
        cost += weight * r * r;
    }
    for (int i = 0; i < 9; ++i)
    {
        sums.Jtr[i] = g[i];
        for (int j = 0; j < 9; ++j)
            sums.JtJ(i, j) = A[i][j];
    }
    sums.cost = cost;
}

} // namespace

void NormalEquations::accumulate(ProblemType problem, const Correspondences& points, const int* indices, int count,
                                 const double* weights, const Model& model)
{
    if (problem == HOMOGRAPHY)
        accumulateTransfer(points, indices, count, weights, model, *this);
    else
        accumulateSampson(points, indices, count, weights, model, *this);
    JtJ.triangularView<Eigen::StrictlyUpper>() = JtJ.transpose();
}

} // namespace usacv20
} // namespace cv
