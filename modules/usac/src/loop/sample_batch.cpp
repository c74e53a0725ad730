// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "loop/sample_batch.hpp"
#include "components/check_components.hpp"
#include "components/streams.hpp"
#include "control/watch.hpp"
#include "scoring/scores.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Number of samples in the largest batch: enough work for several threads.
constexpr int LARGEST_BATCH = 256;
/** Number of samples in the first batch; half as many if samples are expensive, as for E. The batch
is small because only the best of its models is optimized at once. */
constexpr int FIRST_BATCH = 8;
//! A sample is expensive if SampleCost::time exceeds this many point tests: for E (1500), but not
//! for F (300).
constexpr int EXPENSIVE = 1000;
//! Batches whose samples take less time than this to solve (in point tests; a tenth of a
//! millisecond) are not distributed to threads. The result does not depend on this value.
constexpr double PARALLEL_WORK = 44800;
//! Work of each thread between two checks of the clock in a run with a time limit or a
//! ProgressScope, in point tests (two milliseconds). The value only affects when such a run ends.
constexpr double TOGETHER = 1e6;

}  // namespace

// Numbers in comments are lines of Algorithm 1 (see Ransac).

SampleBatch::SampleBatch(const Context& context_, State& state_, const Checks& checks_,
                         const RunnersUp& runnersUp_, bool checkSamples_)
    : context(context_), state(state_), checks(checks_), runnersUp(runnersUp_),
      checkSamples(checkSamples_),
      together(std::min(std::max(context_.components.minimalSolver->together(), 1),
                        (int)MinimalSolver::MAX_TOGETHER)),
      threads(std::min<int>(context_.params.threads > 0 ? context_.params.threads : getNumThreads(),
                            LARGEST_BATCH)),
      samples(context_.arena.take<Sample>(LARGEST_BATCH)),
      counted(context_.arena.take<uchar>(LARGEST_BATCH)), solved(0), errorRows(0), reserved(0),
      drawn(0), first(0), parallel(false)
{}

void SampleBatch::draw()
{
    const double cost = context.points.problem->sampleCost().time;
    const int before = drawn;
    const int wanted = begins() ? (cost > EXPENSIVE ? FIRST_BATCH / 2 : FIRST_BATCH)
                                : std::min<int>(2 * drawn, LARGEST_BATCH);
    drawn = std::min(wanted, context.params.maxIterations - state.iteration);
    for (int i = before; i < drawn; ++i)
        new (samples + i) Sample();
    first = state.iteration;
    for (int i = 0; i < drawn; ++i, ++state.iteration)
    {
        state.rng = Rng(context.params.seed, state.iteration);
        state.counts = true;
        context.components.sampler->sample(context, state, samples[i].val);  // 3
        if (checkSamples)
            checkSample(samples[i].val, context.components.minimalSolver->sampleSize(),
                        context.points.size);
        counted[i] = state.counts;
        if (context.stop(1) && i + 1 < drawn)
            drawn = i + 1;
    }
    state.iteration = first;
    parallel = threads > 1 && drawn * cost >= PARALLEL_WORK;
    reserve(parallel ? LARGEST_BATCH : together, parallel ? threads : 1);
    if (parallel)
        hypothesizeAll();
}

void SampleBatch::reserve(int wanted, int rows)
{
    if (reserved >= wanted)
        return;
    reserved = wanted;
    solved = context.arena.take<Hypotheses>(wanted);
    for (int i = 0; i < wanted; ++i)
        new (solved + i) Hypotheses;
    if (context.components.score->wholeModel())
        errorRows = context.arena.take<float>((size_t)rows * context.points.size);
}

//! Divides the batch among the threads, each of which has its own memory. If the run has a time
//! limit or a ProgressScope, the batch is processed in parts, and the clock is checked after each
//! part.
void SampleBatch::hypothesizeAll()
{
    const bool watched = context.watch && context.watch->isActive();
    const double work = context.points.problem->sampleCost().time + context.points.size;
    const int part = watched ? std::max((int)(TOGETHER / work), 1) * threads : drawn;
    for (int done = 0; done < drawn; done += part)
    {
        hypothesizePart(done, std::min(part, drawn - done));
        if (context.stop(TOGETHER))
            drawn = std::min(drawn, done + part);
    }
}

