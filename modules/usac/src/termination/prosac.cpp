// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/growth.hpp"
#include "components/repetitions.hpp"
#include "components/sample_statistics.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

//! SIGNIFICANCE: upper bound of the probability that the inliers of a model arise by chance, as in
//! @cite chum2005matching. ROUNDING allows for rounding errors of T_n (see Growth).
constexpr double SIGNIFICANCE = 0.05, ROUNDING = 1 + 1e-9;
//! The loop of prosacSamples() tries all lengths n, that is, sets of the n best points. After every
//! PART lengths it checks whether the run must end. LENGTH_WORK is the work per length in point
//! tests of 2 ns, the unit of Watch: up to 0.4 us. Both constants affect only how late a run with a
//! time limit ends.
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

If maximality and non-randomness hold for the set of the n* best points (see prosacSamples()), the
search ends when T'_n* samples have been drawn (see Growth for T_n and T'_n). Three things differ
from the paper:

- In the paper, the set stops growing at n*, and the n* that needs the fewest samples for maximality
is chosen. Here the set keeps growing, because other criteria need samples of all points, and the
smallest n* is chosen. Only the first T'_n* samples count, which come from the n* best points
(except uniform samples and the local samples of P-NAPSAC). Only for n* = N can more than T'_N
samples be needed, and then all of them count.
- In the paper, each sample counts as much as a uniform sample. But the first samples must contain
the newest point of a small set: whatever the order of the inliers is, the first T'_n* samples are
worth only T_n* uniform samples. If each sample counted fully, two or three samples of the very best
points could end a run with a wrong model.
- In the paper, 5 % bounds the probability that one wrong model has as many inliers as the best
model. But the best of thousands of wrong models usually has that many inliers. Here 5 % bounds the
probability that any of the wrong models of T'_n* samples has that many.

Inliers that share a cell of the size of the threshold with an earlier inlier in either image (see
markRepeated) do not count for non-randomness, because the best points are often copies of one
match. The order must be independent of the positions of the points, like an order by scores: many
wrong models fit all points in the densest region of the images, and these points come first with
#ORDERING_DENSITY.

Takes one pass over the points for each new best model, and a second pass, without the repeated
inliers, if both conditions hold after the first one. */
class ProsacTermination : public Termination
{
public:
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
            inliers[i] = errors[state.order[i]] <= limit;  // NaN is not an inlier
        const int every = countsOrdered(context, state) ? context.params.orderedEvery : 1;
        const double kept = share * every * keptProbability(context, state.bestQuality.inliers);
        const bool exact = (context.params.termination & TERMINATION_EXACT) != 0;
        const double logFailure = std::log(1 - context.params.confidence);
        const double randomRatio = context.randomInlierRatio();
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
    //! True if the set grows only with samples that follow the order, not with all samples.
    static bool countsOrdered(const Context& context, const State& state)
    {
        return context.params.orderedEvery > 1 && state.orderedSamples > 0;
    }

    //! Total number of samples at which `samples` of them have followed the order, if from now on
    //! one in `every` samples follows it.
    static int ofAll(int samples, int every, const State& state)
    {
        if (samples == INT_MAX)
            return samples;
        const double all = every == 1
                               ? samples
                               : state.remembered() +
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
};

}  // namespace

Ptr<Termination> createProsacTermination() { return makePtr<ProsacTermination>(); }

}  // namespace usacv20
}  // namespace cv
