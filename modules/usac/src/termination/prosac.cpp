// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "core/growth.hpp"
#include "core/repetitions.hpp"
#include "termination/non_randomness.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

//! What the probability of a support by chance must be below, as in @cite chum2005matching (half,
//! double: no run of the lists differs); T_n may be an integer.
constexpr double SIGNIFICANCE = 0.05, ROUNDING = 1 + 1e-9;
//! Lengths between two questions whether the run has to end; tests of a point, as Watch counts
//! them, that a length takes: up to 0.4 us. Half, double: the run ends as late, within the noise.
constexpr int PART = 1024;
constexpr double LENGTH_WORK = 200;

int prosacSamples(const uchar* inliers, const uchar* repeated, int size, int m, double kept,
                  double randomRatio, double logFailure, bool exact, int& length,
                  const Context* context)
{
    int support = 0, repetitions = 0;
    Growth growth(m, size);
    for (int i = 0; i < size; ++i)
    {
        if (i % PART == PART - 1 && context && context->stop(PART * LENGTH_WORK))
            break;
        support += inliers[i];
        repetitions += repeated && repeated[i];
        length = i + 1;
        if (length > m)
            growth.grow();
        if (support <= m)
            continue;
        const int needed = samplesNeeded(goodSampleProbability(support, length, m, exact) * kept,
                                         logFailure);
        const double missing = std::max(std::ceil(needed - ROUNDING * growth.uniformSamples()), 0.);
        const double drawn = growth.samples() + missing;
        if ((missing == 0 || length == size) && drawn < INT_MAX &&
            chanceOf(support - repetitions, length - repetitions, m, randomRatio) * drawn <
                SIGNIFICANCE)
            return (int)drawn;
    }
    length = 0;
    return INT_MAX;
}

namespace {

/** @brief PROSAC: maximality and non-randomness in the n* best points @cite chum2005matching.

A length n* at which both hold, see prosacSamples, ends the search when T'_n* samples have been
drawn. Three things differ from the paper:

- There the set stops growing at n*, and the n* with the fewest samples needed for maximality is
chosen. Here the set grows on, as other criteria may need it; so the samples up to the T'_n*-th
count, which were drawn from the n* best points (with P-NAPSAC but for the local and the uniform
ones), and the n* that is reached first is chosen. Of all lengths only n* = N has samples without
end.
- There each sample counts. But the first ones must contain the newest of a few points: they are
worth T_n* uniform samples, however the inliers are ordered, and more only by good luck. With all of
them, two or three samples of the very best points ended real runs with whatever model they gave.
- There the 5 % are those of one wrong model. But the best of thousands of wrong models has a
support of that kind more often than not; in small scenes a tenth of the runs ended with one. Here
they are those of all T'_n* samples.

Inliers that lie within a threshold of a better one in either image do not count for non-randomness,
as the best points are often one match found several times. The criterion wants an order that has
nothing to do with where the points are, as scores have it: in the densest place of the images
(#ORDERING_DENSITY) many wrong models fit all points.

O(N) an update, O(N log N) once the rest is fulfilled. */
class ProsacTermination : public Termination
{
public:
    ProsacTermination() : randomRatio(1) {}

    void start(const Context& context) CV_OVERRIDE { randomRatio = context.randomInlierRatio(); }

    int iterations(const Context& context, const State& state) const CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize(), size = context.points.size;
        const double share = context.components.sampler->growingShare(context);
        if (state.bestQuality.inliers <= m || !state.order || !(share > 0))
            return INT_MAX;
        Arena::Scope scope(context.arena);
        float* const errors = scope.take<float>(size);
        context.components.residual->squaredErrors(context.points, state.best, 0, size, errors);
        const float limit = (float)(context.inlierThreshold() * context.inlierThreshold());
        uchar *const inliers = scope.take<uchar>(size), *const repeated = scope.take<uchar>(size);
        for (int i = 0; i < size; ++i)
            inliers[i] = errors[state.order[i]] <= limit;  // false for NaN
        const int every = countsOrdered(context, state) ? context.params.orderedEvery : 1;
        const double kept = share * every * keptProbability(context, state.bestQuality.inliers);
        const bool exact = (context.params.termination & TERMINATION_EXACT) != 0;
        const double logFailure = std::log(1 - context.params.confidence);
        int length;
        const int samples = prosacSamples(inliers, 0, size, m, kept, randomRatio, logFailure, exact,
                                          length, &context);
        if (samples == INT_MAX || context.stopBefore(size * REPETITION_WORK))
            return INT_MAX;
        markRepeatedInliers(context, state.order, inliers, repeated);
        return ofAll(prosacSamples(inliers, repeated, size, m, kept, randomRatio, logFailure, exact,
                                   length, &context),
                     every, state);
    }

    int reason() const CV_OVERRIDE { return STOP_PROSAC; }

private:
    //! True if the set grows with the samples that follow the order, not with all.
    static bool countsOrdered(const Context& context, const State& state)
    {
        return context.params.orderedEvery > 1 && state.orderedSamples > 0;
    }

    //! Of `samples` that follow the order, those that lack are one in `every`, or more.
    static int ofAll(int samples, int every, const State& state)
    {
        if (samples == INT_MAX || every == 1)
            return samples;
        const double all = state.iteration +
                           std::max(samples - state.orderedSamples, 0) * (double)every;
        return all < INT_MAX ? (int)all : INT_MAX;
    }

    static void markRepeatedInliers(const Context& context, const int* order, const uchar* inliers,
                                    uchar* repeated)
    {
        const Correspondences& p = context.points;
        std::fill(repeated, repeated + p.size, (uchar)0);
        markRepeated(p, order, inliers, p.size, context.inlierThreshold(), repeated, context.arena);
    }

    double randomRatio;
};

}  // namespace

Ptr<Termination> createProsacTermination() { return makePtr<ProsacTermination>(); }

}  // namespace usacv20
}  // namespace cv
