// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/growth.hpp"
#include "components/streams.hpp"
#include "loop/ransac.hpp"
#include "scoring/common_neighbors.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! A runner-up is optimized only if more than this fraction of its inliers are points that the best
//! model does not explain, or if the problem is ambiguous.
constexpr double DIFFERENT = 0.1;

//! The wide threshold of Ransac::beginNear(), as a multiple of the threshold. An initial model that
//! is wrong by up to about ten thresholds then leads to the right model; with 8 by up to about
//! twenty, but with a threshold of 6 pixels among many wrong matches, more often to a wrong one.
constexpr double WIDER = 4;
//! The initial model is not optimized at the wide threshold if more than this fraction of the
//! points within it are inliers. With 0.5, four times as many F as with 1 that are wrong by twenty
//! thresholds stay wrong; with 0.9, as many as with 0.75.
constexpr double SETTLED = 0.75;

}  // namespace

Ransac::Ransac(const Context& context_, State& state_, bool checkSamples)
    : context(context_), parts(context_.components), state(state_), checks(context_, state_),
      stopping(context_, state_),
      runnersUp(context_.components.localOptimizer ? context_.params.runnersUp : 0, context_.arena),
      alternatives(!runnersUp.none() && !context_.components.score->wholeModel(), context_),
      batch(context_, state_, checks, runnersUp, checkSamples),
      rivals(context_, state_, checks, batch, runnersUp, stopping),
      literal(context_.params.localOptimization == LOCAL_OPTIMIZATION_GC_RANSAC), sampled(false),
      localTicks(0)
{}

