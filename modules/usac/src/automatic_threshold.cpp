// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "automatic_threshold.hpp"
#include "core/sample_counts.hpp"
#include "factory.hpp"
#include "scoring/scores.hpp"

namespace cv {
namespace usacv20 {

namespace {

// Effects of halving and doubling each constant: doc/constants.md.

//! Maximum number of points of the guess.
constexpr int POINTS = 512;
//! Maximum number of samples of the guess; at most Params::maxIterations.
constexpr int SAMPLES = 1000;
//! The guess ends if one of its samples has consisted of inliers of the best model with this
//! probability.
constexpr double CONFIDENCE = 0.9;
//! Number of points that tell the noise of the models of the guess, and of the best one.
constexpr int FEW = 150, SOME = 300;
//! Steps of polishing of the best model of the guess.
constexpr int STEPS = 3;
//! If the noise is unknown, the threshold is the widest divided by this number.
constexpr double UNKNOWN = 3;
//! The search continues with another threshold if one of the two is more than SAME times the
//! other, at most ROUNDS times.
constexpr double SAME = 1.4;
constexpr int ROUNDS = 4;

//! Ends the guess, see #CONFIDENCE.
class NoiseTermination : public Termination
{
public:
    int iterations(const Context& context, const State& state) const CV_OVERRIDE
    {
        if (!(state.bestQuality.cost <= DBL_MAX))
            return INT_MAX;
        const double widest = context.points.threshold / context.params.reach;
        const InlierNoise noise = roughNoise(context, state.best, widest, FEW, false);
        if (!(noise.sigma > 0))
            return INT_MAX;
        const int m = context.components.minimalSolver->sampleSize();
        return samplesNeeded(std::pow(noise.part, m), std::log(1 - CONFIDENCE));
    }
};

//! The options of the guess. It draws other samples than the search.
Params paramsOfGuess(const Params& params)
{
    Params result = params;
    result.seed = (int)((unsigned)params.seed + 1);
    result.sampler = SAMPLER_UNIFORM;
    result.verification = VERIFICATION_NONE;
    result.localOptimization = LOCAL_OPTIMIZATION_NONE;
    result.runnersUp = 0;
    result.termination = 0;
    result.degeneracy = params.degeneracy & ~DEGENERACY_DEGENSAC;
    result.polishing = POLISHING_ROBUST;
    result.polishingSteps = STEPS;
    result.maxIterations = std::min(SAMPLES, params.maxIterations);
    return result;
}

}  // namespace

AutomaticThreshold::AutomaticThreshold(const Problem& problem, const Params& given)
    : params(paramsOfGuess(given)), parts(createComponents(problem, params)), widest(0), latest(),
      drawn(0), computed(0)
{
    parts.score = createLogarithmicScore();
    parts.terminations.push_back(makePtr<NoiseTermination>());
}

void AutomaticThreshold::begin(const Context& context)
{
    parts.residual = context.components.residual;
    parts.minimalSolver = context.components.minimalSolver;
    parts.nonMinimalSolver = context.components.nonMinimalSolver;
    widest = context.points.threshold / params.reach;
    latest = InlierNoise();
    drawn = computed = 0;
}

void AutomaticThreshold::setThreshold(ProblemData& data, double threshold) const
{
    data.scaleThreshold(threshold / widest);
}

Model AutomaticThreshold::polished(const Context& context, const Model& model) const
{
    Model result = model;
    if (parts.nonMinimalSolver)
        parts.polisher->polish(context, result);
    return result;
}

bool AutomaticThreshold::guess(const Context& given, ProblemData& data, Model& model)
{
    begin(given);
    Correspondences points = given.points;  // which are in random order
    points.size = std::min<int>(points.size, POINTS);
    const Context context(points, parts, params, given.arena, given.watch);
    parts.start(context);
    State state;
    Ransac ransac(context, state);
    Model initial;
    if (!params.initialModel.empty() &&
        given.points.problem->fromOutput(params.initialModel, given.points, initial))
        ransac.begin(initial);
    ransac.run();
    drawn = state.iteration;
    computed = state.report.models - state.report.rejectedModels;
    InlierNoise noise = InlierNoise();
    if (state.bestQuality.cost <= DBL_MAX)
        noise = roughNoise(context, state.best, widest, SOME, true);
    if (!(noise.sigma > 0))
    {
        data.scaleThreshold(1 / UNKNOWN);
        return false;
    }
    setThreshold(data, noise.threshold);
    points.threshold = given.points.threshold;
    model = polished(context, state.best);
    noise = roughNoise(context, model, widest, SOME, true);
    if (noise.sigma > 0)
        setThreshold(data, noise.threshold);
    else
        model = state.best;
    return true;
}

void AutomaticThreshold::adapt(const Context& context, ProblemData& data, const State& state,
                               Ransac& ransac)
{
    for (int round = 0; state.bestQuality.cost <= DBL_MAX; ++round)
    {
        latest = preciseNoise(context, polished(context, state.best), widest);
        const double wanted = latest.sigma > 0 ? latest.threshold : widest / UNKNOWN,
                     ratio = wanted * params.reach / context.points.threshold;
        if (std::max(ratio, 1 / ratio) <= SAME || round == ROUNDS ||
            (context.watch && context.watch->stopped()))
            return;
        setThreshold(data, wanted);
        ransac.thresholdChanged();
        ransac.run();
    }
    latest = InlierNoise();
}

void AutomaticThreshold::look(const Context& context, const Model& model)
{
    begin(context);
    latest = preciseNoise(context, model, widest);
}

double AutomaticThreshold::settle(ProblemData& data) const
{
    if (latest.sigma > 0)
        setThreshold(data, latest.threshold);
    else
        data.scaleThreshold(1 / UNKNOWN);
    return latest.sigma > 0 ? latest.sigma / latest.threshold * data.threshold() : 0;
}

}  // namespace usacv20
}  // namespace cv
