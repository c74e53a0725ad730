// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/bits.hpp"
#include "numeric/selection.hpp"
#include "local_optimization/inlier_set.hpp"

namespace cv {
namespace usacv20 {

void InlierSet::within(const Context& context, const Model& model, double multiple)
{
    const Correspondences& points = context.points;
    const float limit = (float)(multiple * multiple * points.threshold * points.threshold);
    context.components.residual->squaredErrors(points, model, 0, points.size, errors);
    count = 0;
    // one word of bits for 64 points, because a branch for each point would often be mispredicted
    for (int i = 0; i < points.size; i += WORD_BITS)
        for (uint64 word =
                 usacv20::within(errors + i, std::min(points.size - i, (int)WORD_BITS), limit);
             word; word &= word - 1)
            members[count++] = i + lowestOne(word);
}

int InlierSet::select(Rng& rng, int most)
{
    most = std::min(most, count);
    randomPart(members, count, most, rng);
    return most;
}

bool InlierSet::fit(const Context& context, int first, Model& model, int iterations) const
{
    return context.nonMinimalSolver().fit(context.points, members, first, 0, model, iterations);
}

bool InlierSet::improve(const Context& context, int first, Model& model, Quality& quality,
                        int iterations) const
{
    Model fitted = model;
    return fit(context, first, fitted, iterations) && keepBetter(context, fitted, model, quality);
}

bool keepBetter(const Context& context, const Model& candidate, Model& model, Quality& quality)
{
    const Quality rated = context.rate(candidate, quality.cost);
    if (!rated.betterThan(quality))
        return false;
    model = candidate;
    quality = rated;
    return true;
}

}  // namespace usacv20
}  // namespace cv
