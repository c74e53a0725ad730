// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "residual/kernels.hpp"
#include "residual/normal_equations.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Computes the normal equations for a residual without kernels, point by point.
template <int SIZE>
void addPoints(const Residual& residual, const PointChunks& points, const Model& model,
               NormalEquationsOf<SIZE>& equations)
{
    double datum[MAX_COLUMNS], weight, error[Residual::MAX_COMPONENTS], derivative[MAX_DERIVATIVE];
    const int numbers = model.size();
    equations.JtJ.setZero(numbers, numbers);
    equations.Jtr.setZero(numbers);
    equations.cost = 0;
    for (int i = 0; points.get(i, datum, weight); ++i)
    {
        const int components = residual.linearize(model, datum, error, derivative);
        for (int k = 0; k < components; ++k)
        {
            const Eigen::Map<const Eigen::Matrix<double, SIZE, 1>> row(derivative + numbers * k,
                                                                       numbers);
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

template <int SIZE>
void NormalEquationsOf<SIZE>::accumulate(const Residual& residual, const PointChunks& points,
                                         const Model& model)
{
    const ResidualKernels* const kernels = residual.kernels();
    if (!kernels)
    {
        addPoints(residual, points, model, *this);
        return;
    }
    CV_Assert(kernels->columns == points.width());  // the row after the columns has the weights
    double sums[MAX_SUMS];
    JtJ.resize(model.size(), model.size());
    Jtr.resize(model.size());
    points.sum(kernels->sums, kernels->count, model.val, sums);
    kernels->toEquations(sums, JtJ.data(), Jtr.data(), cost);
}

template <int SIZE>
double NormalEquationsOf<SIZE>::costOf(const Residual& residual, const PointChunks& points,
                                       const Model& model)
{
    if (!residual.kernels())
        return costOfPoints(residual, points, model);
    CV_Assert(residual.kernels()->columns == points.width());
    double cost;
    points.sum(residual.kernels()->cost, 1, model.val, &cost);
    return cost;
}

template struct NormalEquationsOf<9>;
template struct NormalEquationsOf<12>;
template struct NormalEquationsOf<Eigen::Dynamic>;

}  // namespace usacv20
}  // namespace cv