void SampleBatch::hypothesizePart(int begin, int count)
{
    parallel_for_(
        Range(0, threads),
        [this, begin, count](const Range& range) {
            for (int t = range.start; t < range.end; ++t)
            {
                float* const row = errorRows ? errorRows + (size_t)t * context.points.size : 0;
                const int from = begin + (int)((int64)count * t / threads),
                          to = begin + (int)((int64)count * (t + 1) / threads);
                for (int i = from; i < to; ++i)
                {
                    if ((i - from) % together == 0)
                        solve(samples + i, std::min(together, to - i), solved + i);
                    score(i, solved[i], row);
                }
            }
        },
        threads);
}

const Hypotheses& SampleBatch::hypotheses(int index)
{
    if (parallel)
        return solved[index];
    if (index % together == 0)
        solve(samples + index, std::min(together, drawn - index), solved);
    Hypotheses& h = solved[index % together];
    score(index, h, errorRows);
    return h;
}

//! Called by several threads at the same time, each with a different `h`; writes only to `h`.
void SampleBatch::solve(const Sample* sampled, int count, Hypotheses* h) const
{
    const int* valid[MinimalSolver::MAX_TOGETHER];
    Model* models[MinimalSolver::MAX_TOGETHER];
    int found[MinimalSolver::MAX_TOGETHER];
    for (int i = 0; i < count; ++i)
        valid[i] = sampled[i].val;
    const int accepted = checks.acceptSamples(valid, count);  // 4
    for (int i = 0, k = 0; i < count; ++i)
    {
        const int* const sample = sampled[i].val;
        h[i].rejectedSample = k == accepted || valid[k] != sample;
        h[i].repeated = h[i].rejectedSample && checks.mayBeGood(sample);
        if (!h[i].rejectedSample)
            models[k++] = h[i].models;  // 5
    }
    if (accepted > 0)
        context.components.minimalSolver->solveMany(context.points, valid, accepted, models,
                                                    found);  // 6
    for (int i = 0, k = 0; i < count; ++i)
        h[i].computed = h[i].rejectedSample ? 0 : found[k++];
}

//! Called by several threads at the same time, each with a different `h` and `row`; writes only to
//! `h` and `row`.
void SampleBatch::score(int index, Hypotheses& h, float* row) const
{
    const int* const sample = samples[index].val;
    const Verifier* const verifier = context.components.verifier.get();
    h.count = h.rejected = h.refused = h.dropped = h.firstInliers = h.firstTested = h.stopped = 0;
    if (h.rejectedSample)
        return;
    checkModels(h.models, h.computed);
    Rng rotation(context.params.seed, streamOf(STREAM_ROTATION, first + index));
    const double useless = runnersUp.uselessCost(state.sampleQuality.cost, context.points.size);
    for (int k = 0; k < h.computed; ++k)  // 7
    {
        const Model& model = h.models[k];
        if (!checks.validModel(sample, model))  // 8
        {
            ++h.rejected;
            continue;  // 9
        }
        const int start = rotation.uniform(context.points.size) & ~15;
        int inliers = 0, tested = 0;
        const bool passed = !verifier || verifier->preTest(context, model, rotation, inliers,
                                                           tested);  // 10
        h.firstInliers += inliers;
        h.firstTested += tested;
        if (!passed)
        {
            ++h.refused;
            continue;  // 11
        }
        const Rating rating = rate(context, verifier, model, useless, start, row);  // 10, 12
        // after preTest(), the first block is evaluated only for models that have passed preTest();
        // its inlier ratio would be biased
        if (tested == 0)
        {
            h.firstInliers += rating.firstInliers;
            h.firstTested += rating.firstTested;
        }
        if (rating.complete)  // 13
        {
            h.models[h.count] = model;  // moves good models to the front
            h.qualities[h.count++] = rating.quality;
        }
        else if (rating.refused)
            h.costs[h.stopped++] = rating.costBefore;  // 11
        else
            ++h.dropped;
    }
}

}  // namespace usacv20
}  // namespace cv
