// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/point_subset.hpp"

namespace cv {
namespace usacv20 {

void countOnce(const Context& context, int kept, PointSubset& subset, const Model& model,
               Quality& quality)
{
    const int count = subset.size();
    const double* const errors = subset.squaredErrors(*context.components.residual, model);
    Arena::Scope scope(context.arena);
    float* const floats = scope.take<float>(count);
    std::copy(errors, errors + count, floats);
    Quality sum(0, 0);
    context.components.score->accumulate(
        floats, count, (float)(context.points.threshold * context.points.threshold), sum);
    const int lost = sum.inliers - kept;
    if (kept > 0 && lost <= 0)
        return;
    quality.cost += kept > 0 ? (count - sum.cost) * lost / sum.inliers : count - sum.cost;
    quality.inliers = std::max(quality.inliers - lost, kept);
}

}  // namespace usacv20
}  // namespace cv
