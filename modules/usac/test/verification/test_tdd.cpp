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

}
}  // namespace
