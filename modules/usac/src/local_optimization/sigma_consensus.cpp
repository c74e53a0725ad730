// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/selection.hpp"
#include "local_optimization/inlier_set.hpp"
#include "local_optimization/local_optimization.hpp"
#include "local_optimization/sigma_consensus.hpp"
#include "scoring/marginalized_weights.hpp"

namespace cv {
namespace usacv20 {

//! Selects the points within the threshold under `model`, or #MAX_FIT random points of these if
//! there are more, and sorts them by ascending error.
void SigmaConsensus::select(const Context& context, Rng& rng, const Model& model, Near* all)
{
    const Correspondences& p = context.points;
    const float scale = (float)(1 / (p.threshold * p.threshold));
    Arena::Scope scope(context.arena);
    float* const errors = scope.take<float>(p.size);
    context.components.residual->squaredErrors(p, model, 0, p.size, errors);
    int size = 0;
    for (int i = 0; i < p.size; ++i)
    {
        const Near point = {errors[i] * scale, i};
        if (point.error < 1)  // NaN is not selected
            all[size++] = point;
    }
    count = std::min<int>(size, MAX_FIT);
    randomPart(all, size, count, rng);
    std::copy(all, all + count, near);
    std::sort(near, near + count);
    for (int i = 0; i < count; ++i)
        indices[i] = near[i].index;
}

void SigmaConsensus::marginalize(const Context& context, PointSubset& subset, const Model& model,
                                 int part)
{
    const MarginalizedWeights& table = MarginalizedWeights::of(
        context.points.problem->errorDimension());
    const double* const squared = subset.squaredErrors(*context.components.residual, model);
    const double scale = 1 / (context.points.threshold * context.points.threshold);
    const double end = (double)part / partitions, begin = (part - 1.0) / partitions;
    for (int i = 0; i < count; ++i)
    {
        const double u = std::max(squared[i] * scale, 1.0 / (int)MarginalizedWeights::SIZE);
        if (u < end * end)  // NaN gets no weight
            weights[i] += table.tabulatedWeight((float)(u / (end * end))) -
                          (part > 1 ? table.tabulatedWeight((float)(u / (begin * begin))) : 0.f);
    }
}

bool SigmaConsensus::fit(const Context& context, Rng& rng, Model& model)
{
    {
        Arena::Scope scope(context.arena);
        select(context, rng, model, scope.take<Near>(context.points.size));
    }
    const int size = count, m = context.components.minimalSolver->sampleSize();
    if (size <= m)
        return false;
    const NonMinimalSolver& solver = context.nonMinimalSolver();
    std::fill(weights, weights + size, 0.);
    Arena::Scope scope(context.arena);
    PointSubset subset(context.points, size, scope);
    for (int i = 0; i < size; ++i)
        subset.add(indices[i]);
    Model fitted = model;
    for (int part = 1, within = 0, last = 0; part <= partitions; ++part, last = within)
    {
        const double reach = (double)part / partitions;
        while (within < size && near[within].error < reach * reach)
            ++within;
        Model next = model;
        if (within > m && within != last && solver.fit(context.points, indices, within, 0, next))
            fitted = next;
        marginalize(context, subset, fitted, part);
    }
    int kept = 0;
    for (int i = 0; i < size; ++i)
        if (weights[i] > 0)
        {
            indices[kept] = indices[i];
            weights[kept++] = weights[i];
        }
    count = kept;
    return kept > m && solver.fit(context.points, indices, kept, weights, model);
}

namespace {

/** Local optimization with SigmaConsensus: at most Params::localIterations marginalized fits, each
of which starts from the result of the previous fit. A better fit replaces the model; the first fit
that is not better is the last one. */
class SigmaConsensusOptimizer : public LocalOptimizer
{
public:
    bool optimize(const Context& context, State& state, Model& model, Quality& quality) CV_OVERRIDE
    {
        bool improved = false;
        for (int i = 0; i < context.params.localIterations && !context.stop(); ++i)
        {
            Model fitted = model;
            if (!consensus.fit(context, state.rng, fitted))
                break;
            if (!keepBetter(context, fitted, model, quality))
                break;
            improved = true;
        }
        return improved;
    }

private:
    SigmaConsensus consensus;
};

}  // namespace

Ptr<LocalOptimizer> createSigmaConsensus() { return makePtr<SigmaConsensusOptimizer>(); }

}  // namespace usacv20
}  // namespace cv
