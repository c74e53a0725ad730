// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLERS_HPP
#define OPENCV_USACV20_SAMPLERS_HPP

#include "opencv2/usac/components.hpp"
#include "components/growth.hpp"

namespace cv {
namespace usacv20 {

//! Draws a uniform sample of `m` points from all points.
inline void drawUniform(const Context& context, State& state, int m, int* sample)
{
    state.counts = true;
    state.rng.distinct(context.points.size, m, sample);
}

/** @brief Decides from Params::orderedEvery how the current sample is drawn.

If the result is true, the sampler must draw the sample in its own, non-uniform way; State::counts
is true for such a sample only if all samples are drawn in this way. If the result is false, this
function has drawn a uniform sample. @param m sample size */
inline bool isOrdered(const Context& context, State& state, int m, int* sample)
{
    const int every = context.params.orderedEvery;
    if (state.iteration % every == 0)
    {
        state.counts = every == 1;
        return true;
    }
    drawUniform(context, state, m, sample);
    return false;
}

//! Number of samples at the start of a search that are uniform even if later samples follow a known
//! order of the points (unless Params::orderedEvery is 1). PNapsacSampler also uses this number for
//! a guessed order. Many searches end with these samples, and then need neither the order nor
//! neighborhoods.
constexpr int BEFORE_ORDER = 8;

//! The same as isOrdered() for a known order of the points, see orderIsKnown(). Depending on
//! State::wanted, the result is true more often, but not for the first #BEFORE_ORDER samples if
//! Params::orderedEvery is above 1.
inline bool isOrderedByKnowledge(const Context& context, State& state, int m, int* sample)
{
    const int every = context.params.orderedEvery;
    const int step = state.wanted == SAMPLES_ORDERED ? 1
                     : state.wanted == SAMPLES_HALF  ? std::min(every, 2)
                                                     : every;
    if (state.iteration % step != 0 || (every > 1 && state.iteration < BEFORE_ORDER))
    {
        drawUniform(context, state, m, sample);
        return false;
    }
    state.counts = every == 1;
    ++state.orderedSamples;
    return true;
}

//! Creates a sampler for which all samples are equally likely, see UniformSampler.
Ptr<Sampler> createUniformSampler();
//! Creates a sampler that uses the best points first, see ProsacSampler.
Ptr<Sampler> createProsacSampler();
//! Creates a sampler that uses the best points and their neighbors first, see PNapsacSampler.
Ptr<Sampler> createPNapsacSampler();
//! Creates a sampler that draws a random point and some of its neighbors, see NapsacSampler.
Ptr<Sampler> createNapsacSampler();
//! Creates a sampler that draws points with probabilities proportional to their scores, see
//! ImportanceSampler.
Ptr<Sampler> createImportanceSampler();

//! Sets sample[1] .. sample[m-1] to points that are drawn from the `count` elements of `members`,
//! so that all points of the sample are distinct. `members` must contain sample[0], and `count`
//! must be at least `m`.
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
