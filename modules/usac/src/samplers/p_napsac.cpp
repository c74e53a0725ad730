// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "core/known_order.hpp"
#include "samplers/samplers.hpp"

namespace cv {
namespace usacv20 {

namespace {

// Half and double of these: doc/constants.md.

//! Samples; see the class. BEFORE_ORDER 4, 16: errors the same; ORDERED 8, 32: errors of H within 1
//! %; BEFORE_ORDER_CHEAP 16: instructions of affinities and similarities -3 to +12 %, 64: -10 to +7
//! %.
constexpr int BEFORE_ORDER = 8, ORDERED = 16, BEFORE_ORDER_CHEAP = 32;
//! Points of the sample of H, and more than those of an affinity or a similarity.
constexpr int SMALL = 4;
//! Of so many samples that are not uniform, one is local. LOCAL_EVERY 2, 8, with scores: errors
//! within 1 %; LOCAL_EVERY_GUESS 1: errors of F +5 %, E +3 %, failures of F +0.7 points; 4: errors
//! within 1 %.
constexpr int LOCAL_EVERY = 4, LOCAL_EVERY_GUESS = 2;
//! The first neighborhood of a point has so many times as many members as a sample. 1, 4: errors
//! within 1 %.
constexpr int FIRST_MEMBERS = 2;

//! True if the order of the points is nobody's knowledge.
bool isGuess(const Context& context) { return !orderIsKnown(context); }

/** @brief Progressive NAPSAC @cite barath2019progressive.

The first, location-defining, point comes from PROSAC's growing set of the best points; the others
from its neighborhood: the finest layer of the graph with #FIRST_MEMBERS m members at first, and
with twice as many each time the point is chosen again, until that is everything and the sample is
PROSAC's. One in four of the samples that are not uniform (Params::orderedEvery) is local, every
second one if the order of the points is a guess (the density). With more, small groups of wrong
matches that agree with each other (repeated patterns) won more often on real pairs than small
groups of right ones were found sooner. If the order is a guess, the first #BEFORE_ORDER samples are
uniform: easy problems need no more, and so neither order nor neighborhood. Of samples of #SMALL
points (H), the first #ORDERED all keep to the order instead: they come from the few densest points,
and four right ones among these are soon met. Of smaller ones the first #BEFORE_ORDER_CHEAP are
uniform: they take less than the order does. */
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

    int subsetSize(const Context&) const CV_OVERRIDE { return growth.size(); }

    double growingShare(const Context& context) const CV_OVERRIDE
    {
        return (1 - 1. / localEvery(context)) / context.params.orderedEvery;
    }

private:
    static int localEvery(const Context& context)
    {
        return isGuess(context) ? LOCAL_EVERY_GUESS : LOCAL_EVERY;
    }

    //! As isOrdered(), but for the first samples.
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

    //! How often a point was the center of a local sample, and the finest layer with enough
    //! neighbors.
    struct Center
    {
        int chosen, layer;
    };

    //! Draws the other points from the neighborhood of sample[0]; false if that is everything.
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
        for (; center.layer < neighborhood.layers();
             ++center.layer)  // finer ones will never do again
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
    Center* centers;  //!< for each point; null before the first local sample
};

}  // namespace

Ptr<Sampler> createPNapsacSampler() { return makePtr<PNapsacSampler>(); }

}  // namespace usacv20
}  // namespace cv
