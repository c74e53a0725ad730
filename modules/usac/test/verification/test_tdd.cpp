// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "termination/termination.hpp"
#include "verification/verification.hpp"

namespace opencv_test {
namespace {

//! A scene with exact matches, and a context for a verifier.
struct Exact
{
    Exact(ProblemType problem, int inliers, int outliers, const Params& params_ = Params())
        : params(params_), scene(makeScene(problem, optionsOf(inliers, outliers))),
          usac(createUsac(scene, params)),
          context(usac->points(), usac->components(), params, arena),
          truth(toInternal(usac->points(), scene.model))
    {}

    static SceneOptions optionsOf(int inliers, int outliers)
    {
        SceneOptions options;
        options.inliers = inliers;
        options.outliers = outliers;
        options.noise = 0;
        return options;
    }

    const Params params;
    const Scene scene;
    const Ptr<Usac> usac;
    Arena arena;
    const Context context;
    const Model truth;
};

//! Probability that d different points of n are all inliers.
double acceptance(int inliers, int n, int d)
{
    double p = 1;
    for (int i = 0; i < d; ++i)
        p *= std::max(inliers - i, 0) / (double)(n - i);
    return p;
}

struct Rate
{
    double passed, inliers, tested;
};

Rate measure(const Exact& exact, const Verifier& verifier, const Model& model, int trials,
             uint64 seed)
{
    Rate rate = {0, 0, 0};
    for (int i = 0; i < trials; ++i)
    {
        Rng rng(seed, i);
        int inliers = 0, tested = 0;
        const bool passed = verifier.preTest(exact.context, model, rng, inliers, tested);
        EXPECT_EQ(passed ? tested : tested - 1, inliers) << "ends with the first outlier";
        rate.passed += passed / (double)trials;
        rate.inliers += inliers;
        rate.tested += tested;
    }
    return rate;
}

//! The correct model must pass with a probability of about epsilon^d, where epsilon is its inlier
//! ratio. The points are drawn without repetition.
TEST(Usac_Tdd, acceptsGoodModels)
{
    const int TRIALS = 20000;
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        const Exact exact((ProblemType)problem, 30, 20);
        const int inliers = exact.context.rate(exact.truth).inliers;
        for (int d = 1; d <= 5; ++d)
        {
            const double expected = acceptance(inliers, 50, d);
            const Rate rate = measure(exact, *createTddVerifier(d), exact.truth, TRIALS, d);
            EXPECT_NEAR(expected, rate.passed, 4.5 * std::sqrt(expected * (1 - expected) / TRIALS))
                << problem << " " << d;
            EXPECT_NEAR(std::pow(inliers / 50., d), rate.passed, 0.03) << problem << " " << d;
        }
    }
}

//! A wrong model with the inlier ratio delta must pass with probability delta^d. The test, passed
//! or not, must take (1 - delta^d) / (1 - delta) points on average. The ratio of reported inliers
//! to tested points must be delta.
TEST(Usac_Tdd, dropsWrongModels)
{
    const int N = 400, TRIALS = 3000;
    Params params;
    params.threshold = 12;
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        const Exact exact((ProblemType)problem, 10, N - 10, params);
        for (uint64 seed = 0; seed < 5; ++seed)
        {
            int sample[MAX_SAMPLE_SIZE], count;
            Model models[MAX_MODELS];
            for (uint64 stream = 0;; ++stream)
            {
                Rng(seed, stream)
                    .distinct(N, exact.usac->components().minimalSolver->sampleSize(), sample);
                count = exact.usac->components().minimalSolver->solve(exact.usac->points(), sample,
                                                                      models);
                if (count > 0)
                    break;
            }
            const double delta = exact.context.rate(models[0]).inliers / (double)N;
            for (int d = 1; d <= 3; ++d)
            {
                const double expected = acceptance(cvRound(delta * N), N, d);
                const Rate rate = measure(exact, *createTddVerifier(d), models[0], TRIALS, seed);
                EXPECT_NEAR(expected, rate.passed, 4.5 * std::sqrt(expected / TRIALS) + 1e-3)
                    << problem << " " << d;
                const double points = (1 - std::pow(delta, d)) / (1 - delta);
                EXPECT_NEAR(points, rate.tested / TRIALS, 0.05) << problem << " " << d;
                EXPECT_NEAR(delta, rate.inliers / rate.tested,
                            4.5 * std::sqrt(delta / rate.tested) + 1e-3);
            }
        }
    }
}

