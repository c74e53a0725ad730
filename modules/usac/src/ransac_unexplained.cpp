// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "check_components.hpp"
#include "core/sample_counts.hpp"
#include "core/streams.hpp"
#include "ransac.hpp"

/* Samples of the points that the best model leaves, when the search is about to end.

Wrong matches may agree with each other: repeated windows have a common shift, a moving object has a
motion of its own. Their model has as many inliers, beside chance, as the criteria of termination
promise to have found, or more. That of the right matches has only been found if one of their
samples was good enough, and of the samples of right matches many are not: with noise a half of
those of H, and most of F and E, give models that the sequential test drops. But where two models
have most of their inliers for themselves, the points that one of them leaves are mostly those of
the other, and samples of these are right far more often: with 45 % right matches and 35 % of
another model, (45 / 65)^7 = 8 % of those of seven points, where (45 / 100)^7 = 0.4 % of all are.

A few such samples are drawn in any case. If one of them, or a runner-up, has a part RIVAL of the
inliers of the best model for itself, there may be a rival, and as many are drawn as find a model
that has as many inliers as the best one, and most of them for itself, with the promised confidence;
at most a third as many as the search has drawn. Where an order that the data confirm has ended the
search (ConfirmedOrderTermination), it may be that of a wrong group; then as many are drawn as that
criterion wants. They count as iterations, but not for the criteria. */

namespace cv {
namespace usacv20 {

namespace {

// What half and double of these do: doc/constants.md. Search failures are those of H and F beside a
// motion that is nearly as large (doc/structured.md).

//! Without a sign of a rival one in so many samples is drawn, but LEAST_SAMPLES. 32: instructions
//! of H and E +1 %; 8 samples at least, with all of MOST_PART 1: USACV20_FAST misses half as many.
constexpr int FIRST_PART = 64, LEAST_SAMPLES = 4;
//! With one, at most one in so many. 1: instructions of H +6 %; 2: H +1 %, failures of USACV20_FAST
//! 20 -> 15 %.
constexpr int MOST_PART = 3;
//! A rival has this part of the inliers of the best model for itself. On random wrong matches it is
//! 0.06, of matches of a cluster 0.15 at most. 0.15: instructions of H -1 %, failures of
//! USACV20_FAST 20 -> 31 %; 0.2: 36 %.
constexpr double RIVAL = 0.1;
//! The least part of the inliers of a rival that it does not share with the best model, as samples
//! are counted.
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
        count += !(errors[i] <= limit);  // true for NaN
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
    if (state.report.stop != STOP_ORDER && wanted > context.points.size - state.bestQuality.inliers)
        return false;
    Arena::Scope scope(context.arena);
    int* const indices = scope.take<int>(context.points.size);
    const int count = unexplainedPoints(indices);
    if (count <= m)
        return false;
    if (state.report.stop == STOP_ORDER)
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
    for (; state.iteration < end && !stop(sampleWork); ++state.iteration)
    {
        Rng rng(context.params.seed, streamOf(STREAM_UNEXPLAINED, state.iteration));
        Sample sample;
        rng.distinct(count, m, sample.val);
        for (int k = 0; k < m; ++k)
            sample[k] = indices[sample[k]];
        if (!validSample(sample.val))
        {
            ++state.report.rejectedSamples;
            continue;
        }
        Model models[MAX_MODELS];
        const int computed = parts.minimalSolver->solve(context.points, sample.val, models);
        checkModels(models, computed);
        state.report.models += computed;
        state.report.degenerateSamples += computed == 0;
        for (int i = 0; i < computed; ++i)
            if (!validModel(sample.val, models[i]))
                ++state.report.rejectedModels;
            else if (!addRival(sample, models[i]))
                ++state.report.droppedModels;
    }
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
