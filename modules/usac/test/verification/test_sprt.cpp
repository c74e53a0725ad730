// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/problem_objects.hpp"
#include "verification/verification.hpp"

namespace opencv_test {
namespace {

const int COUNT = 2000;

//! An SPRT verifier trained with inlier ratios of good (`epsilon`) and of bad (`delta`) models.
class Trained
{
public:
    Trained(ProblemType problem, double epsilon, double delta)
        : scene(makeScene(problem, optionsOf())), usac(createUsac(scene, params)),
          context(usac->points(), usac->components(), params, arena),
          verifier(createSprtVerifier(problemObject(problem).sampleCost()))
    {
        verifier->adapt(context, state);
        learn(delta, 100000);
        best(epsilon);
        verifier->adapt(context, state);
    }

    //! Adds bad models with the inlier ratio `delta` over `points` tested points.
    void learn(double delta, int points)
    {
        verifier->sampleTested(state, cvRound(delta * points), points);
    }

    void best(double epsilon)
    {
        state.sampleQuality = Quality((1 - epsilon) * COUNT, cvRound(epsilon * COUNT));
        state.bestQuality = state.sampleQuality;
    }

    const SequentialTest& test() const { return state.tests.back(); }

    static SceneOptions optionsOf()
    {
        SceneOptions options;
        options.inliers = options.outliers = COUNT / 2;
        return options;
    }

