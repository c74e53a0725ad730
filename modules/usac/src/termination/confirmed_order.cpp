// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "core/joint_cells.hpp"
#include "core/known_order.hpp"
#include "core/repetitions.hpp"
#include "termination/confirmed_order.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

//! Samples, the first ones, of which every second one follows the order. Half, double: doc/constants.md.
constexpr int FIRST_ORDERED = 480;
//! Standard deviations of the rank sum: an order that tells nothing looks that good once in 1000 times.
constexpr double CONFIRMED = 3.1;
//! One of so many parts of the order, the last one, tells how many inliers come anywhere in it.
constexpr int LATE_PART = 4;
//! Part of the samples that are of unexplained points, where these are wanted: all but two in eight.
constexpr double UNEXPLAINED_SHARE = 0.75;
//! The best model is another one if it has lost more than this part of the inliers of the one before.
constexpr double SAME = 0.9;

/** Another motion keeps its neighbors together at least so many times as often as the best model's, ... */
constexpr double OTHER_COHERENCE = 0.75;
//! ... which is known from so many pairs of inliers at least ...
constexpr double LEAST_PAIRS = 50;
//! ... and shows, but for so many standard deviations: 1 % is missed.
constexpr double MISSED_DEVIATIONS = 2.33;
//! Of the inliers, not more than this part may repeat others, as these stay together in any case.
constexpr double MOST_REPEATED = 0.1;

bool otherMotionWouldShow(const CellPairs& own, const CellPairs& rest, double other, double left)
{
    if (std::sqrt(own.in[0] * own.in[1]) < LEAST_PAIRS || other > left)
        return other > left;
    const double coherence = OTHER_COHERENCE * own.coherence, wrong = 1 - other / left;
    const double chance = rest.expected * wrong * wrong;
    // at least, as other points than those that are spread evenly share a cell more often
    const double together = coherence * 0.5 * other * (other - 1) / CELLS;
    const double each = coherence * other / CELLS;  // with a point, so that the number of pairs varies more
    const double deviation = std::sqrt(chance + together * (1 + 2 * each));
    return rest.both < chance + together - MISSED_DEVIATIONS * deviation;
}

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

/** @brief PROSAC's criterion where scores may lie: it ends the search only if the data confirm the order, and if no
other model can hide among the points that the best one does not explain.

1. Of the first samples every second one follows the order (#FIRST_ORDERED), of the later ones one in
Params::orderedEvery.
2. Each new best model tells whether the order is good: its inliers come early in it (orderEvidence()). If they do, all
samples follow the order until PROSAC's criterion, see prosacSamples(), is fulfilled.
3. That may be a wrong group with the best scores, another motion say. So another model with significantly more inliers
(significantInliers()) is looked for among the points that the best one does not explain, where it has a larger part of
the points than among all. It may share with the best one what comes anywhere in the order (otherInliers()). The search
ends when samples of these points would have met it with the wanted confidence, or at once if it would be seen there, as
its neighbors stay neighbors (otherMotionWouldShow()).

Where uniform samples are sooner enough, or the best model is of a plane that has two motions (State::yield), the other
criteria decide. O(N) a batch of samples at most. */
class ConfirmedOrderTermination : public Termination
{
public:
    ConfirmedOrderTermination()
        : randomRatio(1), cost(0), orderedNeeded(INT_MAX), from(0), explained(0), points(0), late(0),
          manyRepeated(false), noOther(false)
    {}

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
        if (!isOfUse(context))
            return false;
        const int before = state.wanted;
        const bool changed = state.bestQuality.cost != cost;
        if (changed)
            look(context, state);
        state.wanted = state.iteration < FIRST_ORDERED ? (int)SAMPLES_HALF : SAMPLES_MIXED;
        if (orderedNeeded < INT_MAX)
            state.wanted = wantedNow(context, state);
        if (state.wanted != SAMPLES_UNEXPLAINED || (!changed && before == SAMPLES_UNEXPLAINED))
            return state.wanted != before;
        collect(context, state, before == SAMPLES_UNEXPLAINED);
        if (otherModelSamples(context, state) / UNEXPLAINED_SHARE > uniformLeft(context, state))
        {
            orderedNeeded = INT_MAX;  // those of all points are enough sooner
            state.wanted = SAMPLES_MIXED;
        }
        return true;
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
    static bool isOfUse(const Context& context)
    {
        return orderIsKnown(context) && context.params.orderedEvery > 1 &&
               context.components.sampler->growingShare(context) > 0 && context.params.quality != QUALITY_LMEDS;
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
        if (state.yield < 1 || !state.order || state.orderedSamples == 0 || state.bestQuality.inliers <= m)
            return;
        Arena::Scope scope(context.arena);
        uchar *const marked = scope.take<uchar>(size), *const inliers = scope.take<uchar>(size),
                     *const repeated = scope.take<uchar>(size);
        markInliers(context, state, marked);
        for (int i = 0; i < size; ++i)
            inliers[i] = marked[state.order[i]];
        late = 0;
        for (int i = size - size / LATE_PART; i < size; ++i)
            late += inliers[i];
        std::fill(repeated, repeated + size, (uchar)0);
        if (orderEvidence(inliers, repeated, size, m) < CONFIRMED)
            return;
        manyRepeated = markRepeated(p, state.order, inliers, size, p.threshold, repeated, context.arena) >
                       MOST_REPEATED * state.bestQuality.inliers;
        if (orderEvidence(inliers, repeated, size, m) < CONFIRMED)
            return;
        const double kept = context.components.sampler->growingShare(context) * context.params.orderedEvery *
                            keptProbability(context, state.bestQuality.inliers) * state.yield;
        int length;
        orderedNeeded = prosacSamples(inliers, repeated, size, m, kept, randomRatio,
                                      std::log(1 - context.params.confidence),
                                      (context.params.termination & TERMINATION_EXACT) != 0, length);
    }

