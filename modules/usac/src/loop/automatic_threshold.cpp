// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "loop/automatic_threshold.hpp"
#include "control/watch.hpp"
#include "components/sample_statistics.hpp"
#include "loop/factory.hpp"
#include "polishing/polishing.hpp"
#include "scoring/scores.hpp"

namespace cv {
namespace usacv20 {

namespace {

// The comment of the class AutomaticThreshold describes the steps in which these constants are
// used; "the guess" is guess().

//! Maximum number of points that the guess uses.
constexpr int POINTS = 512;
//! Maximum number of samples of the guess; Params::maxIterations also bounds this number.
constexpr int GUESS_SAMPLES = 1000;
//! The guess ends as soon as, with this probability, at least one of its samples has consisted only
//! of inliers of the best model.
constexpr double CONFIDENCE = 0.9;
//! Number of points from which the noise is estimated: for each new best model of the guess (FEW),
//! and after its last sample (SOME).
constexpr int FEW = 150, SOME = 300;
//! Maximum number of fits when a model of the guess or of findCore() is polished.
constexpr int GUESS_STEPS = 3;
//! If the noise is unknown, the threshold is the widest threshold divided by this number. Given the
//! usual threshold, H of photographs with 12 to 40 right matches fail in 29 % with 3, in 20 % with
//! 1.5, in 16 % with 1; but with 1, a second motion hides an E in 32 of 100 scenes instead of 7.
constexpr double UNKNOWN = 1.5;
//! The threshold of findCore() is the widest threshold divided by this number.
constexpr double NARROW = 3;
//! A core, see findCore(), has at least CORE_PART times as many points as there are inliers of the
//! model whose estimated threshold is too wide. If the fraction CORE_PART of these inliers belongs
//! to a core, then with probability CORE_FOUND at least one sample consists only of points of the
//! core, unless Params::maxIterations allows fewer samples.
constexpr double CORE_PART = 0.5, CORE_FOUND = 0.8;
//! The threshold of the search is wider than the estimated threshold by this many standard
//! deviations of the estimate.
constexpr double DEVIATIONS = 2;
//! The search continues with another threshold if the present and the new threshold differ by more
//! than the factor SAME, but at most ROUNDS times.
constexpr double SAME = 1.4;
constexpr int ROUNDS = 4;

//! Termination criterion of the guess, see #CONFIDENCE.
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

//! The options of the guess. The seed differs from that of the search, so that the samples of the
//! guess are not those of the search.
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
    result.polishingSteps = GUESS_STEPS;
    result.maxIterations = std::min(GUESS_SAMPLES, params.maxIterations);
    return result;
}

}  // namespace

//! Draws uniform samples from a list of points.
class ListedSampler : public Sampler
{
public:
    ListedSampler() : indices(0), count(0) {}

    //! Sets the points. The array must stay valid while samples are drawn.
    void list(const int* indices_, int count_)
    {
        indices = indices_;
        count = count_;
    }

    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize();
        state.rng.distinct(count, m, sample);
        for (int k = 0; k < m; ++k)
            sample[k] = indices[sample[k]];
    }

private:
    const int* indices;
    int count;
};

AutomaticThreshold::AutomaticThreshold(const Problem& problem, const Params& given,
                                       const Correspondences& points)
    : params(paramsOfGuess(given)), coreParams(params),
      parts(createComponents(problem, params, points)), listed(makePtr<ListedSampler>()), widest(0),
      latest(), sampled(false), drawn(0), computed(0), uniform(0)
{
    parts.score = createLogarithmicScore();
    parts.polisher = createBiweightPolisher();
    coreParts = parts;
    coreParts.sampler = listed;
    parts.terminations.push_back(makePtr<NoiseTermination>());
}

