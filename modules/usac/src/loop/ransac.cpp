// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/check_components.hpp"
#include "components/growth.hpp"
#include "components/streams.hpp"
#include "loop/ransac.hpp"
#include "scoring/scores.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

namespace {

// doc/measurements/constants_tables.md lists the effects of halving or doubling each constant.

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

//! A model can become a runner-up if its gain is more than this fraction of the gain of the best
//! model that any sample has given so far. The gain is the number of points, which is the cost
//! without any model, minus the cost.
constexpr double WORTHWHILE = 0.6;
//! A runner-up is optimized only if more than this fraction of its inliers are points that the best
//! model does not explain, or if the problem is ambiguous.
constexpr double DIFFERENT = 0.1;

Degeneracy* const* pointersTo(const std::vector<Ptr<Degeneracy>>& checks, Arena& arena)
{
    Degeneracy** const result = arena.take<Degeneracy*>(checks.size());
    for (size_t d = 0; d < checks.size(); ++d)
        result[d] = checks[d].get();
    return result;
}

int samplesAhead(const MinimalSolver& solver)
{
    return std::min(std::max(solver.together(), 1), (int)MinimalSolver::MAX_TOGETHER);
}

}  // namespace

Ransac::Ransac(const Context& context_, State& state_, bool checkSamples_)
    : context(context_), parts(context_.components), state(state_),
      m(parts.minimalSolver->sampleSize()), checks(pointersTo(parts.degeneracies, context_.arena)),
      checkCount((int)parts.degeneracies.size()),
      samples(context_.arena.take<Sample>(LARGEST_BATCH)),
      counts(context_.arena.take<uchar>(LARGEST_BATCH)), batch(0), errorRows(0), size(0),
      hypotheses(0),
      runnersUp(context_.components.localOptimizer ? context_.params.runnersUp : 0, context_.arena),
      alternatives(!runnersUp.none() && !context_.components.score->wholeModel(), context_),
      sampled(false), unexplainedSamples(0), rivals(0),
      threads(std::min<int>(context_.params.threads > 0 ? context_.params.threads : getNumThreads(),
                            LARGEST_BATCH)),
      sampleWork(context_.points.problem->sampleCost().time + context_.points.size),
      firstOfBatch(0), ahead(samplesAhead(*parts.minimalSolver)),
      exhaustive(exhaustiveSamples(context_)), required(exhaustive), requiredReason(STOP_STANDARD),
      requiredOfAll(INT_MAX), reasonOfAll(STOP_STANDARD), ending(STOP_STANDARD), anyModel(false),
      localTicks(0), checkSamples(checkSamples_)
{}

// Numbers in comments are lines of Algorithm 1 (see Ransac): 2, 3, 7 and 13 in run(), 4 to 6 in
// solve(), 7 to 13 in hypothesize(), 14 to 18 in improve(), 19 to 24 in optimize(), 25 and 26 in
// setBest().
bool Ransac::run(int pause)
{
    const int64 start = getTickCount();
    const double localBefore = state.report.localMs;
    int repeatedBefore = state.repeatedSamples;
    bool ended = true;
    if (parts.verifier)
        parts.verifier->adapt(context, state);
    while (!terminate() || lookBeside())  // 2
    {
        ended = state.iteration < pause;
        if (!ended)
            break;
        if (adaptTerminations())
            continue;
        drawBatch();  // 3
        const bool first = state.iteration == 0;
        const bool together = threads > 1 &&
                              size * context.points.problem->sampleCost().time >= PARALLEL_WORK;
        reserve(together ? LARGEST_BATCH : ahead, together ? threads : 1);
        if (together)
            hypothesizeBatch();
        Candidate best;
        bool found = false;
        for (int i = 0; i < size && !terminate(); ++i)
        {
            const Hypotheses& h = together ? batch[i] : hypothesizeNext(i);
            ++state.iteration;
            state.counts = counts[i] != 0;
            account(h);
            for (int k = 0; k < h.count; ++k)  // 7
            {
                const Candidate candidate(samples[i], h.models[k], h.qualities[k]);
                if (!candidate.quality.betterThan(state.sampleQuality))  // 13
                {
                    addRunnerUp(candidate);
                    ++state.report.droppedModels;
                    continue;
                }
                const Quality before = state.sampleQuality;
                state.sampleQuality = candidate.quality;
                if (!first)
                    improve(candidate, before);
                else if (found)
                    addRunnerUp(best);
                best = candidate;
                found = true;
            }
        }
        if (first && found)
            improve(best, Quality());
        const int tests = state.tests.size();
        const bool repeated = state.repeatedSamples != repeatedBefore;
        repeatedBefore = state.repeatedSamples;
        if (parts.verifier)
            parts.verifier->adapt(context, state);
        if (state.tests.size() != tests || repeated)
            updateTermination();
    }
    if (ended && !stopped())
        chooseByRank();
    state.report.stop = ending;
    state.report.localMs = localTicks / getTickFrequency() * 1e3;
    state.report.searchMs += (getTickCount() - start) / getTickFrequency() * 1e3 -
                             (state.report.localMs - localBefore);
    return ended;
}

