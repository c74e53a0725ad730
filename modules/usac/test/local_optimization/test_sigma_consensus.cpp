// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/run_context.hpp"
#include "test_precomp.hpp"
#include <set>
#include "local_optimization/local_optimization.hpp"
#include "optimization/marginalized_fit.hpp"
#include "local_optimization/sigma_consensus.hpp"
#include "polishing/polishing.hpp"
#include "numeric/chi_square.hpp"

namespace opencv_test {
namespace {

//! A scene and a run whose components have been started. The tests apply optimizers to this run.
struct Bench
{
    explicit Bench(ProblemType problem, double inlierThreshold = 3,
                   const SceneOptions& options = SceneOptions())
        : scene(makeScene(problem, options))
    {
        params.threshold = inlierThreshold;
        params.quality = QUALITY_MAGSAC_PLUS_PLUS;
        usac = createUsac(scene, params);
        run = makePtr<RunContext>(usac->points(), usac->components(), params);
        truth = toInternal(usac->points(), scene.model);
        for (int i = 0; i < usac->points().size; ++i)
            if (scene.truth[usac->points().inputIndex[i]])
                inliers.push_back(i);
    }

    const Context& context() const { return *run; }

    //! The best model of a random minimal sample of true matches. Returns false if this model has
    //! no inliers.
    bool minimalModel(int trial, Model& model, Quality& quality) const
    {
        const MinimalSolver& solver = *usac->components().minimalSolver;
        int picks[MAX_SAMPLE_SIZE], sample[MAX_SAMPLE_SIZE];
        Model models[MAX_MODELS];
        Rng(77, trial).distinct((int)inliers.size(), solver.sampleSize(), picks);
        for (int i = 0; i < solver.sampleSize(); ++i)
            sample[i] = inliers[picks[i]];
        const int count = solver.solve(usac->points(), sample, models);
        quality = Quality();
        for (int k = 0; k < count; ++k)
        {
            const Quality each = context().rate(models[k]);
            if (each.betterThan(quality))
            {
                quality = each;
                model = models[k];
            }
        }
        return quality.inliers > 0;
    }

    double pixels(const Model& model) const
    {
        const Correspondences& p = usac->points();
        const Matx33d inInput = toInput(p, model);
        return modelError(scene, Mat(inInput * (1 / cv::norm(inInput))));
    }

