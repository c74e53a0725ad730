// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "local_optimization/inlier_set.hpp"
#include "local_optimization/local_optimization.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The first and widest of the shrinking thresholds, as a multiple of the threshold. See
//! doc/constants.md.
constexpr int LO_WIDTH = 3;
//! An inner sample contains at most 1 / #LO_PART of the inliers, as in @cite chum2003locally.
constexpr int LO_PART = 2;
//! Maximum number of points of a fit of FLO-RANSAC, as a multiple of the minimal sample size, as in
//! @cite lebeda2012fixing.
constexpr int FLO_FIT = 7;

/** @brief Local optimization of LO-RANSAC @cite chum2003locally, or its variant in "Fixing the
locally optimized RANSAC" @cite lebeda2012fixing (FLO-RANSAC).

The model is fitted to the points within #LO_WIDTH thresholds. Then an inner RANSAC draws
Params::localSamples samples from the inliers of this fit. A sample has Params::localSampleMultiple
times the minimal size, but contains at most half of these inliers. A model is fitted to each sample
and then refined by Params::localIterations fits to the points within a threshold that shrinks from
#LO_WIDTH times the threshold to the threshold itself. The best of all these fits replaces the model
if it is better.

LO-RANSAC fits models to all points within these thresholds. FLO-RANSAC fits them to a random subset
of these points, of at most #FLO_FIT times the minimal sample size. The time of a fit is then
bounded, and the fits vary more. */
class LoRansacOptimizer : public LocalOptimizer
{
public:
    //! @param fitMultiple_ maximum number of points of a fit, as a multiple of the sample size
    explicit LoRansacOptimizer(int fitMultiple_) : fitMultiple(fitMultiple_) {}

    bool optimize(const Context& context, State& state, Model& model, Quality& quality) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize();
        const int largest = fitMultiple < INT_MAX / m ? fitMultiple * m : INT_MAX;
        Arena::Scope scope(context.arena);
        base.allocate(scope, context.points.size);
        inliers.allocate(scope, context.points.size);
        Model start = model;
        inliers.within(context, model, LO_WIDTH);
        if (inliers.size() <= m || !inliers.fit(context, inliers.select(state.rng, largest), start))
            return false;
        bool improved = keepBetter(context, start, model, quality);
        base.within(context, start, 1);
        const int small = std::min(m * context.params.localSampleMultiple, base.size() / LO_PART);
        if (small <= m)
            return improved;
        for (int i = 0; i < context.params.localSamples && !context.stop(); ++i)
        {
            Model inner = start;
            if (!base.fit(context, base.select(state.rng, small), inner))
                continue;
            improved |= keepBetter(context, inner, model, quality);
            improved |= shrink(context, state, m, largest, inner, model, quality);
        }
        return improved;
    }

private:
    //! Repeats least squares over the points within a shrinking threshold. Each fit starts from the
    //! previous fit. @return true if the model was replaced
    bool shrink(const Context& context, State& state, int m, int largest, Model fitted,
                Model& model, Quality& quality)
    {
        bool improved = false;
        const int steps = context.params.localIterations;
        for (int step = 0; step < steps && !context.stop(); ++step)
        {
            const double multiple = steps > 1 ? LO_WIDTH - (LO_WIDTH - 1.) * step / (steps - 1) : 1;
            inliers.within(context, fitted, multiple);
            if (inliers.size() <= m ||
                !inliers.fit(context, inliers.select(state.rng, largest), fitted))
                break;
            improved |= keepBetter(context, fitted, model, quality);
        }
        return improved;
    }

    const int fitMultiple;
    InlierSet base, inliers;
};

}  // namespace

Ptr<LocalOptimizer> createLoRansacOptimizer() { return makePtr<LoRansacOptimizer>(INT_MAX); }

Ptr<LocalOptimizer> createFloRansacOptimizer() { return makePtr<LoRansacOptimizer>(FLO_FIT); }

}  // namespace usacv20
}  // namespace cv
