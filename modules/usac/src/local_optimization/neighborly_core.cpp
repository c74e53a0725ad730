// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/check_components.hpp"
#include "components/point_subset.hpp"
#include "components/streams.hpp"
#include "local_optimization/neighborly_core.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! A match is neighborly if it has at least this number of common neighbors (commonNeighbors()).
//! With 2 instead of 3, many wrong matches of a facade are neighborly.
constexpr int NEIGHBORLY = 3;
//! Maximum number of samples (SAMPLES), and minimum number of neighborly inliers as a multiple of
//! the sample size (MULTIPLE).
constexpr int SAMPLES = 50, MULTIPLE = 2;
//! No more samples are drawn as soon as the probability that no sample so far consists only of
//! inliers is at most this.
constexpr double MISSED = 0.05;
//! Maximum numbers of least-squares fits (FITS) and of steps per fit (STEPS). The fits use the
//! inliers among the first MOST points of the run.
constexpr int FITS = 2, STEPS = 3, MOST = 400;

//! Writes to `indices` which of the first `size` points are within the threshold of a model and are
//! accepted by `wanted`. @return their number
template <class Wanted>
int inliersOf(const Context& context, const Model& model, int size, const Wanted& wanted,
              int* indices)
{
    const Correspondences& p = context.points;
    Arena::Scope scope(context.arena);
    float* const errors = scope.take<float>(size);
    context.components.residual->squaredErrors(p, model, 0, size, errors);
    const float limit = (float)(context.inlierThreshold() * context.inlierThreshold());
    int count = 0;
    for (int i = 0; i < size; ++i)
        if (errors[i] <= limit && wanted(i))
            indices[count++] = i;
    return count;
}

//! True if all degeneracy checks accept a model of a sample or, if `model` is null, the sample.
bool valid(const Context& context, const int* sample, const Model* model)
{
    for (const Ptr<Degeneracy>& check : context.components.degeneracies)
        if (!(model ? check->validModel(context, sample, *model)
                    : check->validSample(context, sample)))
            return false;
    return true;
}

//! A model of a sample, with its cost and its fraction of inliers (`share`), both over the points
//! from which the samples are drawn.
struct Sampled
{
    explicit Sampled(int size) : cost(size), share(0) {}

    //! Replaces the model with `other` if `other` has a lower MSAC cost on `points`.
    void improve(const Context& context, PointSubset& points, const Model& other)
    {
        const double limit = context.inlierThreshold() * context.inlierThreshold();
        const double* const errors = points.squaredErrors(*context.components.residual, other);
        double costOfOther = points.size();
        int inliers = 0;
        for (int k = 0; k < points.size(); ++k)
            if (errors[k] <= limit)
            {
                costOfOther -= 1 - errors[k] / limit;
                ++inliers;
            }
        if (!(costOfOther < cost))
            return;
        model = other;
        cost = costOfOther;
        share = (double)inliers / points.size();
    }

    Model model;
    double cost, share;
};

//! The best model of random samples of the points `members`; empty if no model is valid.
Model modelOf(const Context& context, const int* members, int size)
{
    const MinimalSolver& solver = *context.components.minimalSolver;
    const int m = solver.sampleSize();
    Arena::Scope scope(context.arena);
    PointSubset points(context.points, size, scope);
    for (int k = 0; k < size; ++k)
        points.add(members[k]);
    Sampled best(size);
    Rng rng(context.params.seed, streamOf(STREAM_CORE));
    for (int i = 0; i < SAMPLES && std::pow(1 - std::pow(best.share, m), i) > MISSED; ++i)
    {
        int sample[MAX_SAMPLE_SIZE];
        Model models[MAX_MODELS];
        rng.distinct(size, m, sample);
        for (int k = 0; k < m; ++k)
            sample[k] = members[sample[k]];
        const int found = valid(context, sample, 0) ? solver.solve(context.points, sample, models)
                                                    : 0;
        checkModels(models, found);
        for (int k = 0; k < found; ++k)
            if (valid(context, sample, models + k))
                best.improve(context, points, models[k]);
    }
    return best.model;
}

}  // namespace

bool neighborlyCore(const Context& context, const uchar* common, int count, const Model& best,
                    Model& core)
{
    const Correspondences& p = context.points;
    const int m = context.components.minimalSolver->sampleSize(), most = std::min(p.size, MOST);
    Arena::Scope scope(context.arena);
    int* const members = scope.take<int>(std::max(count, most));
    const int size = inliersOf(
        context, best, count, [common](int i) { return common[i] >= NEIGHBORLY; }, members);
    if (size < MULTIPLE * m || !context.components.nonMinimalSolver)
        return false;
    core = modelOf(context, members, size);
    for (int k = 0; k < FITS && core.size() > 0; ++k)
    {
        const int inliers = inliersOf(
            context, core, most, [](int) { return true; }, members);
        if (inliers < m || !context.nonMinimalSolver().fit(p, members, inliers, 0, core, STEPS))
            break;
    }
    return core.size() > 0;
}

}  // namespace usacv20
}  // namespace cv
