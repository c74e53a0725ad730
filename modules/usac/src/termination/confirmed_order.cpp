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

//! Samples, the first ones, of which every second one follows the order. Half, double:
//! doc/constants.md.
constexpr int FIRST_ORDERED = 480;
//! Standard deviations of the rank sum: an order that tells nothing looks that good once in 1000
//! times.
constexpr double CONFIRMED = 3.1;
//! One of so many parts of the order, the last one, tells how many inliers come anywhere in it.
constexpr int LATE_PART = 4;
/** Another motion keeps its neighbors together at least so many times as often as the best model's,
... */
constexpr double OTHER_COHERENCE = 0.75;
//! ... which is known from so many pairs of inliers at least ...
constexpr double LEAST_PAIRS = 50;
//! ... and shows, but for so many standard deviations, in cells of both sizes: 1 % is missed.
constexpr double MISSED_DEVIATIONS = 2.58;
//! Cells of the second look have so many times the sides: few matches are seldom in one cell.
constexpr int COARSE = 2;
//! Of the inliers, not more than this part may repeat others, as these stay together in any case.
constexpr double MOST_REPEATED = 0.1;

bool otherMotionWouldShow(const CellPairs& own, const CellPairs& rest, double other, double left)
{
    if (std::sqrt(own.in[0] * own.in[1]) < LEAST_PAIRS || other > left)
        return other > left;
    const double coherence = OTHER_COHERENCE * own.coherence, part = other / left;
    const double chance = rest.expected * (1 - part * part);  // of all pairs but its own
    // at least, as other points than those that are spread evenly share a cell more often
    const double together = coherence * 0.5 * other * (other - 1) / own.cells;
    const double each = coherence * other /
                        own.cells;  // with a point, so that the number of pairs varies more
    const double deviation = std::sqrt(chance + together * (1 + 2 * each));
    return rest.both < chance + together - MISSED_DEVIATIONS * deviation;
}

