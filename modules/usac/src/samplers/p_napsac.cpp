// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/growth.hpp"
#include "samplers/samplers.hpp"

namespace cv {
namespace usacv20 {

namespace {

// Effects of halving or doubling each constant: doc/constants.md.

//! Numbers of samples, see PNapsacSampler.
constexpr int ORDERED = 16, BEFORE_ORDER_CHEAP = 32;
//! Sample size of H; an affinity or a similarity needs fewer points.
constexpr int SMALL = 4;
//! One in LOCAL_EVERY non-uniform samples is local if the order is known, and one in
//! LOCAL_EVERY_GUESS if it is guessed.
constexpr int LOCAL_EVERY = 4, LOCAL_EVERY_GUESS = 2;
//! Minimum size of the first neighborhood of a point, in sample sizes.
constexpr int FIRST_MEMBERS = 2;

//! True if the order is a guess from the density of the points, not given and not made from scores.
bool isGuess(const Context& context) { return !orderIsKnown(context); }

/** @brief Progressive NAPSAC @cite barath2019progressive.

The first, location-defining point of a sample comes from PROSAC's growing set of the best points,
the others from its neighborhood: the finest layer of the graph in which it has at least
#FIRST_MEMBERS m members. That number doubles each time the point is chosen again; once no layer has
enough members, the sample is drawn as in PROSAC. Such a local sample is one in #LOCAL_EVERY of the
non-uniform samples (Params::orderedEvery), or one in #LOCAL_EVERY_GUESS if the order is a guess
from the density of the points. With more local samples, small groups of consistent outliers
(repeated patterns) are more often taken for the inliers.

The first #BEFORE_ORDER samples are uniform, unless all samples follow the order. If the order is a
guess, there are exceptions: with #SMALL points per sample (H), the first #ORDERED samples all
follow the order instead: four inliers are soon drawn from the few densest points. With fewer points
per sample, the first #BEFORE_ORDER_CHEAP samples are uniform, as they take less time than computing
the order. */
class PNapsacSampler : public Sampler
{
public:
    PNapsacSampler() : centers(0) {}

    void start(const Context& context) CV_OVERRIDE
    {
        growth = GrowingSet(context.components.minimalSolver->sampleSize(), context.points.size);
        centers = 0;
    }

    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize();
        const bool guess = isGuess(context);
        if (!guess && !isOrderedByKnowledge(context, state, sample))
            return;
        growth.next();
        const int n = growth.size();
        if (guess && !isOrderedGuess(context, state, sample))
            return;
        const int center = state.bestFirst(context)[growth.newest() ? n - 1 : state.rng.uniform(n)];
        sample[0] = center;
        const int turn = guess ? state.iteration / context.params.orderedEvery
                               : state.orderedSamples - 1;
        const int every = localEvery(context);
        if (turn % every != every - 1 || !local(context, state, m, sample))
            global(state, m, n, sample);
    }

    double growingShare(const Context& context) const CV_OVERRIDE
    {
        return (1 - 1. / localEvery(context)) / context.params.orderedEvery;
    }

private:
    static int localEvery(const Context& context)
    {
        return isGuess(context) ? LOCAL_EVERY_GUESS : LOCAL_EVERY;
    }

    //! isOrdered() with exceptions for the first samples, see the class.
    static bool isOrderedGuess(const Context& context, State& state, int* sample)
    {
        const int m = context.components.minimalSolver->sampleSize(),
                  before = m < SMALL ? BEFORE_ORDER_CHEAP : BEFORE_ORDER;
        if (context.params.orderedEvery == 1 || state.iteration >= std::max(before, ORDERED))
            return isOrdered(context, state, sample);
        if (m == SMALL)
        {
            state.counts = false;
            return true;
        }
        if (state.iteration < before)
        {
            drawUniform(context, state, sample);
            return false;
        }
        return isOrdered(context, state, sample);
    }

    //! How often a point was the first of a local sample; its finest layer with enough members.
    struct Center
    {
        int chosen, layer;
    };

    //! Draws the other points from the neighborhood of sample[0]; false if no layer suffices.
    bool local(const Context& context, State& state, int m, int* sample)
    {
        Neighborhood& neighborhood = context.neighborhood();
        if (!centers)
        {
            centers = context.arena.take<Center>(context.points.size);
            std::fill(centers, centers + context.points.size, Center());
        }
        Center& center = centers[sample[0]];
        const int wanted = FIRST_MEMBERS * m << std::min(center.chosen++, 16);  // 16: no overflow
        for (; center.layer < neighborhood.layers(); ++center.layer)  // finer layers stay too small
        {
            const int* members;
            const int count = neighborhood.members(context, center.layer, sample[0], members);
            if (count >= wanted)
            {
                drawOthers(state.rng, members, count, m, sample);
                return true;
            }
        }
        return false;
    }

    void global(State& state, int m, int n, int* sample)
    {
        drawOthers(state.rng, state.order, n, m, sample);
    }

    GrowingSet growth;
    Center* centers;  //!< one per point; null before the first local sample
};

}  // namespace

Ptr<Sampler> createPNapsacSampler() { return makePtr<PNapsacSampler>(); }

}  // namespace usacv20
}  // namespace cv
