// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/growth.hpp"
#include "local_optimization/neighborly_core.hpp"
#include "loop/ransac.hpp"
#include "scoring/common_neighbors.hpp"

namespace cv {
namespace usacv20 {

void Ransac::offer(const Model& model, const Quality& quality, const Sample* sample)
{
    if (alternatives.active() && quality.cost <= DBL_MAX)
        alternatives.offer(context, Candidate(sample ? *sample : Sample(), model, quality),
                           sample != 0);
}

void Ransac::chooseByRank()
{
    if (!alternatives.contested())
        return;  // nothing to decide, so no ranking of the points is needed
    const int compared = std::min(context.points.size, MATCHES_COMPARED);
    Arena::Scope scope(context.arena);
    uchar* common = 0;
    if (hasCommonNeighbors(*context.points.problem))
    {
        common = scope.take<uchar>(compared);
        commonNeighbors(context.points, compared, context.inlierThreshold(), common, context.arena);
        Model core;
        if (neighborlyCore(context, common, compared, state.best, core))
            offerCore(core);
    }
    const int* const order = orderIsKnown(context) ? state.bestFirst(context) : 0;
    const Alternative* const chosen = alternatives.chosen(context, order, common);
    if (chosen)
    {
        const Candidate candidate = chosen->candidate;
        setValid(candidate.model, chosen->sampled ? &candidate.sample : 0);
    }
}

//! Offers the result of neighborlyCore() as an alternative, unless it has a lower cost than the
//! best model: the two are then nearly the same model, and polishing makes the best model as good.
void Ransac::offerCore(const Model& core)
{
    const Quality quality = discounted(core, context.rate(core));
    if (!quality.betterThan(state.bestQuality))
        offer(core, quality, 0);
}

//! Makes a model the best one if no degeneracy check rejects it. If a check finds another model of
//! lower cost (Degeneracy::recover), that model is ignored, because here the ranking decides, not
//! the cost.
void Ransac::setValid(const Model& model, const Sample* sample)
{
    Model checked = model;
    const Quality quality = discounted(model, context.rate(model));
    Quality other = quality;
    if (recover(0, checked, other))
        setBest(model, quality, sample);
}

Quality Ransac::discounted(const Model& model, const Quality& rated) const
{
    Quality quality = rated;
    for (int d = 0; d < checkCount; ++d)
        checks[d]->discount(context, model, quality);
    return quality;
}

}  // namespace usacv20
}  // namespace cv