//! State::sampleQuality, with which models of samples are compared, is not set here. Otherwise
//! hardly any model of a sample would be optimized, because hardly any has as good a score as an
//! optimized model; and the initial model might be that of another motion.
void Ransac::begin(const Model& initial, int drawn)
{
    Model model = initial;
    Quality quality = context.rate(model);
    state.rng = Rng(context.params.seed, streamOf(STREAM_REFINEMENT));
    if (!(quality.cost < context.points.size) || !recover(0, model, quality))
        return;
    if (parts.localOptimizer)
        optimize(0, model, quality);
    if (quality.betterThan(state.bestQuality))
        setBest(model, quality, 0);
    state.forgotten = -drawn;
}

void Ransac::thresholdChanged()
{
    runnersUp.clear();
    alternatives.clear();
    explored = Model();
    state.sampleQuality = Quality();
    for (int d = 0; d < checkCount; ++d)
        checks[d]->thresholdChanged(context);
    Quality quality = context.rate(state.best);
    const bool valid = recover(0, state.best, quality);
    state.bestQuality = valid ? quality : Quality();  // Quality(): there is no best model
    const Sample sample = sampleOfBest;
    if (valid && parts.localOptimizer)
    {
        state.rng = Rng(context.params.seed, streamOf(STREAM_REFINEMENT, state.iteration));
        optimize(sampled ? &sample : 0, state.best, state.bestQuality);
    }
    setBest(state.best, state.bestQuality, sampled ? &sample : 0);
}

void Ransac::forgetSamples()
{
    state.forgotten = state.iteration;
    state.countedSamples = state.repeatedSamples = state.orderedSamples = 0;
    state.tests.resize(0);
    parts.sampler->start(context);  // the growing set of the best points begins anew
    if (parts.verifier)
        parts.verifier->start(context);
    for (size_t t = 0; t < parts.terminations.size(); ++t)
        parts.terminations[t]->start(context);
}

//! Batches grow, so that easy problems draw few superfluous samples and hard problems use all
//! threads.
void Ransac::drawBatch()
{
    const int left = context.params.maxIterations - state.iteration;
    const bool expensive = context.points.problem->sampleCost().time > EXPENSIVE;
    const int before = size;
    const int wanted = size == 0 ? (expensive ? FIRST_BATCH / 2 : FIRST_BATCH)
                                 : std::min<int>(2 * size, LARGEST_BATCH);
    size = std::min(wanted, left);
    for (int i = before; i < size; ++i)
        new (samples + i) Sample();
    firstOfBatch = state.iteration;
    for (int i = 0; i < size; ++i, ++state.iteration)
    {
        state.rng = Rng(context.params.seed, state.iteration);
        state.counts = true;
        parts.sampler->sample(context, state, samples[i].val);
        if (checkSamples)
            checkSample(samples[i].val, m, context.points.size);
        counts[i] = state.counts;
        if (stop(1) && i + 1 < size)
            size = i + 1;
    }
    state.iteration = firstOfBatch;
}

void Ransac::reserve(int wanted, int rows)
{
    if (hypotheses >= wanted)
        return;
    hypotheses = wanted;
    batch = context.arena.take<Hypotheses>(wanted);
    for (int i = 0; i < wanted; ++i)
        new (batch + i) Hypotheses;
    if (parts.score->wholeModel())
        errorRows = context.arena.take<float>((size_t)rows * context.points.size);
}