    const Params params;
    const Scene scene;
    const Ptr<Usac> usac;
    Arena arena;
    const Context context;
    const Ptr<Verifier> verifier;
    State state;
};

struct Trial
{
    bool kept;
    int tested;
};

//! Tests a model with this inlier ratio block by block, as Ransac does.
Trial testModel(const Verifier& verifier, double inlierRatio, int points, RNG& rng)
{
    int tested = 0, inliers = 0;
    while (tested < points)
    {
        const int block = std::min(verifier.nextBlock(tested), points - tested);
        EXPECT_GT(block, 0);
        for (int i = 0; i < block; ++i)
            inliers += rng.uniform(0., 1.) < inlierRatio;
        tested += block;
        if (!verifier.proceed(inliers, tested))
            return {false, tested};
    }
    return {true, tested};
}

struct Rates
{
    double dropped, meanTested;
};

Rates simulate(const Verifier& verifier, double inlierRatio, int points, int trials, uint64 seed)
{
    RNG rng(seed);
    double dropped = 0, tested = 0;
    for (int i = 0; i < trials; ++i)
    {
        const Trial trial = testModel(verifier, inlierRatio, points, rng);
        dropped += !trial.kept;
        tested += trial.tested;
    }
    return {dropped / trials, tested / trials};
}

typedef testing::TestWithParam<int> Usac_Sprt;

const double RATIOS[][2] = {{0.2, 0.02}, {0.3, 0.05}, {0.5, 0.05},
                            {0.5, 0.3},  {0.8, 0.1},  {0.9, 0.5}};

TEST_P(Usac_Sprt, learnsBothRatios)
{
    for (size_t k = 0; k < sizeof(RATIOS) / sizeof(RATIOS[0]); ++k)
    {
        const Trained sprt((ProblemType)GetParam(), RATIOS[k][0], RATIOS[k][1]);
        ASSERT_EQ(1, sprt.state.tests.size());
        EXPECT_NEAR(RATIOS[k][0], sprt.test().epsilon, 1e-3);
        EXPECT_NEAR(RATIOS[k][1], sprt.test().delta, 0.002 + 0.01 * RATIOS[k][1]);
        EXPECT_GT(sprt.test().A, 2);
        EXPECT_EQ(0, sprt.test().samples);
    }
}

//! According to Wald, a good model must be rejected with a probability of at most 1 / A.
TEST_P(Usac_Sprt, goodModelsAreKept)
{
    const int TRIALS = 8000;
    for (size_t k = 0; k < sizeof(RATIOS) / sizeof(RATIOS[0]); ++k)
    {
        const Trained sprt((ProblemType)GetParam(), RATIOS[k][0], RATIOS[k][1]);
        const double bound = 1 / sprt.test().A, epsilon = sprt.test().epsilon;
        const Rates rates = simulate(*sprt.verifier, epsilon, COUNT, TRIALS, k);
        EXPECT_LE(rates.dropped, bound + 4 * std::sqrt(bound / TRIALS))
            << "epsilon " << epsilon << " A " << 1 / bound;
        const double more = epsilon + 0.3 * (1 - epsilon);
        EXPECT_LE(simulate(*sprt.verifier, more, COUNT, TRIALS, k).dropped, rates.dropped);
    }
}

//! According to Wald, a bad model must be rejected after log A / C points on average. The decision
//! waits for the end of a block.
TEST_P(Usac_Sprt, badModelsAreDropped)
{
    const int TRIALS = 2000, ENDLESS = 100000;
    for (size_t k = 0; k < sizeof(RATIOS) / sizeof(RATIOS[0]); ++k)
    {
        const Trained sprt((ProblemType)GetParam(), RATIOS[k][0], RATIOS[k][1]);
        const double epsilon = sprt.test().epsilon, delta = sprt.test().delta;
        const double C = delta * std::log(delta / epsilon) +
                         (1 - delta) * std::log((1 - delta) / (1 - epsilon));
        const double expected = std::log(sprt.test().A) / C;
        const Rates rates = simulate(*sprt.verifier, delta, ENDLESS, TRIALS, 100 + k);
        EXPECT_EQ(1, rates.dropped);
        const double block = expected < 48 ? 32 : 64;
        EXPECT_GE(rates.meanTested, 0.95 * expected) << "epsilon " << epsilon << " delta " << delta;
        EXPECT_LE(rates.meanTested,
                  1.1 * expected + block + 2 / C * std::log((1 - delta) / (1 - epsilon)));
    }
}

//! The decision threshold A must be the optimal one: a smaller one rejects too many good models, a
//! larger one tests too many points.
TEST_P(Usac_Sprt, thresholdSolvesWaldsEquation)
{
    // A - log A - 1 = C t_M / m_S. The cost t_M of the models of a sample, in tests of a point, and
    // the mean number m_S of these models do not depend on the ratios, so that (A - log A - 1) / C
    // must be the same for all ratios.
    double constant = 0;
    for (size_t k = 0; k < sizeof(RATIOS) / sizeof(RATIOS[0]); ++k)
    {
        const Trained sprt((ProblemType)GetParam(), RATIOS[k][0], RATIOS[k][1]);
        const double epsilon = sprt.test().epsilon, delta = sprt.test().delta, A = sprt.test().A;
        const double C = delta * std::log(delta / epsilon) +
                         (1 - delta) * std::log((1 - delta) / (1 - epsilon));
        const double found = (A - std::log(A) - 1) / C;
        if (k == 0)
            constant = found;
        EXPECT_GT(found, 1);
        EXPECT_NEAR(constant, found, 1e-3 * constant);
    }
}

INSTANTIATE_TEST_CASE_P(All, Usac_Sprt, testing::ValuesIn(TWO_VIEW_PROBLEMS));

TEST(Usac_SprtAdaptation, dropsNothingBeforeTheFirstModel)
{
    const Ptr<Verifier> verifier = createSprtVerifier(problemObject(HOMOGRAPHY).sampleCost());
    for (int tested = 16; tested < 5000; tested += verifier->nextBlock(tested))
        EXPECT_TRUE(verifier->proceed(0, tested));
}

TEST(Usac_SprtAdaptation, followsTheBestModelAndTheBadOnes)
{
    Trained sprt(HOMOGRAPHY, 0.2, 0.05);
    const SequentialTest first = sprt.test();
    sprt.verifier->adapt(sprt.context, sprt.state);
    EXPECT_EQ(1, sprt.state.tests.size()) << "nothing new was learned";
    sprt.verifier->sampleTested(sprt.state, 1, 16);
    sprt.verifier->sampleTested(sprt.state, 0, 16);
    EXPECT_EQ(2, sprt.test().samples);
    sprt.best(0.6);
    sprt.verifier->adapt(sprt.context, sprt.state);
    ASSERT_EQ(2, sprt.state.tests.size());
    EXPECT_EQ(2, sprt.state.tests[0].samples);
    EXPECT_EQ(0, sprt.test().samples);
    EXPECT_NEAR(0.6, sprt.test().epsilon, 1e-3);
    EXPECT_NEAR(first.delta, sprt.test().delta, 1e-4);
    sprt.learn(0.5, 200000);
    sprt.verifier->adapt(sprt.context, sprt.state);
    ASSERT_EQ(3, sprt.state.tests.size());
    EXPECT_NEAR(0.35, sprt.test().delta, 0.01);
    EXPECT_NEAR(0.6, sprt.test().epsilon, 1e-3);
}

//! The sequential test must remain valid even if bad models have more inliers than the best model,
//! or if all points are inliers.
TEST(Usac_SprtAdaptation, staysATest)
{
    const double ratios[][2] = {{0.1, 0.5}, {0.01, 0.01}, {1, 0.9}, {1, 1}, {1. / COUNT, 0}};
    for (int k = 0; k < 5; ++k)
    {
        const Trained sprt(FUNDAMENTAL, ratios[k][0], ratios[k][1]);
        const SequentialTest& test = sprt.test();
        EXPECT_TRUE(test.epsilon > 0 && test.epsilon < 1) << k;
        EXPECT_TRUE(test.delta > 0 && test.delta < test.epsilon) << k;
        EXPECT_TRUE(test.A > 1 && test.A <= DBL_MAX) << k;
        EXPECT_TRUE(sprt.verifier->proceed(COUNT, COUNT));
    }
}

}
}  // namespace
