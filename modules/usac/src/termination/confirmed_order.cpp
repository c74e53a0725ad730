// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/growth.hpp"
#include "components/repetitions.hpp"
#include "termination/confirmed_order.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

//! Among the first FIRST_ORDERED samples, every second one follows the order of the points, except
//! for the first few samples (see isOrderedByKnowledge() in samplers/samplers.hpp).
constexpr int FIRST_ORDERED = 480;
//! Minimum evidence for the order (orderEvidence()), in standard deviations of the rank sum. One
//! random order in 1000 reaches this value.
constexpr double CONFIRMED = 3.1;
//! The order is divided into this many equal parts. The number of inliers in the last part shows
//! how many inliers are spread over the whole order.
constexpr int LATE_PART = 4;

double orderEvidence(const uchar* inliers, const uchar* repeated, int size, int m)
{
    double ranks = 0,
           others = 0;  // number of outliers that come later in the order than point i
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

/** @brief PROSAC's criterion for scores that might be misleading: it ends the search only if the
data confirm the order of the points and if the outliers of the best model cannot hide another
model.

1. Of the first #FIRST_ORDERED samples, every second one follows the order, except for the first few
samples, which are uniform; later, one in Params::orderedEvery follows the order.
2. The order is confirmed if the inliers of a new best model come early in it (orderEvidence()).
Then all samples follow the order until PROSAC's criterion is fulfilled (prosacSamples()), unless
uniform samples would end the search earlier.
3. The inliers might still be a wrong group with the best scores, for example the matches of another
motion. The search therefore ends only after samples of the best model's outliers have led to no
model with significantly more inliers (State::unexplainedSamples, significantInliers()). Among these
outliers, such a model has a higher inlier ratio than among all points. It can share with the best
model the inliers that are spread over the whole order (otherInliers()).

The other criteria end the search if they need fewer samples, or if an all-inlier sample can lead to
a model other than the best one (State::successProbability; two motions are compatible with a
plane). Takes at most O(N) per batch of samples. */
class ConfirmedOrderTermination : public Termination
{
public:
    ConfirmedOrderTermination() : cost(0), orderedNeeded(INT_MAX), enough(INT_MAX), late(0) {}

    void start(const Context&) CV_OVERRIDE
    {
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
        state.wanted = state.remembered() < FIRST_ORDERED ? (int)SAMPLES_HALF : SAMPLES_MIXED;
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
               context.components.score->usesThreshold();
    }

    void markInliers(const Context& context, const State& state, uchar* inliers) const
    {
        const int size = context.points.size;
        Arena::Scope scope(context.arena);
        float* const errors = scope.take<float>(size);
        context.components.residual->squaredErrors(context.points, state.best, 0, size, errors);
        const float limit = (float)(context.inlierThreshold() * context.inlierThreshold());
        for (int i = 0; i < size; ++i)
            inliers[i] = errors[i] <= limit;  // NaN is not an inlier
    }

    //! Computes `orderedNeeded` for a new best model, if its inliers confirm the order. A model
    //! that was the best one before any sample followed the order is not considered: otherwise
    //! runs would be faster, but more wrong models would be returned.
    void look(const Context& context, const State& state)
    {
        const Correspondences& p = context.points;
        const int m = context.components.minimalSolver->sampleSize(), size = p.size;
        cost = state.bestQuality.cost;
        orderedNeeded = enough = INT_MAX;
        if (state.successProbability < 1 || !state.order || state.orderedSamples == 0 ||
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
        markRepeated(p, state.order, inliers, size, context.inlierThreshold(), repeated,
                     context.arena);
        if (orderEvidence(inliers, repeated, size, m) < CONFIRMED)
            return;
        const double kept = context.components.sampler->growingShare(context) *
                            context.params.orderedEvery *
                            keptProbability(context, state.bestQuality.inliers) *
                            state.successProbability;
        int length;
        orderedNeeded = prosacSamples(inliers, repeated, size, m, kept, context.randomInlierRatio(),
                                      std::log(1 - context.params.confidence),
                                      (context.params.termination & TERMINATION_EXACT) != 0, length,
                                      &context);
    }

    //! Number of uniform samples that the standard criterion still needs.
    static double uniformLeft(const Context& context, const State& state)
    {
        const int needed = samplesNeeded(
            goodModelProbability(context, state, state.bestQuality.inliers),
            std::log(1 - context.params.confidence));
        return (double)needed - state.countedSamples;
    }

    //! To be called when enough samples have followed the order. Ends the search after samples of
    //! the outliers, or immediately if they are too few for another model. If uniform
    //! samples would end the search earlier, the search continues with mostly uniform samples.
    void end(const Context& context, State& state)
    {
        const int size = context.points.size, m = context.components.minimalSolver->sampleSize();
        Arena::Scope scope(context.arena);
        uchar* const inliers = scope.take<uchar>(size);
        markInliers(context, state, inliers);
        const int left = size - (int)std::count(inliers, inliers + size, (uchar)1);
        const int samples = otherModelSamples(context, state, otherInliers(context, state, left),
                                              left, m);
        if (samples > uniformLeft(context, state))
        {
            orderedNeeded = INT_MAX;  // uniform samples end the search earlier
            state.wanted = SAMPLES_MIXED;
            return;
        }
        state.unexplainedSamples = samples;
        enough = state.remembered();
    }

    /** Number of inliers that another model needs among the `left` outliers of the best model to
    have significantly more inliers than the best model. If the best model is that of a wrong group
    early in the order, the two models share the inliers that are spread over the whole order. The
    number of shared inliers is estimated from the last part of the order. */
    double otherInliers(const Context& context, const State& state, int left) const
    {
        const double shared = (late + std::sqrt((double)late)) * left * LATE_PART /
                              context.points.size;
        return significantInliers(context, state) -
               std::min(shared, (double)state.bestQuality.inliers);
    }

    //! Number of samples of the `left` outliers needed to find, with the given confidence, a model
    //! with `other` inliers among these outliers.
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
        return samplesNeeded(std::min(p, 1.0) * state.successProbability,
                             std::log(1 - context.params.confidence));
    }

    double cost;        //!< cost of the best model at the last call of look()
    int orderedNeeded;  //!< number of samples that must follow the order; INT_MAX: such samples do
                        //!< not end the search
    int enough;         //!< number of samples after which the search can end; INT_MAX: not known
    int late;           //!< number of inliers of the best model in the last part of the order
};

}  // namespace

Ptr<Termination> createConfirmedOrderTermination() { return makePtr<ConfirmedOrderTermination>(); }

}  // namespace usacv20
}  // namespace cv
