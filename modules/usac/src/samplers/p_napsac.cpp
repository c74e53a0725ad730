// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/growth.hpp"
#include "samplers/samplers.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Number of samples after the first uniform ones that all follow a guessed order, if a sample has
//! at most SMALL points. A search that is limited to fewer than LEAST samples has no uniform ones
//! before them.
constexpr int ORDERED = 16, SMALL = 4, LEAST = 64;
//! Number of uniform samples of fewer than SMALL points at the start of a search: 32 of them take
//! less time than the order.
constexpr int BEFORE_ORDER_CHEAP = 32;
//! Of the non-uniform samples, one in LOCAL_EVERY is local if the order of the points is known, and
//! one in LOCAL_EVERY_GUESS if the order is a guess.
constexpr int LOCAL_EVERY = 4, LOCAL_EVERY_GUESS = 2;
//! Minimum size of the first neighborhood of a point, as a multiple of the sample size.
constexpr int FIRST_MEMBERS = 2;

//! True if the order of the points is a guess from their density: the caller has given neither an
//! order nor scores.
bool isGuess(const Context& context) { return !orderIsKnown(context); }

/** @brief Progressive NAPSAC @cite barath2019progressive.

The first point of a local sample comes from PROSAC's growing set of the best points. The other
points are neighbors of the first point, in the finest layer of the neighborhood graph in which it
has at least #FIRST_MEMBERS times m neighbors, including itself (m is the sample size). The required
number doubles each time the same first point is chosen again; once no layer has enough neighbors,
the sample is drawn as in PROSAC. Of the non-uniform samples (Params::orderedEvery), one in
#LOCAL_EVERY is local, or one in #LOCAL_EVERY_GUESS if the order is a guess from the density of the
points. With more local samples, small groups of consistent outliers (repeated patterns) are taken
for the inliers more often. If Params::orderedEvery is 1, all samples are local, as in the paper,
unless #TERMINATION_PROSAC needs samples drawn as in PROSAC.

The first samples are uniform, because an easy search ends with them and needs no order: the first
#BEFORE_ORDER (8, see samplers.hpp), or #BEFORE_ORDER_CHEAP if the order is a guess and a sample has
fewer than #SMALL points. If the order is a guess, the next #ORDERED samples of at most #SMALL
points all follow it, because so few inliers are soon drawn from the densest points; and if
Params::maxIterations is below #LEAST, these samples are the first ones. */
class PNapsacSampler : public Sampler
{
public:
    PNapsacSampler() : m(0), uniform(0), centers(0) {}

    void start(const Context& context) CV_OVERRIDE
    {
        m = context.components.minimalSolver->sampleSize();
        const Params& params = context.params;
        uniform = params.maxIterations < LEAST || params.orderedEvery == 1 ? 0
                  : m < SMALL                                              ? BEFORE_ORDER_CHEAP
                                                                           : BEFORE_ORDER;
        growth = GrowingSet(m, context.points.size);
        centers = 0;
    }

    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        const bool guess = isGuess(context);
        if (!guess && !isOrderedByKnowledge(context, state, m, sample))
            return;
        growth.next();
        if (guess && !isOrderedGuess(context, state, sample))
            return;
        const int n = growth.size();
        const int center = state.bestFirst(context)[growth.newest() ? n - 1 : state.rng.uniform(n)];
        sample[0] = center;
        const int turn = guess ? state.iteration / context.params.orderedEvery
                               : state.orderedSamples - 1;
        const int every = localEvery(context);
        if (turn % every != every - 1 || !local(context, state, sample))
            global(state, n, sample);
    }

    double growingShare(const Context& context) const CV_OVERRIDE
    {
        return (1 - 1. / localEvery(context)) / context.params.orderedEvery;
    }

private:
    static int localEvery(const Context& context)
    {
        const Params& params = context.params;
        if (params.orderedEvery == 1 && (params.termination & TERMINATION_PROSAC) == 0)
            return 1;
        return isGuess(context) ? LOCAL_EVERY_GUESS : LOCAL_EVERY;
    }

    //! The same as isOrdered(), except for the first samples, see PNapsacSampler.
    bool isOrderedGuess(const Context& context, State& state, int* sample) const
    {
        if (state.iteration < uniform)
        {
            drawUniform(context, state, m, sample);
            return false;
        }
        if (m > SMALL || state.iteration >= uniform + ORDERED)
            return isOrdered(context, state, m, sample);
        state.counts = context.params.orderedEvery == 1;
        return true;
    }

    //! Number of times that a point was chosen as the first point of a local sample, and the finest
    //! layer in which the point might still have enough neighbors.
    struct Center
    {
        int chosen, layer;
    };

    //! Draws the other points from the neighbors of sample[0]. False if this point has enough
    //! neighbors in no layer.
    bool local(const Context& context, State& state, int* sample)
    {
        Neighborhood& neighborhood = context.neighborhood();
        if (!centers)
        {
            centers = context.arena.take<Center>(context.points.size);
            std::fill(centers, centers + context.points.size, Center());
        }
        Center& center = centers[sample[0]];
        // at most 16 doublings, to avoid an overflow
        const int wanted = FIRST_MEMBERS * m << std::min(center.chosen++, 16);
        // skips layers with too few neighbors
        for (; center.layer < neighborhood.layers(); ++center.layer)
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

    void global(State& state, int n, int* sample)
    {
        drawOthers(state.rng, state.order, n, m, sample);
    }

    int m;        //!< sample size
    int uniform;  //!< number of uniform samples at the start if the order is a guess
    GrowingSet growth;
    Center* centers;  //!< one element per point; null before the first local sample
};

}  // namespace

Ptr<Sampler> createPNapsacSampler() { return makePtr<PNapsacSampler>(); }

}  // namespace usacv20
}  // namespace cv
