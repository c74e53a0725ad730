// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "local_optimization/inlier_set.hpp"
#include "local_optimization/local_optimization.hpp"
#include "optimization/marginalized_fit.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Maximum number of points of a fit. See doc/constants.md.
constexpr int MAX_FIT = 500;
//! Optimization ends after this many fits in a row that are not better than the best fit so far.
constexpr int FAILURES = 2;

/** @brief The local optimization of MAGSAC++ @cite barath2020magsac: iteratively re-weighted least
squares with the weights of MarginalizedWeights.

There are at most Params::localIterations iterations. Each iteration uses all points whose errors
under the last fit are within the threshold, or #MAX_FIT random points of these if there are more:
a subset is enough while the weights still change. The best fit replaces the model if it is better.
Optimization also ends when #FAILURES fits in a row have not been better than the best fit so far
(at first, the initial model). */
class SigmaConsensusPlusPlus : public LocalOptimizer
{
public:
    bool optimize(const Context& context, State& state, Model& model, Quality& quality) CV_OVERRIDE
    {
        Arena::Scope scope(context.arena);
        reweighted.allocate(scope, context.points.size);
        bool improved = false;
        Model fitted = model;
        int failures = 0;
        for (int i = 0;
             i < context.params.localIterations && failures < FAILURES && !context.stop(); ++i)
        {
            reweighted.weigh(context, context.points.threshold, fitted);
            reweighted.reduce(MAX_FIT, state.rng);
            if (!reweighted.fit(context, fitted))
                break;
            const bool better = keepBetter(context, fitted, model, quality);
            improved |= better;
            failures = better ? 0 : failures + 1;
        }
        return improved;
    }

private:
    MarginalizedFit reweighted;
};

}  // namespace

Ptr<LocalOptimizer> createSigmaConsensusPlusPlus() { return makePtr<SigmaConsensusPlusPlus>(); }

}  // namespace usacv20
}  // namespace cv
