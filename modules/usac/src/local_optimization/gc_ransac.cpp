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

//! Maximum number of Gauss-Newton steps of a fit, which starts from the model to be improved. A few
//! steps are enough for a sample of several times the minimal size. See doc/constants.md.
constexpr int GC_FIT_STEPS = 3;

/** @brief Local optimization of Graph-Cut RANSAC as in its paper @cite barath2018graph;
GraphCutOptimizer is a faster variant.

Each iteration finds the inliers of the model with a graph cut (Labeling) and fits models to random
samples of these inliers. A sample has Params::localSampleMultiple times the minimal size, or
contains all inliers if there are fewer. The first iteration without a better model is the last one.
Params::localIterations bounds the number of iterations, Params::localSamples the number of samples
per iteration. */
class GcRansacOptimizer : public LocalOptimizer
{
public:
    void start(const Context&) CV_OVERRIDE { labeling.start(); }

    bool optimize(const Context& context, State& state, Model& model, Quality& quality) CV_OVERRIDE
    {
        const Params& params = context.params;
        const int m = context.components.minimalSolver->sampleSize();
        Arena::Scope scope(context.arena);
        inliers.allocate(scope, context.points.size);
        bool improved = false, better = true;
        for (int i = 0; i < params.localIterations && better && !context.stop(); ++i)
        {
            inliers.count = labeling.cut(context, model, inliers.members);
            if (inliers.size() <= m)
                break;
            better = false;
            const int size = m * params.localSampleMultiple,
                      samples = inliers.size() > size ? params.localSamples : 1;
            for (int k = 0; k < samples && !context.stop(); ++k)
                better |= inliers.improve(context, inliers.select(state.rng, size), model, quality,
                                          GC_FIT_STEPS);
            improved |= better;
        }
        return improved;
    }

private:
    Labeling labeling;
    InlierSet inliers;
};

}  // namespace

Ptr<LocalOptimizer> createGcRansacOptimizer() { return makePtr<GcRansacOptimizer>(); }

}  // namespace usacv20
}  // namespace cv
