// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "local_optimization/alternatives.hpp"
#include "scoring/order_likelihood.hpp"

namespace cv {
namespace usacv20 {

namespace {

// doc/measurements/constants_tables.md lists the effects of halving or doubling each constant. The
// gain of a model is defined in Alternative.

//! The gain of an alternative is at least this fraction of the largest gain of all models.
constexpr double NEAR = 0.94;
//! Two models have different inliers if, for at least one of them, more than this fraction of its
//! inliers are not inliers of the other model.
constexpr double DIFFERENT = 0.1;
//! An alternative shares at least this fraction of its inliers with the model of largest gain. A
//! model that shares fewer inliers describes another motion; the cost alone then decides.
constexpr double SHARED = 0.5;
//! Weight of the log-likelihood of the order relative to the gain, to which an inlier without error
//! contributes 1. For comparison: with independent Gaussian errors and a threshold at their 0.95
//! quantile, one unit of MSAC's cost is a log-likelihood of 1.9 (errors with one component) or 3
//! (two components). A larger value gives the order more influence.
constexpr double WORTH = 1;
//! Minimum advantage of an alternative over the model of largest gain, in standard deviations of
//! the log-likelihood. Each point that is an inlier of only one of these two models changes the
//! log-likelihood by about 1 at random.
constexpr double DEVIATIONS = 2;
//! Maximum number of points from which the likelihood of the order is computed.
constexpr int LOOKED = 4096;

//! Number of points that are inliers of only one of two models.
int difference(const InlierBits& a, const InlierBits& b) { return a.without(b) + b.without(a); }

//! True if two models have nearly the same inliers, see DIFFERENT.
bool same(const InlierBits& a, const InlierBits& b)
{
    return a.without(b) <= DIFFERENT * a.count() && b.without(a) <= DIFFERENT * b.count();
}

}  // namespace

Alternatives::Alternatives(bool active, Arena& arena) : kept(0), count(0)
{
    if (!active)
        return;
    kept = arena.take<Alternative>(MOST + 1);
    for (int i = 0; i <= MOST; ++i)
        new (kept + i) Alternative();
}

void Alternatives::offer(const Context& context, const Candidate& candidate, bool sampled)
{
    const double gain = context.points.size - candidate.quality.cost;
    if (!(gain > 0) || (count > 0 && gain < NEAR * kept[0].gain))
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
    // drops models that have the same inliers as the new model, or too low a gain
    for (int i = place + 1; i <= count; ++i)
        if (kept[i].gain >= NEAR * kept[0].gain && !same(kept[i].inliers, added.inliers))
            kept[left++] = kept[i];
    count = std::min<int>(left, MOST);
}

double Alternatives::orderOf(const Context& context, const Model& model, const int* order) const
{
    const Correspondences& p = context.points;
    const int looked = std::min(p.size, LOOKED);
    Arena::Scope scope(context.arena);
    float* const errors = scope.take<float>(looked);
    uchar* const inliers = scope.take<uchar>(looked);
    int* const blocks = scope.take<int>(2 * looked);
    context.components.residual->squaredErrors(p, model, 0, looked, errors);
    const float limit = (float)(context.inlierThreshold() * context.inlierThreshold());
    int size = 0;
    for (int i = 0; i < p.size; ++i)
        if (order[i] < looked)
            inliers[size++] = errors[order[i]] <= limit;  // NaN is not an inlier
    return orderLogLikelihood(inliers, size, blocks) * p.size / looked;
}

const Alternative* Alternatives::chosen(const Context& context, const int* order) const
{
    const double parts = std::max(context.points.size / (double)InlierBits::MOST, 1.);
    const Alternative* best = 0;
    double most = 0, first = -1;  // -1: not computed yet
    for (int i = 1; i < count; ++i)
    {
        const int own = kept[i].inliers.without(kept[0].inliers);
        if (own > (1 - SHARED) * kept[i].inliers.count())
            continue;
        if (first < 0)
            first = kept[0].gain + WORTH * orderOf(context, kept[0].candidate.model, order);
        const double points = parts * difference(kept[i].inliers, kept[0].inliers);
        const double advantage = kept[i].gain +
                                 WORTH * orderOf(context, kept[i].candidate.model, order) - first -
                                 DEVIATIONS * std::sqrt(points);
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
