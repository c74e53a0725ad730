// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "core/known_order.hpp"
#include "core/repetitions.hpp"
#include "termination/confirmed_order.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

//! Standard deviations of the rank sum: an order that tells nothing looks that good once in 1000 times.
constexpr double CONFIRMED = 3.1;
//! Part of the samples that are of unexplained points, where these are wanted: all but two in eight.
constexpr double UNEXPLAINED_SHARE = 0.75;
//! The best model is another one if it has lost more than this part of the inliers of the one before.
constexpr double SAME = 0.9;

double orderEvidence(const uchar* inliers, const uchar* repeated, int size, int m)
{
    double ranks = 0, others = 0;  // of the inliers among the points that count: how many of these come later
    int own = 0, skipped = 0;
    for (int i = size - 1; i >= 0; --i)
        others += !inliers[i];
    const double wrong = others;
    for (int i = 0; i < size; ++i)
    {
        if (!inliers[i])
        {
            --others;
            continue;
        }
        if (repeated[i] || skipped++ < m)
            continue;
        ranks += others;
        ++own;
    }
    if (own == 0 || wrong == 0)
        return 0;
    return (ranks - 0.5 * own * wrong) / std::sqrt(own * wrong * (own + wrong + 1) / 12);
}

namespace {

/** @brief Ends the search by the samples that follow an order, if the data confirm the order. */
class ConfirmedOrderTermination : public Termination
{
public:
    ConfirmedOrderTermination() : randomRatio(1), cost(0), orderedNeeded(INT_MAX), from(0), explained(0), points(0) {}

    void start(const Context& context) CV_OVERRIDE
    {
        randomRatio = context.points.problem->randomInlierRatio(context.points);
        cost = std::numeric_limits<double>::infinity();
        orderedNeeded = INT_MAX;
        explained = 0;
        points = 0;
    }

    bool adapt(const Context& context, State& state) CV_OVERRIDE
    {
        const int before = state.wanted;
        if (!isOfUse(context, state))
            state.wanted = SAMPLES_MIXED;
        else
        {
            const bool changed = state.bestQuality.cost != cost;
            if (changed)
                look(context, state);
            state.wanted = wantedNow(context, state);
            if (state.wanted == SAMPLES_UNEXPLAINED && (changed || before != state.wanted))
            {
                collect(context, state, before == SAMPLES_UNEXPLAINED);
                return true;
            }
        }
        return state.wanted != before;
    }

    int iterations(const Context& context, const State& state) const CV_OVERRIDE
    {
        if (state.wanted != SAMPLES_UNEXPLAINED || state.bestQuality.cost != cost)
            return INT_MAX;
        const double needed = otherModelSamples(context, state) / UNEXPLAINED_SHARE;
        return needed < INT_MAX - from ? from + (int)std::ceil(needed) : INT_MAX;
    }

    int reason() const CV_OVERRIDE { return STOP_ORDER; }

private:
    static bool isOfUse(const Context& context, const State& state)
    {
        const bool planar = state.report.degenerate || state.yield < 1;
        return !planar && state.order && context.params.orderedEvery > 1 && state.orderedSamples > 0 &&
               orderIsKnown(context) && context.components.sampler->growingShare(context) > 0 &&
               context.params.quality != QUALITY_LMEDS &&
               state.bestQuality.inliers > context.components.minimalSolver->sampleSize();
    }

    void markInliers(const Context& context, const State& state, uchar* inliers) const
    {
        const int size = context.points.size;
        Arena::Scope scope(context.arena);
        float* const errors = scope.take<float>(size);
        context.components.residual->squaredErrors(context.points, state.best, 0, size, errors);
        const float limit = (float)(context.points.threshold * context.points.threshold);
        for (int i = 0; i < size; ++i)
            inliers[i] = errors[i] <= limit;  // false for NaN
    }

