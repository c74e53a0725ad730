// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "local_optimization/alternatives.hpp"
#include "components/growth.hpp"
#include "scoring/common_neighbors.hpp"
#include "scoring/order_likelihood.hpp"

namespace cv {
namespace usacv20 {

namespace {

// The gain of a model is defined in Alternative.

//! The gain of an alternative is at least this fraction of the largest gain of all models: NEAR if
//! the ranking is a known order of the points, NEAR_COMMON if it is by common neighbors.
constexpr double NEAR = 0.94, NEAR_COMMON = 0.6;
//! Two models have different inliers if, for at least one of them, more than this fraction of its
//! inliers are not inliers of the other model.
constexpr double DIFFERENT = 0.1;
//! An alternative shares at least this fraction of its inliers with the model of largest gain. A
//! model that shares fewer inliers describes another motion; the cost alone then decides.
constexpr double SHARED = 0.5;
//! For the ranking by common neighbors: at least this fraction of the inliers of an alternative are
//! not inliers of the model of largest gain.
constexpr double OWN = 0.04;
//! Weight of the log-likelihood of a ranking relative to the gain, to which an inlier without error
//! contributes 1. For comparison: with independent Gaussian errors and a threshold at their 0.95
//! quantile, one unit of MSAC's cost is a log-likelihood of 1.9 (errors with one component) or 3
//! (two components). A larger value gives the rankings more influence.
constexpr double WORTH = 1;
//! Minimum advantage of an alternative over the model of largest gain, in standard deviations of
//! the log-likelihood. Each point that is an inlier of only one of these two models changes the
//! log-likelihood by about 1 at random.
constexpr double DEVIATIONS = 2;
//! Maximum number of points from which the likelihood of the order is computed.
constexpr int LOOKED = 4096;

//! Number of points that are inliers of only one of two models, among the points of InlierBits.
int difference(const InlierBits& a, const InlierBits& b) { return a.without(b) + b.without(a); }

//! True if two models have nearly the same inliers, see DIFFERENT.
bool same(const InlierBits& a, const InlierBits& b)
{
    return a.without(b) <= DIFFERENT * a.count() && b.without(a) <= DIFFERENT * b.count();
}

//! Some points in an order, best point first, in which several points can have the same rank.
class Ranking
{
public:
    //! The points of a known order that are among the first LOOKED points of the run.
    Ranking(const Context& context_, const int* order, Arena::Scope& scope)
        : context(context_), looked(std::min(context.points.size, LOOKED)), size(0),
          sorted(scope.take<int>(looked)), ends(0)
    {
        for (int i = 0; i < context.points.size; ++i)
            if (order[i] < looked)
                sorted[size++] = order[i];
    }

    //! The first #MATCHES_COMPARED points of the run, by descending number of common neighbors.
    Ranking(const Context& context_, const uchar* common, Arena::Scope& scope)
        : context(context_), looked(std::min(context.points.size, MATCHES_COMPARED)), size(looked),
          sorted(scope.take<int>(looked)), ends(scope.take<uchar>(looked))
    {
        int at = 0;
        for (int level = NEIGHBORS_COMPARED; level >= 0; --level)
        {
            for (int i = 0; i < looked; ++i)
                if (common[i] == level)
                {
                    ends[at] = 0;
                    sorted[at++] = i;
                }
            if (at > 0)
                ends[at - 1] = 1;
        }
    }

    //! orderLogLikelihood() of all points for the inliers of `model`, extrapolated from the ranked
    //! points, which are a random subset.
    double likelihood(const Model& model) const
    {
        const Correspondences& p = context.points;
        Arena::Scope scope(context.arena);
        float* const errors = scope.take<float>(looked);
        uchar* const inliers = scope.take<uchar>(looked);
        int* const blocks = scope.take<int>(2 * looked);
        context.components.residual->squaredErrors(p, model, 0, looked, errors);
        const float limit = (float)(context.inlierThreshold() * context.inlierThreshold());
        for (int k = 0; k < size; ++k)
            inliers[k] = errors[sorted[k]] <= limit;  // NaN is not an inlier
        return orderLogLikelihood(inliers, size, blocks, ends) * extrapolation();
    }

