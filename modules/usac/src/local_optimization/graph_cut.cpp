// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "local_optimization/inlier_set.hpp"
#include "local_optimization/labeling.hpp"
#include "local_optimization/local_optimization.hpp"

namespace cv {
namespace usacv20 {

namespace {

// Half and double of these: doc/constants.md.

//! Points: more than this make a fit slower, not better, while the inliers are still changing.
//! Half, double: errors within 2 %; 128 to shrink: time of E +4 %.
constexpr int MAX_FIT = 256, MAX_SHRINK = 64;
//! Steps of Gauss and Newton's method from a model that is not yet near the inliers. One: time -2
//! to -4 %, errors within 1 %, but +2 % (E) under a forward motion; four: within 1 %, E +3 % time.
constexpr int SHRINK_STEPS = 2;
//! The same from one that is. Two: time +2 to +3 %, errors the same to a thousandth.
constexpr int FIT_STEPS = 1;
//! An inner sample takes at most 1 / #PART of the inliers, as in @cite chum2003locally. 1,
//! 4: errors within 1 %.
constexpr int PART = 2;
//! The first threshold of the shrinking ones, in thresholds. 2: lists the same, scenes of few
//! points fail a bit more often; 6 with six fits: errors -2 to -4 %, time +6 to +12 %.
constexpr int WIDE = 3;
//! An alternation that lowers the cost by less than this is the last one. 0.985: time +2 to +5 %;
//! 0.94: -1 %, errors within 1 %.
constexpr double WORTHWHILE = 0.97;
//! Where a labeling without neighbors changes from inliers to outliers, in thresholds: K = 1 / 2.
const double LABELED = std::sqrt(2 * CV_LOG2);

/** @brief Local optimization of Graph-Cut RANSAC @cite barath2018graph.

Alternates between the spatially coherent inliers of the model (Labeling) and an inner RANSAC over
them: models fitted to random samples of Params::localSampleMultiple times the minimal size, and to
all of them up to a bound. Before, as in LO-RANSAC @cite chum2003locally, the model is fitted to the
points within a multiple of the threshold that shrinks to 1: from a minimal sample the threshold
alone leads to the nearest local optimum, whose inliers confirm it. If that does not make the model
clearly better than the best one so far, it ends there. A fit that is better replaces the model; the
first alternation without a clear gain is the last, and their number is bounded. */
class GraphCutOptimizer : public LocalOptimizer
{
public:
    void start(const Context&) CV_OVERRIDE { labeling.start(); }

    bool optimize(const Context& context, State& state, Model& model, Quality& quality) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize();
        Arena::Scope scope(context.arena);
        inliers.allocate(scope, context.points.size);
        bool improved = shrink(context, state, m, model, quality);
        double before = state.bestQuality.cost;
        for (int i = 0; i < context.params.localIterations && quality.cost < WORTHWHILE * before &&
                        !context.stop();
             ++i)
        {
            before = quality.cost;
            if (i > 0)
                improved |= shrink(context, state, m, model, quality);
            if (context.params.spatialWeight > 0)
                inliers.count = labeling.cut(context, model, inliers.members);
            else
                inliers.within(context, model, LABELED);
            if (inliers.size() > m)
                improved |= fitInliers(context, state, m, model, quality);
        }
        return improved;
    }

private:
    //! Fits to the points within #WIDE, ..., 2 and 1 thresholds, each from the last fit.
    bool shrink(const Context& context, State& state, int m, Model& model, Quality& quality)
    {
        Model fitted = model;
        bool improved = false;
        for (int multiple = WIDE; multiple >= 1 && !context.stop(); --multiple)
        {
            inliers.within(context, fitted, multiple);
            if (inliers.size() <= m ||
                !inliers.fit(context, inliers.select(state.rng, MAX_SHRINK), fitted, SHRINK_STEPS))
                break;
            improved |= keepBetter(context, fitted, model, quality);
        }
        return improved;
    }

    bool fitInliers(const Context& context, State& state, int m, Model& model, Quality& quality)
    {
        const int count = inliers.size();
        const int small = std::max(m + 1,
                                   std::min(m * context.params.localSampleMultiple, count / PART));
        bool improved = inliers.improve(context, inliers.select(state.rng, MAX_FIT), model, quality,
                                        FIT_STEPS);
        for (int i = 0; i < context.params.localSamples && small < count && !context.stop(); ++i)
            improved |= inliers.improve(context, inliers.select(state.rng, small), model, quality,
                                        FIT_STEPS);
        return improved;
    }

    Labeling labeling;
    InlierSet inliers;
};

}  // namespace

Ptr<LocalOptimizer> createGraphCutOptimizer() { return makePtr<GraphCutOptimizer>(); }

}  // namespace usacv20
}  // namespace cv
