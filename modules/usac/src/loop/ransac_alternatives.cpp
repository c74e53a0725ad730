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
        commonNeighbors(context.points, compared, common, context.arena);
        Model core;
        if (neighborlyCore(context, common, compared, state.best, core))
            offerCore(core);
    }
    const int* const order = orderIsKnown(context) ? state.bestFirst(context) : 0;
    const Alternative* const chosen = alternatives.chosen(context, order, common);
    if (!chosen)
        return;
    // the model must be valid, but no check may replace it with a model of lower cost
    const Candidate candidate = chosen->candidate;
    Model checked = candidate.model;
    Quality quality = candidate.quality;
    if (recover(0, checked, quality))
        setBest(candidate.model, candidate.quality, chosen->sampled ? &candidate.sample : 0);
}

void Ransac::offerCore(const Model& core)
{
    Quality quality = context.rate(core);
    for (int d = 0; d < checkCount; ++d)
        checks[d]->discount(context, core, quality);
    offer(core, quality, 0);
}

}  // namespace usacv20
}  // namespace cv
