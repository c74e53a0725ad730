// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/selection.hpp"
#include "optimization/marginalized_fit.hpp"
#include "scoring/marginalized_weights.hpp"

namespace cv {
namespace usacv20 {

double MarginalizedFit::weigh(const Context& context, double threshold, const Model& model)
{
    const Correspondences& points = context.points;
    const MarginalizedWeights& table = MarginalizedWeights::of(points.problem->errorDimension());
    const float scale = (float)(1 / (threshold * threshold));
    context.components.residual->squaredErrors(points, model, 0, points.size, errors);
    count = 0;
    double loss = 0;
    for (int i = 0; i < points.size; ++i)
    {
        const float u = errors[i] * scale;
        loss += table.tabulatedLoss(u);
        if (!(u < 1))  // skips NaN, too
            continue;
        indices[count] = i;
        weights[count++] = table.tabulatedWeight(u);
    }
    return loss;
}

void MarginalizedFit::reduce(int most, Rng& rng)
{
    if (size() <= most)
        return;
    randomPart(size(), most, rng, [this](int i, int k) {
        std::swap(indices[i], indices[k]);
        std::swap(weights[i], weights[k]);
    });
    count = most;
}

bool MarginalizedFit::fit(const Context& context, Model& model) const
{
    return size() > context.components.minimalSolver->sampleSize() &&
           context.nonMinimalSolver().fit(context.points, indices, size(), weights, model);
}

}  // namespace usacv20
}  // namespace cv