//! A test of a single point must draw the only outlier among 40 points with probability 1 / 40; a
//! test of all points must always draw it.
TEST(Usac_Tdd, asksAllPoints)
{
    const Exact exact(HOMOGRAPHY, 39, 1);
    const Rate rate = measure(exact, *createTddVerifier(1), exact.truth, 20000, 1);
    EXPECT_NEAR(39 / 40., rate.passed, 4.5 * std::sqrt(0.025 / 20000));
    EXPECT_EQ(0, measure(exact, *createTddVerifier(40), exact.truth, 100, 1).passed)
        << "the outlier is among all points";
    EXPECT_EQ(0, measure(exact, *createTddVerifier(100), exact.truth, 100, 1).passed)
        << "more points than there are";
    const Exact pure(HOMOGRAPHY, 40, 0);
    EXPECT_NEAR(1, measure(pure, *createTddVerifier(100), pure.truth, 100, 1).passed, 1e-9);
}

//! The termination criteria must take the rejected good models into account: with an inlier ratio
//! epsilon and samples of m points, a good sample whose model passes the test has probability
//! epsilon^m epsilon^d instead of epsilon^m.
TEST(Usac_Tdd, terminationAllowsForIt)
{
    for (int problem : TWO_VIEW_PROBLEMS)
        for (int d = 1; d <= 4; ++d)
            for (int exactly = 0; exactly < 2; ++exactly)
            {
                Params params;
                params.verification = VERIFICATION_TDD;
                params.tddPoints = d;
                params.termination = TERMINATION_STANDARD | TERMINATION_P_NAPSAC |
                                     (exactly ? TERMINATION_EXACT : 0);
                const Exact exact((ProblemType)problem, 30, 20, params);
                const int m = exact.usac->components().minimalSolver->sampleSize();
                State state;
                for (int inliers = m + 1; inliers < 47; inliers += 5)
                {
                    state.bestQuality = Quality(50 - inliers, inliers);
                    const double beside = inliers - m, failure = std::log(1 - params.confidence);
                    const double more = m +
                                        beside * (1 + params.relaxation * beside / (beside + 30));
                    double good = std::pow(inliers / 50., m + d),
                           better = std::pow(more / 50, m + d);
                    if (exactly)
                    {
                        good = acceptance(inliers, 50, m) * acceptance(inliers, 50, d);
                        better = 1;
                        for (int i = 0; i < m; ++i)
                            better *= (more - i) / (50 - i);
                        // the probability is 0 if there are fewer inliers than test points
                        for (int i = 0; i < d; ++i)
                            better *= std::max((more - i) / (50 - i), 0.);
                    }
                    const std::vector<Ptr<Termination>>& both = exact.usac->components()
                                                                    .terminations;
                    const double k[2] = {std::ceil(failure / std::log1p(-good)),
                                         std::ceil(failure / std::log1p(-better))};
                    for (int t = 0; t < 2; ++t)
                        EXPECT_NEAR(1,
                                    both[t]->iterations(exact.context, state) /
                                        std::min<double>(k[t], INT_MAX),
                                    1e-6);
                }
            }
}

//! With the T(d,d) test, models must be correct, the report must count rejected models, more test
//! points must cost more samples, and threads must change nothing.
TEST(Usac_Tdd, runs)
{
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        Report previous;
        for (int d = 1; d <= 3; ++d)
        {
            SceneOptions options;
            const Scene scene = makeScene((ProblemType)problem, options);
            Params params;
            params.verification = VERIFICATION_TDD;
            params.tddPoints = d;
            params.termination = TERMINATION_STANDARD;
            Report report;
            const Mat model = estimate(scene, params, noArray(), &report);
            EXPECT_LT(modelError(scene, model), 1) << problem << " " << d;
            EXPECT_EQ((int)STOP_STANDARD, report.stop);
            EXPECT_GT(report.refusedModels, report.models / 4) << problem << " " << d;
            EXPECT_GT(report.iterations, previous.iterations) << problem << " " << d;
            previous = report;
            params.threads = 2;
            EXPECT_EQ(0, cv::norm(model, estimate(scene, params), NORM_INF)) << problem << " " << d;
        }
    }
}

TEST(Usac_Tdd, numberOfPoints)
{
    EXPECT_THROW(createTddVerifier(0), cv::Exception);
    EXPECT_THROW(createTddVerifier(101), cv::Exception);
    EXPECT_FALSE(createTddVerifier(100).empty());
}

}
}  // namespace