    //! Number of points of the run, divided by the number of points from which the ranking is made.
    double extrapolation() const { return (double)context.points.size / looked; }

private:
    const Context& context;
    const int looked;
    int size;
    int* const sorted;
    uchar* const ends;  //!< see orderLogLikelihood()
};

//! Compares the log-likelihoods of a ranking (Ranking::likelihood) for the inliers of a model and
//! for those of the model of largest gain (`first`).
struct Evidence
{
    Evidence(const Model& first_) : ranking(0), first(first_), ofFirst(-1) {}

    //! The weighted advantage of a model, less the effect of chance. The variance of a
    //! log-likelihood that is extrapolated from few points is larger.
    //! @param points number of points that are inliers of only one of the two models
    double advantage(const Model& model, double points)
    {
        if (ofFirst < 0)
            ofFirst = ranking->likelihood(first);
        return WORTH * (ranking->likelihood(model) - ofFirst) -
               DEVIATIONS * std::sqrt(points * ranking->extrapolation());
    }

    const Ranking* ranking;  //!< null: not made yet
    const Model& first;
    double ofFirst;  //!< log-likelihood for `first`; -1: not computed yet
};

}  // namespace

Alternatives::Alternatives(bool active, const Context& context) : kept(0), count(0), least(NEAR)
{
    const bool common = hasCommonNeighbors(*context.points.problem);
    if (!active || !(common || orderIsKnown(context)))
        return;
    if (common)
        least = NEAR_COMMON;
    Arena& arena = context.arena;
    kept = arena.take<Alternative>(MOST + 1);
    for (int i = 0; i <= MOST; ++i)
        new (kept + i) Alternative();
}

void Alternatives::offer(const Context& context, const Candidate& candidate, bool sampled)
{
    const double gain = context.points.size - candidate.quality.cost;
    if (!(gain > 0) || (count > 0 && gain < least * kept[0].gain))
        return;
    const Alternative added = {candidate, sampled, InlierBits(context, candidate.model), gain};
    int place = 0;
    for (; place < count && kept[place].gain >= gain; ++place)
        if (same(kept[place].inliers, added.inliers))
            return;
    for (int i = count; i > place; --i)
        kept[i] = kept[i - 1];
    kept[place] = added;
    int left = place + 1;
    // drops models that have nearly the same inliers as the new model, or too low a gain
    for (int i = place + 1; i <= count; ++i)
        if (kept[i].gain >= least * kept[0].gain && !same(kept[i].inliers, added.inliers))
            kept[left++] = kept[i];
    count = std::min<int>(left, MOST);
}

const Alternative* Alternatives::chosen(const Context& context, const int* order,
                                        const uchar* common) const
{
    Arena::Scope scope(context.arena);
    const double parts = std::max(context.points.size / (double)InlierBits::MOST, 1.);
    Evidence neighbors(kept[0].candidate.model), known(kept[0].candidate.model);
    const Alternative* best = 0;
    double most = 0;
    for (int i = 1; i < count; ++i)
    {
        const int all = kept[i].inliers.count(), own = kept[i].inliers.without(kept[0].inliers);
        const bool byNeighbors = common && own >= OWN * all,
                   byOrder = order && kept[i].gain >= NEAR * kept[0].gain;
        if (own > (1 - SHARED) * all || !(byNeighbors || byOrder))
            continue;
        if (byNeighbors && !neighbors.ranking)
            neighbors.ranking = new (scope.take<Ranking>(1)) Ranking(context, common, scope);
        if (byOrder && !known.ranking)
            known.ranking = new (scope.take<Ranking>(1)) Ranking(context, order, scope);
        // each ranking decides by itself
        const Model& model = kept[i].candidate.model;
        const double points = parts * difference(kept[i].inliers, kept[0].inliers),
                     lost = kept[0].gain - kept[i].gain;
        double advantage = -DBL_MAX;
        if (byNeighbors)
            advantage = neighbors.advantage(model, points) - lost;
        if (byOrder)
            advantage = std::max(advantage, known.advantage(model, points) - lost);
        if (advantage > most)
        {
            most = advantage;
            best = kept + i;
        }
    }
    return best;
}

}  // namespace usacv20
}  // namespace cv
