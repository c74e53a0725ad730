// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/point_subset.hpp"

namespace cv {
namespace usacv20 {

//! A custom residual, which has no kernels, may depend on the Correspondences of the run; therefore
//! it gets columns.
Quality DependentPoints::rate(const Context& context, const Model& model) const
{
    const Residual& residual = *context.components.residual;
    if (residual.kernels())
    {
        Correspondences view = copies;
        view.threshold = context.points.threshold;
        return Context(view, context.components, context.params, context.arena).rate(model);
    }
    Arena::Scope scope(context.arena);
    double* const errors = scope.take<double>(copies.size);
    float* const floats = scope.take<float>(copies.size);
    residual.squaredErrors(model, copies.exact, copies.size, errors);
    std::copy(errors, errors + copies.size, floats);
    Quality sum(0, 0);
    context.components.score->accumulate(
        floats, copies.size, (float)(context.points.threshold * context.points.threshold), sum);
    return sum;
}

void DependentPoints::countOnce(const Context& context, const Model& model, Quality& quality) const
{
    const Quality sum = rate(context, model);
    const int lost = sum.inliers - 1;
    if (lost <= 0)
        return;
    quality.cost += (copies.size - sum.cost) * lost / sum.inliers;
    quality.inliers = std::max(quality.inliers - lost, 1);
}

}  // namespace usacv20
}  // namespace cv
