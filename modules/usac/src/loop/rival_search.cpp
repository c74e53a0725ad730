// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "loop/rival_search.hpp"
#include "components/check_components.hpp"
#include "components/sample_statistics.hpp"
#include "components/streams.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Without evidence of a rival, the number of samples of unexplained points for one best model is
//! at most 1 / FIRST_PART of the number of all samples drawn so far, or LEAST_SAMPLES if this is
//! more.
constexpr int FIRST_PART = 64, LEAST_SAMPLES = 8;
//! With evidence of a rival, the number of samples of unexplained points for all best models so far
//! is at most 1 / MOST_PART of the number of other samples drawn so far, but LEAST_SAMPLES are
//! allowed for each best model.
constexpr int MOST_PART = 3;
//! A rival has at least this many inliers that the best model does not explain, as a fraction of
//! the inliers of the best model. Models of random wrong matches reach fractions up to 0.06, models
//! of matches in a cluster up to 0.15.
constexpr double RIVAL = 0.1;
//! The number of samples is computed for a rival that has as many inliers as the best model. The
//! best model does not explain this fraction of the inliers of the rival.
constexpr double FOR_ITSELF = 2. / 3;

}  // namespace

RivalSearch::RivalSearch(const Context& context_, State& state_, const Checks& checks_,
                         const SampleBatch& batch_, RunnersUp& runnersUp_,
                         const Stopping& stopping_)
    : context(context_), state(state_), checks(checks_), batch(batch_), runnersUp(runnersUp_),
      stopping(stopping_), m(context_.components.minimalSolver->sampleSize()), unexplainedSamples(0)
{}

int RivalSearch::unexplainedPoints(int* indices) const
{
    const Correspondences& p = context.points;
    Arena::Scope scope(context.arena);
    float* const errors = scope.take<float>(p.size);
    context.components.residual->squaredErrors(p, state.best, 0, p.size, errors);
    const double width = RunnersUp::EXPLAINED * context.inlierThreshold();
    const float limit = (float)(width * width);
    int count = 0;
    for (int i = 0; i < p.size; ++i)
    {
        indices[count] = i;
        count += !(errors[i] <= limit);  // NaN counts as unexplained
    }
    return count;
}

double RivalSearch::rivalInliers() const
{
    const double looked = std::min<int>(context.points.size, InlierBits::MOST);
    return RIVAL * state.bestQuality.inliers * looked / context.points.size;
}

bool RivalSearch::search(int ending)
{
    const int drawn = state.iteration;
    if (runnersUp.none() || explored == state.best || state.bestQuality.inliers <= m ||
        drawn >= context.params.maxIterations)
        return false;
    explored = state.best;
    const double wanted = FOR_ITSELF * state.bestQuality.inliers;
    if (ending != STOP_ORDER && wanted > context.points.size - state.bestQuality.inliers)
        return false;
    Arena::Scope scope(context.arena);
    int* const indices = scope.take<int>(context.points.size);
    const int count = unexplainedPoints(indices);
    if (count <= m)
        return false;
    if (ending == STOP_ORDER)
        sampleUnexplained(indices, count,
                          state.unexplainedSamples <= INT_MAX / context.params.persistence
                              ? state.unexplainedSamples * context.params.persistence
                              : INT_MAX);
    if (wanted <= count)
        sampleForRivals(indices, count, wanted, drawn);
    unexplainedSamples += state.iteration - drawn;
    return true;
}

void RivalSearch::sampleForRivals(const int* indices, int count, double wanted, int drawn)
{
    const int needed = samplesNeeded(goodSampleProbability(wanted, count, m, true),
                                     std::log(1 - context.params.confidence));
    const int few = std::max(drawn / FIRST_PART, LEAST_SAMPLES);
    const int many = std::max((drawn - unexplainedSamples) / MOST_PART - unexplainedSamples,
                              LEAST_SAMPLES);
    const double rival = rivalInliers();
    if (runnersUp.mostTaken() < rival)
        sampleUnexplained(indices, count, std::min(needed, few) - (state.iteration - drawn));
    if (std::max(runnersUp.mostTaken(), runnersUp.mostUnexplained()) >= rival)
        sampleUnexplained(indices, count, std::min(needed, many) - (state.iteration - drawn));
}

void RivalSearch::sampleUnexplained(const int* indices, int count, int most)
{
    const int end = state.iteration +
                    std::min(most, context.params.maxIterations - state.iteration);
    Sample drawn[MinimalSolver::MAX_TOGETHER];
    Hypotheses solved[MinimalSolver::MAX_TOGETHER];
    for (int i = batch.ahead(); state.iteration < end && !stopping.interrupt();
         ++state.iteration, ++i)
    {
        if (i == batch.ahead())
        {
            i = 0;
            const int next = std::min(batch.ahead(), end - state.iteration);
            for (int k = 0; k < next; ++k)
                drawn[k] = drawUnexplained(indices, count, state.iteration + k);
            batch.solve(drawn, next, solved);
        }
        if (solved[i].rejectedSample)
        {
            ++state.report.rejectedSamples;
            continue;
        }
        const int computed = solved[i].computed;
        const Model* const models = solved[i].models;
        checkModels(models, computed);
        state.report.models += computed;
        state.report.degenerateSamples += computed == 0;
        for (int k = 0; k < computed; ++k)
            if (!checks.validModel(drawn[i].val, models[k]))
                ++state.report.rejectedModels;
            else if (!addRival(drawn[i], models[k]))
                ++state.report.droppedModels;
    }
}

Sample RivalSearch::drawUnexplained(const int* indices, int count, int index) const
{
    Rng rng(context.params.seed, streamOf(STREAM_UNEXPLAINED, index));
    Sample sample;
    rng.distinct(count, m, sample.val);
    for (int k = 0; k < m; ++k)
        sample[k] = indices[sample[k]];
    return sample;
}

bool RivalSearch::addRival(const Sample& sample, const Model& model)
{
    const InlierBits inliers(context, model);
    const int own = inliers.without(runnersUp.best());
    if (own < rivalInliers() || own <= m)
        return false;
    if (runnersUp.wants(own))
        runnersUp.add(Candidate(sample, model, context.rate(model)), inliers);
    return true;
}

}  // namespace usacv20
}  // namespace cv
