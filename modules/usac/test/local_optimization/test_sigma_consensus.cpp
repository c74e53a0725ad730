// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/run_context.hpp"
#include "test_precomp.hpp"
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

INSTANTIATE_TEST_CASE_P(All, Usac_Sigma_Consensus, testing::Values(0, 1, 2));

}  // namespace
}  // namespace opencv_test
