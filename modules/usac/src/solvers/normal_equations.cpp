// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "residuals/kernels.hpp"
#include "solvers/normal_equations.hpp"

namespace cv {
namespace usacv20 {

namespace {

void fromTransferSums(const double* sums, NormalEquations& equations)
{
    static const int SYMMETRIC[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    equations.JtJ.setZero();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
        {
            const int n = SYMMETRIC[i][j];
            equations.JtJ(i, j) = equations.JtJ(3 + i, 3 + j) = sums[n];
            equations.JtJ(6 + i, j) = -sums[6 + n];
            equations.JtJ(6 + i, 3 + j) = -sums[12 + n];
            equations.JtJ(6 + i, 6 + j) = sums[18 + n];
        }
    for (int i = 0; i < 9; ++i)
        equations.Jtr[i] = sums[24 + i];
    equations.cost = sums[33];
}

//! The residual is the tenth column of J: the last row of the triangle holds the gradient and the cost.
void fromSampsonSums(const double* sums, NormalEquations& equations)
{
    for (int row = 0, n = 0; row < 9; ++row)
        for (int col = 0; col <= row; ++col)
            equations.JtJ(row, col) = sums[n++];
    for (int i = 0; i < 9; ++i)
        equations.Jtr[i] = sums[45 + i];
    equations.cost = sums[54];
}

} // namespace

void NormalEquations::accumulate(ProblemType problem, const Correspondences& points, const int* indices, int count,
                                 const double* weights, const Model& model)
{
    double chunk[5][SUMS_CHUNK], sums[SAMPSON_SUMS] = {0};
    const SumsKernel add = kernels().sums[problem == HOMOGRAPHY ? Residual::TRANSFER : Residual::SAMPSON];
    for (int start = 0; start < count; start += SUMS_CHUNK)
    {
        for (int k = 0; k < SUMS_CHUNK; ++k)
        {
            const int at = std::min(start + k, count - 1), i = indices[at];
            chunk[0][k] = points.dx1[i];
            chunk[1][k] = points.dy1[i];
            chunk[2][k] = points.dx2[i];
            chunk[3][k] = points.dy2[i];
            chunk[4][k] = start + k >= count ? 0 : weights ? weights[at] : 1;
        }
        add(chunk, model.val, sums);
    }
    if (problem == HOMOGRAPHY)
        fromTransferSums(sums, *this);
    else
        fromSampsonSums(sums, *this);
    JtJ.triangularView<Eigen::StrictlyUpper>() = JtJ.transpose();
}

} // namespace usacv20
} // namespace cv