void AutomaticThreshold::begin(const Context& context)
{
    for (Components* each : {&parts, &coreParts})
    {
        each->residual = context.components.residual;
        each->minimalSolver = context.components.minimalSolver;
        each->nonMinimalSolver = context.components.nonMinimalSolver;
    }
    widest = context.points.threshold / params.reach;
    latest = InlierNoise();
    drawn = computed = uniform = 0;
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

double AutomaticThreshold::searchThreshold(const InlierNoise& noise) const
{
    // relative standard deviation of the estimated sigma
    const double deviation = 1 / std::sqrt(2. * std::max(noise.beyond, 1));
    return std::min(noise.threshold * (1 + DEVIATIONS * deviation), widest);
}

void AutomaticThreshold::account(const State& state)
{
    drawn += state.iteration;
    computed += state.report.models - state.report.rejectedModels;
}

void AutomaticThreshold::keepSample(const Ransac& ransac)
{
    sampled = ransac.bestSample() != 0;
    if (sampled)
        sample = *ransac.bestSample();
}

bool AutomaticThreshold::guess(const Context& given, ProblemData& data, Model& model)
{
    begin(given);
    Correspondences points = given.points;  // in random order, so the first points represent all
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
    account(state);
    uniform = state.iteration;
    InlierNoise noise = InlierNoise();
    if (state.bestQuality.cost <= DBL_MAX)
        noise = roughNoise(context, state.best, widest, SOME, true);
    if (!(noise.sigma > 0))
    {
        data.scaleThreshold(1 / UNKNOWN);
        return false;
    }
    model = state.best;
    keepSample(ransac);
    if (noise.threshold > widest / NARROW)
    {
        const Model better = polished(context, model);
        const InlierNoise narrower = roughNoise(context, better, widest, SOME, true);
        if (narrower.sigma > 0 && narrower.threshold <= widest / NARROW)
        {
            model = better;
            noise = narrower;
        }
    }
    const bool core = noise.threshold > widest / NARROW && findCore(given, points, noise, model);
    const double limit = core ? widest / NARROW : widest;
    setThreshold(data, core ? limit : searchThreshold(noise));
    points.threshold = given.points.threshold;
    const Model better = polished(context, model);
    noise = roughNoise(context, better, limit, SOME, true);
    if (!(noise.sigma > 0))
        return true;
    setThreshold(data, std::min(searchThreshold(noise), limit));
    model = better;
    return true;
}

bool AutomaticThreshold::findCore(const Context& given, Correspondences& points,
                                  const InlierNoise& noise, Model& model)
{
    const int m = parts.minimalSolver->sampleSize();
    Arena::Scope scope(given.arena);
    int* const inliers = scope.take<int>(points.size);
    float* const errors = scope.take<float>(points.size);
    parts.residual->squaredErrors(points, model, 0, points.size, errors);
    int count = 0;
    for (int i = 0; i < points.size; ++i)
    {
        inliers[count] = i;
        count += errors[i] <= noise.threshold * noise.threshold;  // NaN is not an inlier
    }
    if (count <= m)
        return false;
    listed->list(inliers, count);
    coreParams.maxIterations = std::min(
        params.maxIterations, samplesNeeded(std::pow(CORE_PART, m), std::log(1 - CORE_FOUND)));
    const double narrow = widest / NARROW;
    points.threshold = narrow * params.reach;
    const Context context(points, coreParts, coreParams, given.arena, given.watch);
    State state;
    Ransac ransac(context, state);
    ransac.run();
    account(state);
    if (!(state.bestQuality.cost <= DBL_MAX))
        return false;
    const Model core = polished(context, state.best);
    parts.residual->squaredErrors(points, core, 0, points.size, errors);
    int within = 0;
    for (int i = 0; i < points.size; ++i)
        within += errors[i] <= narrow * narrow;
    if (within < CORE_PART * count || errorsGoOn(context, core, narrow, SAME))
        return false;
    model = core;
    keepSample(ransac);
    return true;
}

void AutomaticThreshold::adapt(const Context& context, ProblemData& data, const State& state,
                               Ransac& ransac)
{
    for (int round = 0; state.bestQuality.cost <= DBL_MAX; ++round)
    {
        const double now = context.points.threshold / params.reach;
        // A local optimizer has fitted the best model to many points already.
        const Model fitted = context.components.localOptimizer ? state.best
                                                               : polished(context, state.best);
        latest = preciseNoise(context, fitted, widest);
        if (searchThreshold(latest) > SAME * now && !errorsGoOn(context, fitted, now, SAME))
        {
            latest = preciseNoise(context, fitted, std::min(SAME * now, widest));
            return;
        }
        const double wanted = latest.sigma > 0 ? searchThreshold(latest) : widest / UNKNOWN,
                     ratio = wanted / now;
        if (std::max(ratio, 1 / ratio) <= SAME || round == ROUNDS ||
            (context.watch && context.watch->stopped()))
            return;
        setThreshold(data, wanted);
        ransac.forgetSamples();
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
