// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLERS_HPP
#define OPENCV_USACV20_SAMPLERS_HPP

#include "opencv2/usac/components.hpp"
#include "components/growth.hpp"

namespace cv {
namespace usacv20 {

//! Draws a uniform sample from all points.
inline void drawUniform(const Context& context, State& state, int* sample)
{
    state.counts = true;
    state.rng.distinct(context.points.size, context.components.minimalSolver->sampleSize(), sample);
}

/** @brief Decides by Params::orderedEvery how the current sample is drawn.

True: the sampler has to draw it in its own way; the sample counts for the termination criteria only
if all samples are drawn in this way. False: a uniform sample has been drawn. */
inline bool isOrdered(const Context& context, State& state, int* sample)
{
    const int every = context.params.orderedEvery;
    if (state.iteration % every == 0)
    {
        state.counts = every == 1;
        return true;
    }
    drawUniform(context, state, sample);
    return false;
}

//! Number of first samples that are uniform even if some samples follow an order: many searches end
//! with them and then need neither the order nor neighborhoods. See doc/constants.md.
constexpr int BEFORE_ORDER = 8;

//! isOrdered() for a known order (orderIsKnown()); State::wanted may make it true more often.
inline bool isOrderedByKnowledge(const Context& context, State& state, int* sample)
{
    const int every = context.params.orderedEvery;
    const int step = state.wanted == SAMPLES_ORDERED ? 1
                     : state.wanted == SAMPLES_HALF  ? std::min(every, 2)
                                                     : every;
    if (state.iteration % step != 0 || (every > 1 && state.iteration < BEFORE_ORDER))
    {
        drawUniform(context, state, sample);
        return false;
    }
    state.counts = every == 1;
    ++state.orderedSamples;
    return true;
}

//! All samples equally likely, see UniformSampler.
Ptr<Sampler> createUniformSampler();
//! The best points first, see ProsacSampler.
Ptr<Sampler> createProsacSampler();
//! The best points and their neighbors first, see PNapsacSampler.
Ptr<Sampler> createPNapsacSampler();
//! A random point and its neighbors, see NapsacSampler.
Ptr<Sampler> createNapsacSampler();
//! Points drawn in proportion to their scores, see ImportanceSampler.
Ptr<Sampler> createImportanceSampler();

//! Fills places 1 .. m-1 of a sample with distinct points of `count` >= m `members`, of which
//! sample[0] is one.
inline void drawOthers(Rng& rng, const int* members, int count, int m, int* sample)
{
    for (int k = 1; k < m;)
    {
        sample[k] = members[rng.uniform(count)];
        int j = 0;
        while (sample[j] != sample[k])
            ++j;
        k += j == k;
    }
}

}  // namespace usacv20
}  // namespace cv

#endif
