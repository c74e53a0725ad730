// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "control/watch.hpp"
#include "optimization/significant_scale.hpp"
#include "loop/reach.hpp"
#include "significance/agreement.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Suitable threshold of the search, as a multiple of the standard deviation sigma of the noise. It
is about the search threshold of Params::magsacPlusPlus for a mask threshold of 2 sigma. The reach
is the ratio of the search threshold to the mask threshold. The reach grows if the search threshold
is less than two thirds of the suitable threshold. It shrinks if the search threshold is more than
1.4 times the suitable one; too large a reach costs time rather than accuracy. A constant far above
5 fails: a wider threshold contains larger errors, so that the reach grows again and again. See
doc/constants.md. */
constexpr double REACH = 5;

//! The noise is estimated for the first time after 1 / FIRST_LOOK of Params::maxIterations samples,
//! or when the search ends earlier. With 4 or 1 instead of 2, the errors of models change by at
//! most 2 %.
constexpr int FIRST_LOOK = 2;

/** Points of another motion, or of a second plane, can look like wide noise. But real wide noise
has errors everywhere within the threshold. Therefore the reach does not grow if the errors within
the threshold alone indicate small noise, and if the number of inliers found for this small noise is
at least this fraction of the number found for the wide noise. See doc/constants.md. */
constexpr double CORE = 1. / 3;

//! Estimated standard deviation of the noise in the errors of the model, in the coordinates of the
//! points; 0 if chance explains the inliers.
double noiseOf(const Context& context, const Model& model)
{
    const Correspondences& p = context.points;
    const Residual& residual = *context.components.residual;
    const int size = std::min<int>(p.size, SignificantScale::MOST),
              degrees = p.problem->errorDimension(),
              m = context.components.minimalSolver->sampleSize();
    const double chance = p.problem->randomInlierRatio(p),
                 widest = REACH_GROWS * p.threshold / REACH;
    Arena::Scope scope(context.arena);
    float* const errors = scope.take<float>(size);
    residual.squaredErrors(p, model, 0, size, errors);
    typedef SignificantScale Scale;
    const Scale::Found all = Scale::estimate(errors, size, 0, 0, p.threshold, chance, degrees, m);
    if (all.sigma <= widest)
        return all.sigma;
    const Scale::Found core = Scale::estimate(errors, size, 0, 0, p.threshold, chance, degrees, m,
                                              1);
    if (core.sigma > 0 && core.sigma <= widest && core.inliers >= CORE * all.inliers)
        return core.sigma;
    float* const wrong = scope.take<float>((size_t)WRONG_PARTNERS * size);
    const int count = wrongErrors(residual, model, p, size, wrong, context.arena);
    return Scale::estimate(errors, size, wrong, count, p.threshold, chance, degrees, m).sigma;
}

}  // namespace

double suitableReach(const Context& context, const State& state, double current)
{
    if (!(state.bestQuality.cost <= DBL_MAX))
        return current;
    const double sigmas = noiseOf(context, state.best) / context.points.threshold * current;
    return std::min(std::max(sigmas * REACH, context.params.reach), context.params.widestReach);
}

void searchWithReach(const Context& context, const State& state, ProblemData& data, Ransac& ransac)
{
    const auto setReach = [&](double reach) {
        data.setReach(reach);
        ransac.thresholdChanged();
    };
    for (int pause = context.params.maxIterations / FIRST_LOOK;; pause = INT_MAX)
    {
        const bool ended = ransac.run(pause);
        const double reach = suitableReach(context, state, data.reach());
        if (context.watch && context.watch->stopped())
            return;
        if (reach > REACH_GROWS * data.reach())
            setReach(reach);
        else if (ended)
            break;
    }
    for (double reach;
         (reach = suitableReach(context, state, data.reach())) < REACH_SHRINKS * data.reach();)
    {
        setReach(reach);
        if (!(state.bestQuality.cost <= DBL_MAX))  // a check has rejected the model
            ransac.run();
    }
}

}  // namespace usacv20
}  // namespace cv