    Scene scene;
    Params params;
    Ptr<Usac> usac;
    Ptr<RunContext> run;
    Model truth;
    std::vector<int> inliers;
};

//! Integral over the noise scale sigma, from `from` to `to`, of the density of an error r, up to a
//! constant factor. The density is 0 where r exceeds thresholdInSigmas(degrees) times sigma.
double marginalDensity(int degrees, double r, double from, double to)
{
    const int STEPS = 400;
    const double k = thresholdInSigmas(degrees);
    const double begin = std::max(from, r / k);
    double sum = 0;
    for (int i = 0; i < STEPS && begin < to; ++i)
    {
        const double sigma = begin + (to - begin) * (i + 0.5) / STEPS;
        sum += std::pow(sigma, -degrees) * std::pow(r, degrees - 1) *
               std::exp(-0.5 * r * r / (sigma * sigma));
    }
    return sum * std::max(to - begin, 0.) / STEPS;
}

/** The weights of sigma-consensus, computed from their definition. For each part of the range of
the noise scale sigma, a model is fitted to the points whose errors under `start` are below `part` /
`parts` times the threshold, and the density of the errors under the fitted model is integrated
numerically. As in MarginalizedWeights, errors below 1/45 of the threshold are raised to this
value. */
std::vector<double> bruteForceWeights(const Bench& bench, const Model& start, int parts)
{
    const Correspondences& p = bench.usac->points();
    const Components& components = bench.usac->components();
    const int degrees = p.problem->errorDimension(), m = components.minimalSolver->sampleSize();
    const double sigmaMax = p.threshold / thresholdInSigmas(degrees);
    std::vector<double> initial(p.size), errors(p.size), weights(p.size, 0.);
    components.residual->squaredErrors(start, p.exact, p.size, initial.data());
    for (int part = 1; part <= parts; ++part)
    {
        std::vector<int> near;
        for (int i = 0; i < p.size; ++i)
            if (std::sqrt(initial[i]) < part * p.threshold / parts)
                near.push_back(i);
        Model fitted = start;
        if ((int)near.size() > m)
            components.nonMinimalSolver->fit(p, near.data(), (int)near.size(), 0, fitted);
        components.residual->squaredErrors(fitted, p.exact, p.size, errors.data());
        for (int i = 0; i < p.size; ++i)
            if (std::sqrt(initial[i]) < p.threshold)
                weights[i] += marginalDensity(
                    degrees, std::max(std::sqrt(errors[i]), p.threshold / std::sqrt(2048.)),
                    sigmaMax * (part - 1) / parts, sigmaMax * part / parts);
    }
    return weights;
}

typedef testing::TestWithParam<int> Usac_Sigma_Consensus;

TEST_P(Usac_Sigma_Consensus, weightsAgainstBruteForce)
{
    const Bench bench((ProblemType)GetParam());
    Model model;
    Quality quality;
    for (int trial = 0; quality.inliers < 80; ++trial)
        bench.minimalModel(trial, model, quality);
    SigmaConsensus consensus;
    Rng rng;
    // a first fit brings the model so near to the truth that even the part of smallest sigma has
    // enough inliers for a fit
    ASSERT_TRUE(consensus.fit(bench.context(), rng, model));
    const std::vector<double> expected = bruteForceWeights(bench, model,
                                                           SigmaConsensus::PARTITIONS);
    Model fitted = model;
    ASSERT_TRUE(consensus.fit(bench.context(), rng, fitted));
    // both sets of weights are defined up to a constant factor
    std::vector<double> ratios;
    const double most = *std::max_element(expected.begin(), expected.end());
    std::vector<uchar> seen(expected.size(), 0);
    for (int i = 0; i < consensus.size(); ++i)
    {
        const int point = consensus.points()[i];
        seen[point] = 1;
        if (expected[point] > 0.05 * most)
            ratios.push_back(consensus.pointWeights()[i] / expected[point]);
    }
    for (size_t i = 0; i < expected.size(); ++i)
        EXPECT_TRUE(seen[i] || expected[i] < 1e-3 * most);
    ASSERT_GT(ratios.size(), 40u);
    std::sort(ratios.begin(), ratios.end());
    EXPECT_NEAR(1, ratios.back() / ratios.front(), 0.01);
}

//! Five parts of the range of sigma must approximate the limit of many parts: the models fitted
//! with five and with 100 parts must differ by less than the models with five parts differ from the
//! true model.
TEST_P(Usac_Sigma_Consensus, fewPartsAgainstMany)
{
    const Bench bench((ProblemType)GetParam());
    double apart = 0, fromTruth = 0, start = 0;
    int count = 0;
    for (int trial = 0; trial < 12; ++trial)
    {
        Model few, many;
        Quality quality;
        if (!bench.minimalModel(trial, few, quality) || quality.inliers < 60)
            continue;
        ++count;
        start += modelDistance(bench.truth, normalized(few));
        many = few;
        SigmaConsensus five, hundred(100);
        Rng rng;
        ASSERT_TRUE(five.fit(bench.context(), rng, few));
        ASSERT_TRUE(hundred.fit(bench.context(), rng, many));
        few = normalized(few);
        many = normalized(many);
        apart += modelDistance(few, many);
        fromTruth += modelDistance(bench.truth, few);
    }
    ASSERT_GT(count, 4);
    EXPECT_LT(apart, fromTruth);
    EXPECT_LT(fromTruth, 0.75 * start);
}

//! Neither the optimizer of MAGSAC nor that of MAGSAC++ is allowed to return a model worse than the
//! given one. Both must return the correct quality of the model and improve most models of minimal
//! samples.
TEST_P(Usac_Sigma_Consensus, improvesMinimalModels)
{
    const Bench bench((ProblemType)GetParam(), 5);
    const Context& context = bench.context();
    const Ptr<LocalOptimizer> optimizers[] = {createSigmaConsensus(),
                                              createSigmaConsensusPlusPlus()};
    for (int o = 0; o < 2; ++o)
    {
        int better = 0, right = 0, rightBefore = 0, count = 0;
        for (int trial = 0; trial < 40; ++trial)
        {
            Model model;
            Quality quality;
            if (!bench.minimalModel(trial, model, quality))
                continue;
            ++count;
            const Model before = model;
            const Quality qualityBefore = quality;
            State state;
            state.rng = Rng(5, trial);
            const bool improved = optimizers[o]->optimize(context, state, model, quality);
            EXPECT_EQ(improved, quality.betterThan(qualityBefore));
            EXPECT_EQ(context.rate(model).cost, quality.cost);
            EXPECT_EQ(improved, before != model);
            better += improved;
            rightBefore += bench.pixels(before) < 0.4;
            right += bench.pixels(model) < 0.4;
        }
        EXPECT_GT(better, 0.9 * count) << o;
        EXPECT_GT(right, 0.6 * count) << o;
        EXPECT_LT(rightBefore, 0.35 * count) << o;
    }
}

//! More iterations (Params::localIterations) must give lower costs.
TEST_P(Usac_Sigma_Consensus, iterationsHaveAnEffect)
{
    Bench bench((ProblemType)GetParam(), 5);
    const Ptr<LocalOptimizer> optimizers[] = {createSigmaConsensus(),
                                              createSigmaConsensusPlusPlus()};
    for (int o = 0; o < 2; ++o)
    {
        double cost[2] = {0, 0};
        for (int k = 0; k < 2; ++k)
            for (int trial = 0; trial < 20; ++trial)
            {
                Model model;
                Quality quality;
                State state;
                bench.params.localIterations = k == 0 ? 1 : 8;
                if (!bench.minimalModel(trial, model, quality))
                    continue;
                optimizers[o]->optimize(bench.context(), state, model, quality);
                cost[k] += quality.cost;
            }
        EXPECT_LT(cost[1], cost[0] - 1) << o;
    }
}

//! If no point is near a model, optimizers and polisher must not change the model.
TEST_P(Usac_Sigma_Consensus, nothingNear)
{
    const Bench bench((ProblemType)GetParam(), 1e-9);
    Model model = bench.truth;
    const Context& context = bench.context();
    Quality quality = context.rate(model);
    const Quality before = quality;
    State state;
    EXPECT_FALSE(createSigmaConsensus()->optimize(context, state, model, quality));
    EXPECT_FALSE(createSigmaConsensusPlusPlus()->optimize(context, state, model, quality));
    createReweightedPolisher()->polish(context, model);
    EXPECT_EQ(bench.truth, model);
    EXPECT_EQ(before.cost, quality.cost);
}

//! The loss from which the weights are derived must not rise in any step of re-weighted least
//! squares.
TEST_P(Usac_Sigma_Consensus, reweightingDescends)
{
    const Bench bench((ProblemType)GetParam(), 5);
    const double inlierThreshold = bench.usac->points().threshold;
    for (int trial = 0; trial < 10; ++trial)
    {
        Model model;
        Quality quality;
        if (!bench.minimalModel(trial, model, quality) || quality.inliers < 30)
            continue;
        Arena::Scope scope(bench.context().arena);
        MarginalizedFit fit;
        fit.allocate(scope, bench.usac->points().size);
        double loss = fit.weigh(bench.context(), inlierThreshold, model);
        EXPECT_NEAR(quality.cost, loss, 1e-6 * loss);
        for (int i = 0; i < 6; ++i)
        {
            ASSERT_TRUE(fit.fit(bench.context(), model));
            const double next = fit.weigh(bench.context(), inlierThreshold, model);
            EXPECT_LE(next, loss * (1 + 1e-4)) << trial << " " << i;
            loss = next;
        }
    }
}

//! MarginalizedFit::reduce() must keep the requested number of points. SigmaConsensus must use at
//! most MAX_FIT points, each at most once.
TEST_P(Usac_Sigma_Consensus, boundedFits)
{
    SceneOptions options;
    options.inliers = 2000;
    const Bench bench((ProblemType)GetParam(), 3, options);
    Arena::Scope scope(bench.context().arena);
    MarginalizedFit fit;
    fit.allocate(scope, bench.usac->points().size);
    fit.weigh(bench.context(), bench.usac->points().threshold, bench.truth);
    const int all = fit.size();
    ASSERT_GT(all, 1500);
    Rng rng(3);
    fit.reduce(all + 1, rng);
    EXPECT_EQ(all, fit.size());
    fit.reduce(300, rng);
    EXPECT_EQ(300, fit.size());
    Model model = bench.truth;
    EXPECT_TRUE(fit.fit(bench.context(), model));
    EXPECT_LT(bench.pixels(model), 0.3);
    SigmaConsensus consensus;
    model = bench.truth;
    ASSERT_TRUE(consensus.fit(bench.context(), rng, model));
    EXPECT_LE((int)consensus.size(), (int)SigmaConsensus::MAX_FIT);
    const std::set<int> distinct(consensus.points(), consensus.points() + consensus.size());
    EXPECT_EQ((size_t)consensus.size(), distinct.size());
    EXPECT_LT(bench.pixels(model), 0.3);
}

//! Polishing must lower the cost, and further polishing must hardly change the model.
TEST_P(Usac_Sigma_Consensus, polisherConverges)
{
    const Bench bench((ProblemType)GetParam(), 3);
    const Context& context = bench.context();
    const Ptr<Polisher> polisher = createReweightedPolisher();
    Model once = bench.truth;
    polisher->polish(context, once);
    EXPECT_LT(context.rate(once).cost, context.rate(bench.truth).cost);
    Model twice = once;
    for (int i = 0; i < 5; ++i)
        polisher->polish(context, twice);
    once = normalized(once);
    twice = normalized(twice);
    const double moved = modelDistance(bench.truth, once);
    EXPECT_GT(moved, 1e-6);
    EXPECT_LT(modelDistance(once, twice), 0.1 * moved);
}

//! Each combination of a sigma-consensus and a score must give a correct model, and re-weighted
//! polishing must improve it.
TEST_P(Usac_Sigma_Consensus, estimates)
{
    const LocalOptimizationType types[] = {LOCAL_OPTIMIZATION_SIGMA_CONSENSUS,
                                           LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS};
    const QualityType qualities[] = {QUALITY_MAGSAC, QUALITY_MAGSAC_PLUS_PLUS, QUALITY_MSAC};
    for (int k = 0; k < 6; ++k)
    {
        const Scene scene = makeScene((ProblemType)GetParam());
        Params params;
        params.threshold = 4;
        params.localOptimization = types[k % 2];
        params.quality = qualities[k / 2];
        params.polishing = POLISHING_NONE;
        Report report;
        const Mat model = estimate(scene, params, noArray(), &report);
        EXPECT_LT(modelError(scene, model), 0.7) << k;
        EXPECT_GT(report.localImprovements, 0) << k;
        params.polishing = POLISHING_REWEIGHTED;
        const Mat polished = estimate(scene, params);
        EXPECT_LT(modelError(scene, polished), 0.3) << k;
        EXPECT_GT(cv::norm(model, polished), 0) << k;
    }
}

INSTANTIATE_TEST_CASE_P(All, Usac_Sigma_Consensus, testing::Values(0, 1, 2));

}  // namespace
}  // namespace opencv_test