//! Called by several threads at the same time, each with a different `h`; writes only to `h`.
void Ransac::solve(const Sample* drawn, int count, Hypotheses* h) const
{
    const int* valid[MinimalSolver::MAX_TOGETHER];
    Model* models[MinimalSolver::MAX_TOGETHER];
    int found[MinimalSolver::MAX_TOGETHER], solved = 0;
    for (int i = 0; i < count; ++i)
    {
        const int* const sample = drawn[i].val;
        h[i].repeated = false;
        h[i].rejectedSample = !validSample(sample);  // 4
        for (int d = 0; d < checkCount && h[i].rejectedSample && !h[i].repeated; ++d)
            h[i].repeated = checks[d]->mayBeGood(context, sample);
        if (h[i].rejectedSample)
            continue;  // 5
        valid[solved] = sample;
        models[solved++] = h[i].models;
    }
    if (solved > 0)
        parts.minimalSolver->solveMany(context.points, valid, solved, models, found);  // 6
    for (int i = 0, k = 0; i < count; ++i)
        h[i].computed = h[i].rejectedSample ? 0 : found[k++];
}

//! Called by several threads at the same time, each with a different `h` and `row`; writes only to
//! `h` and `row`.
void Ransac::hypothesize(int index, Hypotheses& h, float* row) const
{
    const int* sample = samples[index].val;
    h.count = h.rejected = h.refused = h.dropped = h.firstInliers = h.firstTested = h.stopped = 0;
    if (h.rejectedSample)
        return;
    checkModels(h.models, h.computed);
    Rng rotation(context.params.seed, streamOf(STREAM_ROTATION, firstOfBatch + index));
    for (int k = 0; k < h.computed; ++k)  // 7
    {
        const Model& model = h.models[k];
        if (!validModel(sample, model))  // 8
        {
            ++h.rejected;
            continue;  // 9
        }
        const int start = rotation.uniform(context.points.size) & ~15;
        int inliers = 0, tested = 0;
        const bool passed = !parts.verifier || parts.verifier->preTest(context, model, rotation,
                                                                       inliers, tested);  // 10
        h.firstInliers += inliers;
        h.firstTested += tested;
        if (!passed)
        {
            ++h.refused;
            continue;  // 11
        }
        const Rating rating = rate(context, parts.verifier.get(), model, uselessCost(), start,
                                   row);  // 10, 12
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

const Hypotheses& Ransac::hypothesizeNext(int index)
{
    if (index % ahead == 0)
        solve(samples + index, std::min(ahead, size - index), batch);
    Hypotheses& h = batch[index % ahead];
    hypothesize(index, h, errorRows);
    return h;
}

bool Ransac::validSample(const int* sample) const
{
    bool valid = true;
    for (int d = 0; valid && d < checkCount; ++d)
        valid = checks[d]->validSample(context, sample);
    return valid;
}

bool Ransac::validModel(const int* sample, const Model& model) const
{
    bool valid = true;
    for (int d = 0; valid && d < checkCount; ++d)
        valid = checks[d]->validModel(context, sample, model);
    return valid;
}

/* Processes a model that is better than the models of all previous samples, or a runner-up. The
paper compares the model with the optimized best model instead; but a good model of a noisy sample
is often worse than an optimized bad model, and would then never be optimized. `before` is the value
of State::sampleQuality before this model. This value is restored if a check rejects the model or
makes it no better than `before`. */
void Ransac::improve(const Candidate& candidate, const Quality& before)
{
    Model model = candidate.model;
    Quality quality = candidate.quality;
    state.rng = Rng(context.params.seed, streamOf(STREAM_REFINEMENT, state.iteration));
    const bool valid = recover(candidate.sample.val, model, quality);  // 14
    if (!valid || candidate.quality.betterThan(quality))
        state.sampleQuality = valid && quality.betterThan(before) ? quality : before;
    if (!valid)
        return;  // 15, 16
    if (parts.localOptimizer && !stopped())
        optimize(&candidate.sample, model, quality);  // 19 - 24
    if (quality.betterThan(state.bestQuality))        // 18
        setBest(model, quality, &candidate.sample);
}

void Ransac::setBest(const Model& model, const Quality& quality, const Sample* sample)
{
    sampled = sample != 0;
    if (sampled)
        sampleOfBest = *sample;
    state.best = model;  // 25
    offer(model, quality, sample);
    state.bestQuality = quality;
    state.successProbability = 1;
    for (int d = 0; d < checkCount && quality.cost <= DBL_MAX; ++d)
        state.successProbability *= checks[d]->successProbability(context, state, model);
    if (!runnersUp.none())
        runnersUp.setBest(InlierBits(context, model, EXPLAINED));
    updateTermination();  // 26
}

double Ransac::uselessCost() const
{
    const double best = state.sampleQuality.cost, points = context.points.size;
    return runnersUp.none() ? best : std::max(best, points - WORTHWHILE * (points - best));
}

void Ransac::addRunnerUp(const Candidate& candidate)
{
    if (!runnersUp.none() && candidate.quality.cost < uselessCost())
        runnersUp.add(candidate, InlierBits(context, candidate.model));
}

bool Ransac::lookBeside()
{
    if (stopped())
        return false;
    improveRunnersUp();
    if (terminate() && searchUnexplained())
        improveRunnersUp();
    return !terminate();
}

void Ransac::improveRunnersUp()
{
    rivals = runnersUp.mostUnexplained();
    const RunnerUp* taken;
    const int count = runnersUp.take(taken);
    for (int i = 0; i < count && !stop(sampleWork); ++i)
        if (worthOptimizing(taken[i]))
            improve(taken[i].candidate, state.sampleQuality);
}

//! A model with nearly the same inliers as the best model is not worth optimizing, because it leads
//! to the same optimum, unless the problem is ambiguous (Problem::ambiguous). A model whose cost
//! has meanwhile become useless (uselessCost()) is not worth it either, unless it is a rival.
bool Ransac::worthOptimizing(const RunnerUp& runnerUp) const
{
    const int unexplained = runnerUp.inliers.without(runnersUp.best());
    if (unexplained < rivalInliers() && runnerUp.candidate.quality.cost >= uselessCost())
        return false;
    return context.points.problem->ambiguous() ||
           unexplained > DIFFERENT * runnerUp.inliers.count();
}

//! Lines 19 to 24. They are repeated if the optimized model was degenerate and recover() has
//! replaced it with a better model.
void Ransac::optimize(const Sample* sample, Model& model, Quality& quality)
{
    const int64 start = getTickCount();
    for (bool again = true; again;)
    {
        Model optimized = model;
        Quality optimizedQuality = quality;
        ++state.report.localOptimizations;
        if (!parts.localOptimizer->optimize(context, state, optimized, optimizedQuality))  // 19
            break;
        if (alternatives.active() && !optimizedQuality.betterThan(state.bestQuality))
            offer(optimized, discounted(optimized, optimizedQuality), sample);
        const Quality before = optimizedQuality;
        if (!optimizedQuality.betterThan(state.bestQuality) ||
            !recover(0, optimized, optimizedQuality) ||  // 20, 21
            !optimizedQuality.betterThan(quality))       // 22, 23
            break;
        ++state.report.localImprovements;
        model = optimized;  // 24
        quality = optimizedQuality;
        again = optimizedQuality.betterThan(before);
    }
    localTicks += (double)(getTickCount() - start);
}

bool Ransac::recover(const int* sample, Model& model, Quality& quality)
{
    for (int d = 0; d < checkCount; ++d)
        if (!checks[d]->recover(context, state, sample, model, quality))
            return false;
    for (int d = 0; d < checkCount; ++d)
        checks[d]->discount(context, model, quality);
    return true;
}

void Ransac::account(const Hypotheses& h)
{
    Report& report = state.report;
    state.repeatedSamples += state.counts && h.repeated;
    state.counts = state.counts && !h.repeated;
    state.countedSamples += state.counts;
    if (parts.verifier)
        parts.verifier->sampleTested(state, h.firstInliers, h.firstTested);
    report.rejectedSamples += h.rejectedSample;
    if (h.rejectedSample)
        return;
    report.degenerateSamples += h.computed == 0;
    report.models += h.computed;
    anyModel = anyModel || h.computed > 0;
    report.rejectedModels += h.rejected;
    report.refusedModels += h.refused;
    report.droppedModels += h.dropped;
    // The best model might have changed since a thread scored these models. Whether the verifier or
    // the cost excludes them is therefore decided anew; otherwise the report would depend on the
    // number of threads.
    for (int k = 0; k < h.stopped; ++k)
        ++(h.costs[k] < uselessCost() ? report.refusedModels : report.droppedModels);
}

}  // namespace usacv20
}  // namespace cv