    //! With an order that is confirmed.
    int wantedNow(const Context& context, const State& state) const
    {
        if (state.orderedSamples >= orderedNeeded)
            return SAMPLES_UNEXPLAINED;
        return orderedNeeded - state.orderedSamples < uniformLeft(context, state) ? SAMPLES_ORDERED : SAMPLES_MIXED;
    }

    //! Uniform samples that lack for the standard criterion.
    static double uniformLeft(const Context& context, const State& state)
    {
        const int needed = samplesNeeded(goodModelProbability(context, state, state.bestQuality.inliers),
                                         std::log(1 - context.params.confidence));
        return (double)needed - state.countedSamples;
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
        const CellPairs own(context.points, inliers, 1, context.arena), rest(context.points, inliers, 0, context.arena);
        noOther = !manyRepeated &&
                  otherMotionWouldShow(own, rest, otherInliers(context, state), state.unexplainedCount);
    }

    /** Inliers that another model must have among the unexplained points to have significantly more. If the best model
    owes its place in the order to a wrong group, the other one shares with it what comes anywhere in the order; how
    many these are the last ones tell. */
    double otherInliers(const Context& context, const State& state) const
    {
        const double shared = (late + std::sqrt((double)late)) * state.unexplainedCount * LATE_PART /
                              context.points.size;
        return significantInliers(context, state) - std::min(shared, (double)state.bestQuality.inliers);
    }

    //! Samples of unexplained points after which another model that has significantly more inliers would be found.
    int otherModelSamples(const Context& context, const State& state) const
    {
        const int m = context.components.minimalSolver->sampleSize(), n = context.points.size;
        const int left = state.unexplainedCount;
        const double other = otherInliers(context, state);
        if (noOther || other > left)
            return 0;
        const double copies = copiesOf(state, n, m);
        const double different = std::max(left / copies, (double)std::min(left, m + 1));
        double p = 1;
        for (int i = 0; i < m; ++i)
            p *= std::max(other / left * different - i, 0.0) / (different - i);
        return samplesNeeded(std::min(p, 1.0) * keptProbability(context, other) * state.yield,
                             std::log(1 - context.params.confidence));
    }

    double randomRatio, cost;
    int orderedNeeded;  //!< samples that follow the order; INT_MAX: they do not end the search
    int from;           //!< the sample from which on those of unexplained points count
    uchar* explained;   //!< inliers of the best model that `points` are left of
    int* points;        //!< State::unexplained
    int late;           //!< inliers of the best model among the last points of the order
    bool manyRepeated;  //!< of the inliers
    bool noOther;       //!< another motion would show among the unexplained points
};

}  // namespace

Ptr<Termination> createConfirmedOrderTermination() { return makePtr<ConfirmedOrderTermination>(); }

}  // namespace usacv20
}  // namespace cv
