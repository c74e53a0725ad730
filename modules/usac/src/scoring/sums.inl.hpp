// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

/* Gauss-Newton sums of the geometric errors over a chunk of points, in loops that compilers
vectorize. No include guard: compiled once for each instruction set by scoring/kernels.inl.hpp. The
caller adds the lanes of each sum in a fixed order. */

namespace cv {
namespace usacv20 {
namespace {

//! Squared error of a point behind the camera: larger than any sum of squared errors of points in
//! front of it.
constexpr double BEHIND = 1e200;

//! Adds a[i] b[i] to the lanes.
inline void addProducts(const double* USAC_RESTRICT a, const double* USAC_RESTRICT b,
                        double* USAC_RESTRICT lanes)
{
    double sum[SUMS_LANES];
    for (int k = 0; k < SUMS_LANES; ++k)
        sum[k] = lanes[k];
    for (int i = 0; i < SUMS_CHUNK; i += SUMS_LANES)
    {
        USAC_SIMD
        for (int k = 0; k < SUMS_LANES; ++k)
            sum[k] += a[i + k] * b[i + k];
    }
    for (int k = 0; k < SUMS_LANES; ++k)
        lanes[k] = sum[k];
}

//! Adds a[0] b[0], a[0] b[1], a[1] b[0] and a[1] b[1] to their lanes; reads each value once.
inline void addProducts(const double (*USAC_RESTRICT a)[SUMS_CHUNK],
                        const double (*USAC_RESTRICT b)[SUMS_CHUNK], double* USAC_RESTRICT lanes00,
                        double* USAC_RESTRICT lanes01, double* USAC_RESTRICT lanes10,
                        double* USAC_RESTRICT lanes11)
{
    double sum00[SUMS_LANES], sum01[SUMS_LANES], sum10[SUMS_LANES], sum11[SUMS_LANES];
    for (int k = 0; k < SUMS_LANES; ++k)
    {
        sum00[k] = lanes00[k];
        sum01[k] = lanes01[k];
        sum10[k] = lanes10[k];
        sum11[k] = lanes11[k];
    }
    for (int i = 0; i < SUMS_CHUNK; i += SUMS_LANES)
    {
        USAC_SIMD
        for (int k = 0; k < SUMS_LANES; ++k)
        {
            sum00[k] += a[0][i + k] * b[0][i + k];
            sum01[k] += a[0][i + k] * b[1][i + k];
            sum10[k] += a[1][i + k] * b[0][i + k];
            sum11[k] += a[1][i + k] * b[1][i + k];
        }
    }
    for (int k = 0; k < SUMS_LANES; ++k)
    {
        lanes00[k] = sum00[k];
        lanes01[k] = sum01[k];
        lanes10[k] = sum10[k];
        lanes11[k] = sum11[k];
    }
}

/** Transfer error: residuals (u - x2, v - y2) with (u, v) the perspective division of H x1. Their
derivatives with respect to the rows of H are p / w times (1, 0, -u) and (0, 1, -v), with p = (x1,
y1, 1), so that all blocks of J^T J are multiples of p p^T / w^2. sums: the 6 different entries of
p p^T times 1, u, v, u^2 + v^2 (24); the gradient (9); the cost. */
void transferSums(const double (*chunk)[SUMS_CHUNK], const double* m, double (*sums)[SUMS_LANES])
{
    const double *x = chunk[0], *y = chunk[1], *x2 = chunk[2], *y2 = chunk[3], *weight = chunk[4];
    double pp[6][SUMS_CHUNK], factor[4][SUMS_CHUNK], p[3][SUMS_CHUNK], g[3][SUMS_CHUNK],
        cost[SUMS_CHUNK];
    USAC_SIMD
    for (int i = 0; i < SUMS_CHUNK; ++i)
    {
        const double w = 1 / (m[6] * x[i] + m[7] * y[i] + m[8]);
        const double u = (m[0] * x[i] + m[1] * y[i] + m[2]) * w,
                     v = (m[3] * x[i] + m[4] * y[i] + m[5]) * w;
        const double ru = u - x2[i], rv = v - y2[i], ww = weight[i] * w * w;
        pp[0][i] = ww * x[i] * x[i];
        pp[1][i] = ww * x[i] * y[i];
        pp[2][i] = ww * x[i];
        pp[3][i] = ww * y[i] * y[i];
        pp[4][i] = ww * y[i];
        pp[5][i] = ww;
        factor[0][i] = 1;
        factor[1][i] = u;
        factor[2][i] = v;
        factor[3][i] = u * u + v * v;
        p[0][i] = x[i];
        p[1][i] = y[i];
        p[2][i] = 1;
        g[0][i] = weight[i] * w * ru;
        g[1][i] = weight[i] * w * rv;
        g[2][i] = -(u * g[0][i] + v * g[1][i]);
        cost[i] = weight[i] * (ru * ru + rv * rv);
    }
    for (int f = 0; f < 4; f += 2)
        for (int j = 0; j < 6; j += 2)
        {
            double(*const first)[SUMS_LANES] = sums + 6 * f + j,
                          (*const second)[SUMS_LANES] = first + 6;
            addProducts(factor + f, pp + j, first[0], first[1], second[0], second[1]);
        }
    for (int row = 0; row < 3; ++row)
        for (int j = 0; j < 3; ++j)
            addProducts(g[row], p[j], sums[24 + 3 * row + j]);
    addProducts(cost, p[2], sums[33]);
}

//! The cost alone, in the first sum.
void transferCost(const double (*chunk)[SUMS_CHUNK], const double* m, double (*sums)[SUMS_LANES])
{
    const double *x = chunk[0], *y = chunk[1], *x2 = chunk[2], *y2 = chunk[3], *weight = chunk[4];
    double cost[SUMS_CHUNK];
    USAC_SIMD
    for (int i = 0; i < SUMS_CHUNK; ++i)
    {
        const double w = 1 / (m[6] * x[i] + m[7] * y[i] + m[8]);
        const double ru = (m[0] * x[i] + m[1] * y[i] + m[2]) * w - x2[i],
                     rv = (m[3] * x[i] + m[4] * y[i] + m[5]) * w - y2[i];
        cost[i] = ru * ru + rv * rv;
    }
    addProducts(cost, weight, sums[0]);
}

/** Reprojection error of a 3x4 camera matrix: like transferSums, with p = (X, Y, Z, 1). Points
behind the camera add nothing to the normal equations and BEHIND to the cost. sums: the 10 different
entries of p p^T times 1, u, v, u^2 + v^2 (40); the gradient (12); the cost. */
void reprojectionSums(const double (*chunk)[SUMS_CHUNK], const double* m,
                      double (*sums)[SUMS_LANES])
{
    const double *X = chunk[0], *Y = chunk[1], *Z = chunk[2], *x2 = chunk[3], *y2 = chunk[4],
                 *weight = chunk[5];
    double pp[10][SUMS_CHUNK], factor[4][SUMS_CHUNK], p[4][SUMS_CHUNK], g[3][SUMS_CHUNK],
        cost[SUMS_CHUNK];
    USAC_SIMD
    for (int i = 0; i < SUMS_CHUNK; ++i)
    {
        const double depth = m[8] * X[i] + m[9] * Y[i] + m[10] * Z[i] + m[11];
        const bool seen = depth > 0;
        const double w = seen ? 1 / depth : 0;
        const double u = (m[0] * X[i] + m[1] * Y[i] + m[2] * Z[i] + m[3]) * w,
                     v = (m[4] * X[i] + m[5] * Y[i] + m[6] * Z[i] + m[7]) * w;
        const double ru = u - x2[i], rv = v - y2[i], ww = weight[i] * w * w;
        pp[0][i] = ww * X[i] * X[i];
        pp[1][i] = ww * X[i] * Y[i];
        pp[2][i] = ww * X[i] * Z[i];
        pp[3][i] = ww * X[i];
        pp[4][i] = ww * Y[i] * Y[i];
        pp[5][i] = ww * Y[i] * Z[i];
        pp[6][i] = ww * Y[i];
        pp[7][i] = ww * Z[i] * Z[i];
        pp[8][i] = ww * Z[i];
        pp[9][i] = ww;
        factor[0][i] = 1;
        factor[1][i] = u;
        factor[2][i] = v;
        factor[3][i] = u * u + v * v;
        p[0][i] = X[i];
        p[1][i] = Y[i];
        p[2][i] = Z[i];
        p[3][i] = 1;
        g[0][i] = weight[i] * w * ru;
        g[1][i] = weight[i] * w * rv;
        g[2][i] = -(u * g[0][i] + v * g[1][i]);
        cost[i] = weight[i] * (seen ? ru * ru + rv * rv : BEHIND);
    }
    for (int f = 0; f < 4; f += 2)
        for (int j = 0; j < 10; j += 2)
        {
            double(*const first)[SUMS_LANES] = sums + 10 * f + j,
                          (*const second)[SUMS_LANES] = first + 10;
            addProducts(factor + f, pp + j, first[0], first[1], second[0], second[1]);
        }
    for (int row = 0; row < 3; ++row)
        for (int j = 0; j < 4; ++j)
            addProducts(g[row], p[j], sums[40 + 4 * row + j]);
    addProducts(cost, p[3], sums[52]);
}

//! The cost alone, in the first sum.
void reprojectionCost(const double (*chunk)[SUMS_CHUNK], const double* m,
                      double (*sums)[SUMS_LANES])
{
    const double *X = chunk[0], *Y = chunk[1], *Z = chunk[2], *x2 = chunk[3], *y2 = chunk[4],
                 *weight = chunk[5];
    double cost[SUMS_CHUNK];
    USAC_SIMD
    for (int i = 0; i < SUMS_CHUNK; ++i)
    {
        const double depth = m[8] * X[i] + m[9] * Y[i] + m[10] * Z[i] + m[11], w = 1 / depth;
        const double ru = (m[0] * X[i] + m[1] * Y[i] + m[2] * Z[i] + m[3]) * w - x2[i],
                     rv = (m[4] * X[i] + m[5] * Y[i] + m[6] * Z[i] + m[7]) * w - y2[i];
        cost[i] = depth > 0 ? ru * ru + rv * rv : BEHIND;
    }
    addProducts(cost, weight, sums[0]);
}

/** Epipolar distances: residual r = N / sqrt(D) with N = x2^T F x1 and D = a^2 + b^2 + d^2 + e^2
for Sampson's distance, where (a, b) are the first two entries of F x1 (FIRST) and (d, e) those of
F^T x2 (SECOND); one pair alone gives the distance to the line in one image. dr/dF = (x2 x1^T - N/D
((a, b, 0)^T x1^T + x2 (d, e, 0))) / sqrt(D). sums: the lower triangle of J^T J row by row (45); the
gradient (9); the cost. */
template <bool FIRST, bool SECOND>
void epipolarSums(const double (*chunk)[SUMS_CHUNK], const double* m, double (*sums)[SUMS_LANES])
{
    const double *x1 = chunk[0], *y1 = chunk[1], *x2 = chunk[2], *y2 = chunk[3], *weight = chunk[4];
    double J[10][SUMS_CHUNK], weighted[10][SUMS_CHUNK];  // the last row is the residual
    USAC_SIMD
    for (int i = 0; i < SUMS_CHUNK; ++i)
    {
        const double l0 = m[0] * x1[i] + m[1] * y1[i] + m[2],
                     l1 = m[3] * x1[i] + m[4] * y1[i] + m[5];
        const double N = x2[i] * l0 + y2[i] * l1 + m[6] * x1[i] + m[7] * y1[i] + m[8];
        const double a = FIRST ? l0 : 0, b = FIRST ? l1 : 0;
        const double d = SECOND ? m[0] * x2[i] + m[3] * y2[i] + m[6] : 0;
        const double e = SECOND ? m[1] * x2[i] + m[4] * y2[i] + m[7] : 0;
        // if both points are epipoles, N is 0, and without 1e-200 so would be D
        const double D = a * a + b * b + d * d + e * e + 1e-200;
        const double s = 1 / std::sqrt(D), q = N * s * s;
        const double left0 = s * (x2[i] - q * a), left1 = s * (y2[i] - q * b);
        const double right0 = s * q * d, right1 = s * q * e;
        J[0][i] = left0 * x1[i] - x2[i] * right0;
        J[1][i] = left0 * y1[i] - x2[i] * right1;
        J[2][i] = left0;
        J[3][i] = left1 * x1[i] - y2[i] * right0;
        J[4][i] = left1 * y1[i] - y2[i] * right1;
        J[5][i] = left1;
        J[6][i] = s * x1[i] - right0;
        J[7][i] = s * y1[i] - right1;
        J[8][i] = s;
        J[9][i] = N * s;
    }
    for (int row = 0; row < 10; ++row)
    {
        USAC_SIMD
        for (int i = 0; i < SUMS_CHUNK; ++i)
            weighted[row][i] = weight[i] * J[row][i];
    }
    for (int row = 0; row < 10; row += 2)
    {
        double(*const first)[SUMS_LANES] = sums + row * (row + 1) / 2,
                      (*const second)[SUMS_LANES] = first + row + 1;
        for (int col = 0; col < row; col += 2)
            addProducts(weighted + row, J + col, first[col], first[col + 1], second[col],
                        second[col + 1]);
        addProducts(weighted[row], J[row], first[row]);
        addProducts(weighted[row + 1], J[row], second[row]);
        addProducts(weighted[row + 1], J[row + 1], second[row + 1]);
    }
}

//! The cost of epipolarSums alone, in the first sum.
template <bool FIRST, bool SECOND>
void epipolarCost(const double (*chunk)[SUMS_CHUNK], const double* m, double (*sums)[SUMS_LANES])
{
    const double *x1 = chunk[0], *y1 = chunk[1], *x2 = chunk[2], *y2 = chunk[3], *weight = chunk[4];
    double cost[SUMS_CHUNK];
    USAC_SIMD
    for (int i = 0; i < SUMS_CHUNK; ++i)
    {
        const double a = m[0] * x1[i] + m[1] * y1[i] + m[2], b = m[3] * x1[i] + m[4] * y1[i] + m[5];
        const double d = m[0] * x2[i] + m[3] * y2[i] + m[6], e = m[1] * x2[i] + m[4] * y2[i] + m[7];
        const double N = x2[i] * a + y2[i] * b + m[6] * x1[i] + m[7] * y1[i] + m[8];
        const double D = (FIRST ? a * a + b * b : 0) + (SECOND ? d * d + e * e : 0) + 1e-200;
        cost[i] = N * N / D;
    }
    addProducts(cost, weight, sums[0]);
}

void sampsonSums(const double (*chunk)[SUMS_CHUNK], const double* m, double (*sums)[SUMS_LANES])
{
    epipolarSums<true, true>(chunk, m, sums);
}

void sampsonCost(const double (*chunk)[SUMS_CHUNK], const double* m, double (*sums)[SUMS_LANES])
{
    epipolarCost<true, true>(chunk, m, sums);
}

void symmetricEpipolarSums(const double (*chunk)[SUMS_CHUNK], const double* m,
                           double (*sums)[SUMS_LANES])
{
    epipolarSums<true, false>(chunk, m, sums);
    epipolarSums<false, true>(chunk, m, sums);
}

void symmetricEpipolarCost(const double (*chunk)[SUMS_CHUNK], const double* m,
                           double (*sums)[SUMS_LANES])
{
    epipolarCost<true, false>(chunk, m, sums);
    epipolarCost<false, true>(chunk, m, sums);
}

}  // namespace
}  // namespace usacv20
}  // namespace cv