double orderEvidence(const uchar* inliers, const uchar* repeated, int size, int m)
{
    double ranks = 0,
           others = 0;  // of the inliers among the points that count: how many of these come later
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

/** @brief PROSAC's criterion where scores may lie: it ends the search only if the data confirm the
order, and if no other model can hide among the points that the best one does not explain.

1. Of the first samples every second one follows the order (#FIRST_ORDERED), of the later ones one
in Params::orderedEvery.
2. Each new best model tells whether the order is good: its inliers come early in it
(orderEvidence()). If they do, all samples follow the order until PROSAC's criterion, see
prosacSamples(), is fulfilled.
3. That may be a wrong group with the best scores, another motion say. So the search ends for good
when samples of the points that the best model does not explain, where another one has a larger part
of the points than among all, have not met a model with significantly more inliers
(significantInliers(), State::unexplainedSamples). It may share with the best one what comes
anywhere in the order (otherInliers()). No such samples are asked for if the model would be seen
there, as its neighbors stay neighbors (otherMotionWouldShow()).

Where uniform samples are sooner enough, or the best model is of a plane that has two motions
(State::yield), the other criteria decide. O(N) a batch of samples at most. */
class ConfirmedOrderTermination : public Termination
{
public:
    ConfirmedOrderTermination()
        : randomRatio(1), cost(0), orderedNeeded(INT_MAX), enough(INT_MAX), late(0),
          manyRepeated(false)
    {}

    void start(const Context& context) CV_OVERRIDE
    {
        randomRatio = context.randomInlierRatio();
        cost = std::numeric_limits<double>::infinity();
        orderedNeeded = enough = INT_MAX;
    }

    bool adapt(const Context& context, State& state) CV_OVERRIDE
    {
        if (!isOfUse(context))
            return false;
        const int wanted = state.wanted, before = enough;
        if (state.bestQuality.cost != cost)
            look(context, state);
        state.wanted = state.iteration < FIRST_ORDERED ? (int)SAMPLES_HALF : SAMPLES_MIXED;
        if (orderedNeeded < INT_MAX &&
            orderedNeeded - state.orderedSamples < uniformLeft(context, state))
        {
            state.wanted = SAMPLES_ORDERED;
            if (state.orderedSamples >= orderedNeeded && enough == INT_MAX)
                end(context, state);
        }
        return state.wanted != wanted || enough != before;
    }

    int iterations(const Context&, const State& state) const CV_OVERRIDE
    {
        return state.bestQuality.cost == cost ? enough : INT_MAX;
    }

    int reason() const CV_OVERRIDE { return STOP_ORDER; }

private:
    static bool isOfUse(const Context& context)
    {
        return orderIsKnown(context) && context.params.orderedEvery > 1 &&
               context.params.runnersUp > 0 && context.components.localOptimizer &&
               context.components.sampler->growingShare(context) > 0 &&
               context.params.quality != QUALITY_LMEDS;
    }

    void markInliers(const Context& context, const State& state, uchar* inliers) const
    {
        const int size = context.points.size;
        Arena::Scope scope(context.arena);
        float* const errors = scope.take<float>(size);
        context.components.residual->squaredErrors(context.points, state.best, 0, size, errors);
        const float limit = (float)(context.inlierThreshold() * context.inlierThreshold());
        for (int i = 0; i < size; ++i)
            inliers[i] = errors[i] <= limit;  // false for NaN
    }

    //! How many samples that follow the order are enough for the best model, if the order is
    //! confirmed.
    void look(const Context& context, const State& state)
    {
        const Correspondences& p = context.points;
        const int m = context.components.minimalSolver->sampleSize(), size = p.size;
        cost = state.bestQuality.cost;
        orderedNeeded = enough = INT_MAX;
        if (state.yield < 1 || !state.order || state.orderedSamples == 0 ||
            state.bestQuality.inliers <= m)
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
        if (orderEvidence(inliers, repeated, size, m) < CONFIRMED ||
            context.stopBefore(size * REPETITION_WORK))
            return;
        manyRepeated = markRepeated(p, state.order, inliers, size, context.inlierThreshold(),
                                    repeated,
                                    context.arena) > MOST_REPEATED * state.bestQuality.inliers;
        if (orderEvidence(inliers, repeated, size, m) < CONFIRMED)
            return;
        const double kept = context.components.sampler->growingShare(context) *
                            context.params.orderedEvery *
                            keptProbability(context, state.bestQuality.inliers) * state.yield;
        int length;
        orderedNeeded = prosacSamples(
            inliers, repeated, size, m, kept, randomRatio, std::log(1 - context.params.confidence),
            (context.params.termination & TERMINATION_EXACT) != 0, length, &context);
    }

    //! Uniform samples that lack for the standard criterion.
    static double uniformLeft(const Context& context, const State& state)
    {
        const int needed = samplesNeeded(
            goodModelProbability(context, state, state.bestQuality.inliers),
            std::log(1 - context.params.confidence));
        return (double)needed - state.countedSamples;
    }

    //! Samples that follow the order are enough, if it is not one of another motion.
    void end(const Context& context, State& state)
    {
        const int size = context.points.size, m = context.components.minimalSolver->sampleSize();
        Arena::Scope scope(context.arena);
        uchar* const inliers = scope.take<uchar>(size);
        markInliers(context, state, inliers);
        const int left = size - (int)std::count(inliers, inliers + size, (uchar)1);
        const double other = otherInliers(context, state, left);
        const int samples = seesNoOther(context, inliers, other, left)
                                ? 0
                                : otherModelSamples(context, state, other, left, m);
        if (samples > uniformLeft(context, state))
        {
            orderedNeeded = INT_MAX;  // those of all points are enough sooner
            state.wanted = SAMPLES_MIXED;
            return;
        }
        state.unexplainedSamples = samples;
        enough = state.iteration;
    }

    //! True if another motion with so many inliers would show among the points that the best one
    //! leaves.
    bool seesNoOther(const Context& context, const uchar* inliers, double other, int left) const
    {
        bool shows = false;
        for (int merged = 1; merged <= COARSE && !shows && !manyRepeated; merged *= COARSE)
            shows = otherMotionWouldShow(
                CellPairs(context.points, inliers, 1, context.arena, merged),
                CellPairs(context.points, inliers, 0, context.arena, merged), other, left);
        return shows;
    }

    /** Inliers that another model must have among the `left` points to have significantly more. If
    the best model owes its place in the order to a wrong group, the other one shares with it what
    comes anywhere in the order; how many these are the last ones tell. */
    double otherInliers(const Context& context, const State& state, int left) const
    {
        const double shared = (late + std::sqrt((double)late)) * left * LATE_PART /
                              context.points.size;
        return significantInliers(context, state) -
               std::min(shared, (double)state.bestQuality.inliers);
    }

    //! Samples of the `left` points after which a model with so many inliers would be found.
    static int otherModelSamples(const Context& context, const State& state, double other, int left,
                                 int m)
    {
        if (other > left)
            return 0;
        const double copies = copiesOf(state, context.points.size, m);
        const double different = std::max(left / copies, (double)std::min(left, m + 1));
        double p = 1;
        for (int i = 0; i < m; ++i)
            p *= std::max(other / left * different - i, 0.0) / (different - i);
        return samplesNeeded(std::min(p, 1.0) * state.yield,
                             std::log(1 - context.params.confidence));
    }

    double randomRatio, cost;
    int orderedNeeded;  //!< samples that follow the order; INT_MAX: they do not end the search
    int enough;         //!< samples after which it may end; INT_MAX: not known
    int late;           //!< inliers of the best model among the last points of the order
    bool manyRepeated;  //!< of the inliers
};

}  // namespace

Ptr<Termination> createConfirmedOrderTermination() { return makePtr<ConfirmedOrderTermination>(); }

}  // namespace usacv20
}  // namespace cv
