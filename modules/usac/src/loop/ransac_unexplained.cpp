// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/check_components.hpp"
#include "components/sample_statistics.hpp"
#include "components/streams.hpp"
#include "loop/ransac.hpp"

/* Draws samples of the points that the best model does not explain, when the search is about to
end.

Wrong matches can be consistent with each other: matches of repeated windows have a common shift, a
moving object has its own motion. Their model can have enough inliers to end the search before the
model of the correct matches is found. Finding the model of the correct matches takes a good sample,
and many all-inlier samples are not good: with noise, half of the all-inlier samples for H and most
of those for F and E yield models that SPRT rejects. But if two models share few of their inliers,
the points that one model does not explain are mostly inliers of the other model, and samples of
these points are all-inlier samples far more often. For example, suppose that 45 % of the points are
inliers of a first model and another 35 % are inliers of a second model. Then (45 / 65)^7 = 8 % of
the samples of seven points that the second model does not explain are all-inlier samples of the
first model, instead of (45 / 100)^7 = 0.4 % of the samples of all points.

For each best model, a few such samples are drawn if there are enough points for a rival. There
might be a rival, a second model with about as many inliers as the best model, if the model of such
a sample, or a runner-up, has many inliers that the best model does not explain: at least the
fraction RIVAL of the number of inliers of the best model. Then more such samples are drawn: as many
as are needed to find, with the required confidence, a model that has as many inliers as the best
model and shares at most a third of them with it; but at most a third of the number of other samples
drawn so far. If ConfirmedOrderTermination is about to end the search, a group of wrong matches
might come first in the order of the points; that criterion then sets the minimum number of these
samples (State::unexplainedSamples). All these samples count as iterations, but not for
State::countedSamples. */

namespace cv {
namespace usacv20 {

namespace {

// doc/measurements/constants_tables.md lists the effects of halving or doubling each constant.

//! Without evidence of a rival, the number of samples of unexplained points for one best model is
//! at most 1 / FIRST_PART of the number of all samples drawn so far, or LEAST_SAMPLES if this is
//! more.
constexpr int FIRST_PART = 64, LEAST_SAMPLES = 4;
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

int Ransac::unexplainedPoints(int* indices) const
{
    const Correspondences& p = context.points;
    Arena::Scope scope(context.arena);
    float* const errors = scope.take<float>(p.size);
    parts.residual->squaredErrors(p, state.best, 0, p.size, errors);
    const double width = EXPLAINED * context.inlierThreshold();
    const float limit = (float)(width * width);
    int count = 0;
    for (int i = 0; i < p.size; ++i)
    {
        indices[count] = i;
        count += !(errors[i] <= limit);  // NaN counts as unexplained
    }
    return count;
}

double Ransac::rivalInliers() const
{
    const double looked = std::min<int>(context.points.size, InlierBits::MOST);
    return RIVAL * state.bestQuality.inliers * looked / context.points.size;
}

bool Ransac::searchUnexplained()
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

void Ransac::sampleForRivals(const int* indices, int count, double wanted, int drawn)
{
    const int needed = samplesNeeded(goodSampleProbability(wanted, count, m, true),
                                     std::log(1 - context.params.confidence));
    const int few = std::max(drawn / FIRST_PART, LEAST_SAMPLES);
    const int many = std::max((drawn - unexplainedSamples) / MOST_PART - unexplainedSamples,
                              LEAST_SAMPLES);
    const double rival = rivalInliers();
    if (rivals < rival)
        sampleUnexplained(indices, count, std::min(needed, few) - (state.iteration - drawn));
    if (std::max(rivals, runnersUp.mostUnexplained()) >= rival)
        sampleUnexplained(indices, count, std::min(needed, many) - (state.iteration - drawn));
}

void Ransac::sampleUnexplained(const int* indices, int count, int most)
{
    const int end = state.iteration +
                    std::min(most, context.params.maxIterations - state.iteration);
    Sample drawn[MinimalSolver::MAX_TOGETHER];
    Hypotheses solved[MinimalSolver::MAX_TOGETHER];
    for (int i = ahead; state.iteration < end && !stop(sampleWork); ++state.iteration, ++i)
    {
        if (i == ahead)
        {
            i = 0;
            const int next = std::min(ahead, end - state.iteration);
            for (int k = 0; k < next; ++k)
                drawn[k] = drawUnexplained(indices, count, state.iteration + k);
            solve(drawn, next, solved);
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
        anyModel = anyModel || computed > 0;
        state.report.degenerateSamples += computed == 0;
        for (int k = 0; k < computed; ++k)
            if (!validModel(drawn[i].val, models[k]))
                ++state.report.rejectedModels;
            else if (!addRival(drawn[i], models[k]))
                ++state.report.droppedModels;
    }
}

Sample Ransac::drawUnexplained(const int* indices, int count, int index) const
{
    Rng rng(context.params.seed, streamOf(STREAM_UNEXPLAINED, index));
    Sample sample;
    rng.distinct(count, m, sample.val);
    for (int k = 0; k < m; ++k)
        sample[k] = indices[sample[k]];
    return sample;
}

bool Ransac::addRival(const Sample& sample, const Model& model)
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