// Numbers in comments are lines of Algorithm 1 (see Ransac): 2, 3, 7 and 13 in run(), 14 to 18 in
// improve(), 19 to 24 in optimize(), 25 and 26 in setBest(). Lines 3 to 13 are also in SampleBatch.
bool Ransac::run(int pause)
{
    const int64 start = getTickCount();
    const double localBefore = localTicks;
    int repeatedBefore = state.repeatedSamples;
    bool ended = true;
    if (parts.verifier)
        parts.verifier->adapt(context, state);
    while (!stopping.reached() || lookBeside())  // 2
    {
        ended = state.iteration < pause;
        if (!ended)
            break;
        if (adaptTerminations())
            continue;
        const bool first = batch.begins() && !literal;
        batch.draw();  // 3
        Candidate best;
        bool found = false;
        for (int i = 0; i < batch.size() && !stopping.reached(); ++i)
        {
            const Hypotheses& h = batch.hypotheses(i);  // 4 - 13
            ++state.iteration;
            state.counts = batch.counts(i);
            account(h);
            for (int k = 0; k < h.count; ++k)  // 7
            {
                const Candidate candidate(batch.sample(i), h.models[k], h.qualities[k]);
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
                if (literal)
                    state.sampleQuality = state.bestQuality;
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
            stopping.update();
    }
    if (ended && !stopping.interrupted())
        chooseByRank();
    state.report.stop = stopping.reason();
    const double ticks = (double)(getTickCount() - start) - (localTicks - localBefore);
    state.report.localMs = localTicks / getTickFrequency() * 1e3;
    state.report.searchMs += ticks / getTickFrequency() * 1e3;
    return ended;
}

//! State::sampleQuality, with which models of samples are compared, is not set here. Otherwise
//! hardly any model of a sample would be optimized, because hardly any has as good a score as an
//! optimized model; and the initial model might be that of another motion.
void Ransac::begin(const Model& initial, const Sample* sample, int drawn)
{
    Model model = initial;
    Quality quality = context.rate(model);
    state.rng = Rng(context.params.seed, streamOf(STREAM_REFINEMENT));
    if (!(quality.cost < context.points.size) || !checks.recover(0, model, quality))
        return;
    if (parts.localOptimizer)
        optimize(sample, model, quality);
    if (quality.betterThan(state.bestQuality))
        setBest(model, quality, sample);
    state.forgotten = -drawn;
}

//! The wide threshold has a context and a state of its own, so that nothing of the run depends on
//! it but the model that is offered.
void Ransac::beginNear(const Model& initial)
{
    begin(initial);
    if (!parts.localOptimizer)
        return;
    Correspondences points = context.points;
    points.threshold *= WIDER;
    const Context wide(points, parts, context.params, context.arena, context.watch);
    if (state.bestQuality.cost <= DBL_MAX &&
        state.bestQuality.inliers >= SETTLED * wide.rate(state.best).inliers)
        return;
    const int64 start = getTickCount();
    Model model = initial;
    Quality quality = wide.rate(model);
    State apart;
    apart.rng = Rng(context.params.seed, streamOf(STREAM_REFINEMENT));
    ++state.report.localOptimizations;
    const bool changed = parts.localOptimizer->optimize(wide, apart, model, quality);
    localTicks += (double)(getTickCount() - start);
    if (changed)
        begin(model);
}

void Ransac::thresholdChanged()
{
    runnersUp.clear();
    alternatives.clear();
    rivals.clear();
    state.sampleQuality = Quality();
    checks.thresholdChanged();
    Quality quality = context.rate(state.best);
    const bool valid = checks.recover(0, state.best, quality);
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

bool Ransac::adaptTerminations()
{
    const int wanted = state.wanted;
    const bool changed = stopping.adapt(state);
    if (state.wanted != wanted && state.iteration > 0)
        improveRunnersUp();
    if (changed)
        stopping.update();
    return changed;
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
    report.rejectedModels += h.rejected;
    report.refusedModels += h.refused;
    report.droppedModels += h.dropped;
    // The best model might have changed since a thread scored these models. Whether the verifier or
    // the cost excludes them is therefore decided anew; otherwise the report would depend on the
    // number of threads.
    for (int k = 0; k < h.stopped; ++k)
        ++(h.costs[k] < uselessCost() ? report.refusedModels : report.droppedModels);
}

/* Processes a model that is better than the models of all previous samples, or a runner-up. The
paper compares the model with the optimized best model instead; but a good model of a noisy sample
is often worse than an optimized bad model, and would then never be optimized. (If `literal` is
true, it is compared as in the paper.) `before` is the value of State::sampleQuality before this
model. If a check rejects the model or makes it no better than `before`, this value is restored, and
the model is not optimized: if inliers depend on each other, this can happen in every second sample.
*/
void Ransac::improve(const Candidate& candidate, const Quality& before)
{
    Model model = candidate.model;
    Quality quality = candidate.quality;
    state.rng = Rng(context.params.seed, streamOf(STREAM_REFINEMENT, state.iteration));
    const bool valid = checks.recover(candidate.sample.val, model, quality);  // 14
    if (!valid || candidate.quality.betterThan(quality))
        state.sampleQuality = valid && quality.betterThan(before) ? quality : before;
    // a runner-up is optimized although it was never better than `before`
    if (!valid || (candidate.quality.betterThan(before) && !quality.betterThan(before)))
        return;  // 15, 16
    if (parts.localOptimizer && !stopping.interrupted())
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
    if (quality.cost <= DBL_MAX)
        checks.updateSuccessProbability(model);
    if (!runnersUp.none())
        runnersUp.setBest(InlierBits(context, model, RunnersUp::EXPLAINED));
    stopping.update();  // 26
}

double Ransac::uselessCost() const
{
    return runnersUp.uselessCost(state.sampleQuality.cost, context.points.size);
}

void Ransac::addRunnerUp(const Candidate& candidate)
{
    if (!runnersUp.none() && candidate.quality.cost < uselessCost())
        runnersUp.add(candidate, InlierBits(context, candidate.model));
}

bool Ransac::lookBeside()
{
    if (stopping.interrupted())
        return false;
    improveRunnersUp();
    if (stopping.reached() && rivals.search(stopping.reason()))
        improveRunnersUp();
    return !stopping.reached();
}

void Ransac::improveRunnersUp()
{
    const RunnerUp* taken;
    const int count = runnersUp.take(taken);
    for (int i = 0; i < count && !stopping.interrupt(); ++i)
        if (worthOptimizing(taken[i]))
            improve(taken[i].candidate, state.sampleQuality);
}

//! A model with nearly the same inliers as the best model is not worth optimizing, because it leads
//! to the same optimum, unless the problem is ambiguous (Problem::ambiguous). A model whose cost
//! has meanwhile become useless (uselessCost()) is not worth it either, unless it is a rival.
bool Ransac::worthOptimizing(const RunnerUp& runnerUp) const
{
    const int unexplained = runnerUp.inliers.without(runnersUp.best());
    if (unexplained < rivals.rivalInliers() && runnerUp.candidate.quality.cost >= uselessCost())
        return false;
    return context.points.problem->ambiguous() ||
           unexplained > DIFFERENT * runnerUp.inliers.count();
}

//! Lines 19 to 24. They are repeated if the optimized model was degenerate and Checks::recover()
//! has replaced it with a better model.
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
            offer(optimized, checks.discounted(optimized, optimizedQuality), sample);
        const Quality before = optimizedQuality;
        if (!optimizedQuality.betterThan(state.bestQuality) ||
            !checks.recover(0, optimized, optimizedQuality) ||  // 20, 21
            !optimizedQuality.betterThan(quality))              // 22, 23
            break;
        ++state.report.localImprovements;
        model = optimized;  // 24
        quality = optimizedQuality;
        again = optimizedQuality.betterThan(before) && !literal;
    }
    localTicks += (double)(getTickCount() - start);
}

void Ransac::offer(const Model& model, const Quality& quality, const Sample* sample)
{
    if (alternatives.active() && quality.cost <= DBL_MAX)
        alternatives.offer(context, Candidate(sample ? *sample : Sample(), model, quality),
                           sample != 0);
}

void Ransac::chooseByRank()
{
    if (!alternatives.contested())
        return;  // nothing to decide, so no ranking of the points is needed
    const int compared = std::min(context.points.size, MATCHES_COMPARED);
    Arena::Scope scope(context.arena);
    uchar* common = 0;
    if (hasCommonNeighbors(*context.points.problem))
    {
        common = scope.take<uchar>(compared);
        commonNeighbors(context.points, compared, context.inlierThreshold(), common, context.arena);
    }
    const int* const order = orderIsKnown(context) ? state.bestFirst(context) : 0;
    const Alternative* const chosen = alternatives.chosen(context, order, common);
    if (chosen)
    {
        const Candidate candidate = chosen->candidate;
        setValid(candidate.model, chosen->sampled ? &candidate.sample : 0);
    }
}

//! Makes a model the best one if no degeneracy check rejects it. If a check finds another model of
//! lower cost (Degeneracy::recover), that model is ignored, because here the ranking decides, not
//! the cost.
void Ransac::setValid(const Model& model, const Sample* sample)
{
    Model checked = model;
    const Quality quality = checks.discounted(model, context.rate(model));
    Quality other = quality;
    if (checks.recover(0, checked, other))
        setBest(model, quality, sample);
}

}  // namespace usacv20
}  // namespace cv