    //! How many samples that follow the order are enough for the best model, if the order is confirmed.
    void look(const Context& context, const State& state)
    {
        const Correspondences& p = context.points;
        const int m = context.components.minimalSolver->sampleSize(), size = p.size;
        cost = state.bestQuality.cost;
        orderedNeeded = INT_MAX;
        Arena::Scope scope(context.arena);
        uchar *const marked = scope.take<uchar>(size), *const inliers = scope.take<uchar>(size),
                     *const repeated = scope.take<uchar>(size);
        markInliers(context, state, marked);
        for (int i = 0; i < size; ++i)
            inliers[i] = marked[state.order[i]];
        std::fill(repeated, repeated + size, (uchar)0);
        if (orderEvidence(inliers, repeated, size, m) < CONFIRMED)
            return;
        markRepeated(p, state.order, inliers, size, p.threshold, repeated, context.arena);
        if (orderEvidence(inliers, repeated, size, m) < CONFIRMED)
            return;
        const double kept = context.components.sampler->growingShare(context) * context.params.orderedEvery *
                            keptProbability(context, state.bestQuality.inliers);
        int length;
        orderedNeeded = prosacSamples(inliers, repeated, size, m, kept, randomRatio,
                                      std::log(1 - context.params.confidence),
                                      (context.params.termination & TERMINATION_EXACT) != 0, length);
    }

    int wantedNow(const Context& context, const State& state) const
    {
        if (orderedNeeded == INT_MAX)
            return SAMPLES_MIXED;
        if (state.orderedSamples >= orderedNeeded)
            return SAMPLES_UNEXPLAINED;
        const int uniform = samplesNeeded(goodModelProbability(context, state, state.bestQuality.inliers),
                                          std::log(1 - context.params.confidence));
        const double left = (double)uniform - state.countedSamples;
        return orderedNeeded - state.orderedSamples < left ? SAMPLES_ORDERED : SAMPLES_MIXED;
    }

    //! The points that the best model does not explain. What has been drawn of those before counts if it still has
    //! nearly all inliers that it had.
    void collect(const Context& context, State& state, bool wasWanted)
    {
        const int size = context.points.size;
        if (!explained)
        {
            explained = context.arena.take<uchar>(size);
            points = context.arena.take<int>(size);
        }
        Arena::Scope scope(context.arena);
        uchar* const inliers = scope.take<uchar>(size);
        markInliers(context, state, inliers);
        int had = 0, kept = 0;
        for (int i = 0; wasWanted && i < size; ++i)
        {
            had += explained[i];
            kept += explained[i] & inliers[i];
        }
        if (!wasWanted || kept < SAME * had)
            from = state.iteration;
        std::copy(inliers, inliers + size, explained);
        state.unexplained = points;
        state.unexplainedCount = 0;
        for (int i = 0; i < size; ++i)
            if (!inliers[i])
                points[state.unexplainedCount++] = i;
    }

    //! Samples of unexplained points after which another model that has significantly more inliers would be found.
    int otherModelSamples(const Context& context, const State& state) const
    {
        const int m = context.components.minimalSolver->sampleSize(), n = context.points.size;
        const int inliers = state.bestQuality.inliers, left = state.unexplainedCount;
        // of the inliers of the best model the other one has as many as by chance
        const double other = significantInliers(context, state) - randomRatio * inliers;
        if (other > left)
            return 0;
        const double copies = copiesOf(state, n, m);
        const double different = std::max(left / copies, (double)std::min(left, m + 1));
        double p = 1;
        for (int i = 0; i < m; ++i)
            p *= std::max(other / left * different - i, 0.0) / (different - i);
        return samplesNeeded(std::min(p, 1.0) * keptProbability(context, other), std::log(1 - context.params.confidence));
    }

    double randomRatio, cost;
    int orderedNeeded;  //!< samples that follow the order; INT_MAX: they do not end the search
    int from;           //!< the sample from which on those of unexplained points count
    uchar* explained;   //!< inliers of the best model that `points` are left of
    int* points;        //!< State::unexplained
};

}  // namespace

Ptr<Termination> createConfirmedOrderTermination() { return makePtr<ConfirmedOrderTermination>(); }

}  // namespace usacv20
}  // namespace cv
