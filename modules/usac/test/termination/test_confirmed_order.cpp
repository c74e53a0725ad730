// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/run_context.hpp"
#include "termination/confirmed_order.hpp"
#include "termination/termination.hpp"

namespace opencv_test {
namespace {

//! A random order with this number of inliers.
std::vector<uchar> shuffled(RNG& rng, int size, int inliers)
{
    std::vector<uchar> result(size, 0);
    std::fill(result.begin(), result.begin() + inliers, 1);
    for (int i = size - 1; i > 0; --i)
        std::swap(result[i], result[rng.uniform(0, i + 1)]);
    return result;
}

//! orderEvidence() must agree with its definition: the normalized number of pairs of an inlier and
//! an outlier in which the inlier comes first.
TEST(Usac_ConfirmedOrder, countsPairs)
{
    RNG rng(2);
    for (int trial = 0; trial < 100; ++trial)
    {
        const int size = rng.uniform(10, 60), m = rng.uniform(0, 6);
        const std::vector<uchar> inliers = shuffled(rng, size, rng.uniform(1, size));
        std::vector<uchar> repeated(size, 0);
        for (int i = 0; i < size; ++i)
            repeated[i] = inliers[i] && rng.uniform(0, 4) == 0;
        double first = 0, own = 0, wrong = 0;
        int skipped = 0;
        for (int i = 0; i < size; ++i)
        {
            wrong += !inliers[i];
            if (!inliers[i] || repeated[i] || skipped++ < m)
                continue;
            ++own;
            for (int j = i + 1; j < size; ++j)
                first += !inliers[j];
        }
        const double expected = own * wrong == 0
                                    ? 0
                                    : (first - own * wrong / 2) /
                                          std::sqrt(own * wrong * (own + wrong + 1) / 12);
        EXPECT_NEAR(expected, orderEvidence(inliers.data(), repeated.data(), size, m), 1e-12)
            << trial;
    }
}

//! Number of searches that failed, number of searches that #TERMINATION_ORDER ended, and mean
//! number of samples of a search.
struct Outcome
{
    int failed, byOrder;
    double iterations;
};

Outcome run(ProblemType problem, const SceneOptions& scenes, bool scored, int runs = 40,
            const Params& preset = Params())
{
    Outcome result = {0, 0, 0};
    SceneOptions options = scenes;
    for (options.seed = 1; (int)options.seed <= runs; ++options.seed)
    {
        const Scene scene = makeScene(problem, options);
        Params params = preset;
        params.maxIterations = 100000;
        params.seed = (int)options.seed;
        if (scored)
            params.scores = scene.scores;
        Report report;
        const Mat model = estimate(scene, params, noArray(), &report);
        result.failed += !(modelError(scene, model) < 3 * params.threshold);
        result.byOrder += report.stop == STOP_ORDER;
        result.iterations += (double)report.iterations / runs;
    }
    return result;
}

TEST(Usac_ConfirmedOrder, goodScoresPay)
{
    SceneOptions options;
    options.setSize(500, 0.3);
    const double plain = run(FUNDAMENTAL, options, false, 10).iterations;
    const double information[] = {1, 0.9, 0.8}, part[] = {0.1, 0.15, 0.25};
    for (int k = 0; k < 3; ++k)
    {
        options.scoreInformation = information[k];
        const Outcome found = run(FUNDAMENTAL, options, true, 20);
        EXPECT_EQ(0, found.failed) << information[k];
        EXPECT_GE(found.byOrder, 18) << information[k];
        EXPECT_LE(found.iterations, part[k] * plain) << information[k];
    }
}

//! With few inliers, nearly all samples are drawn from points that the best model does not explain.
//! Good scores must save half of the samples.
TEST(Usac_ConfirmedOrder, goodScoresPayWhereFewAreRight)
{
    SceneOptions options;
    options.setSize(500, 0.2);
    options.scoreInformation = 0.9;
    const Outcome found = run(ESSENTIAL, options, true, 20);
    EXPECT_EQ(0, found.failed);
    EXPECT_LE(found.iterations, 7000);  // 14 000 without scores
}

//! Scores must not mislead more than one of 40 searches, even if the best scores are those of a
//! smaller second motion, of the true matches in a square of image 1, or of the matches near a
//! point of image 1, or if the scores are random or reversed.
TEST(Usac_ConfirmedOrder, badScoresAreSeen)
{
    const ProblemType problems[] = {HOMOGRAPHY, ESSENTIAL};
    for (int k = 0; k < 2; ++k)
        for (int kind = 0; kind < 5; ++kind)
        {
            SceneOptions options;
            options.setSize(300, 0.3);
            options.second = 60;
            options.scoreModel = kind < 3 ? (ScoreModel)(SCORES_OF_SECOND + kind) : SCORES_OF_TRUTH;
            options.scoreInformation = kind == 4 ? 0.05 : 0.5;
            EXPECT_LE(run(problems[k], options, true).failed, 1) << (int)problems[k] << " " << kind;
            if (kind == 0)  // scores of the second motion mislead trustedScores()
            {
                EXPECT_GE(run(problems[k], options, true, 40, Params::trustedScores()).failed, 10)
                    << (int)problems[k];
            }
        }
}

//! Without scores, #TERMINATION_ORDER must change nothing, even if all samples follow the order.
TEST(Usac_ConfirmedOrder, isIdleWithoutScores)
{
    SceneOptions options;
    options.setSize(200, 0.4);
    const Scene scene = makeScene(FUNDAMENTAL, options);
    Params with, without;
    without.termination &= ~TERMINATION_ORDER;
    EXPECT_NE(with.termination, without.termination);
    for (int every = 1; every <= 8; every += 7)
    {
        with.orderedEvery = without.orderedEvery = every;
        Report a, b;
        EXPECT_EQ(0, cvtest::norm(estimate(scene, with, noArray(), &a),
                                  estimate(scene, without, noArray(), &b), NORM_INF));
        EXPECT_EQ(a.iterations, b.iterations);
    }
}

//! If Params::runnersUp is 0, no samples are drawn from the points that the best model does not
//! explain. Without such samples, an order must not end the search.
TEST(Usac_ConfirmedOrder, isIdleWithoutRunnersUp)
{
    SceneOptions options;
    options.setSize(500, 0.4);
    options.scoreInformation = 0.95;
    EXPECT_GE(run(HOMOGRAPHY, options, true, 10).byOrder, 9);
    Params none;
    none.runnersUp = 0;
    EXPECT_EQ(0, run(HOMOGRAPHY, options, true, 10, none).byOrder);
}

//! What the criterion #TERMINATION_ORDER decides if the best model is the true model of a scene,
//! the matches have the given scores, and `orderedSamples` samples have followed the order.
struct Decision
{
    Decision(const Scene& scene, const std::vector<float>& scores, int orderedSamples)
    {
        Params params;
        params.scores = scores;
        const Ptr<Usac> usac = createUsac(scene, params);
        const Correspondences& points = usac->points();
        const RunContext run(points, usac->components(), params);
        const Context& context = run;
        State state;
        state.bestFirst(context);
        state.best = toInternal(points, scene.model);
        state.bestQuality = context.rate(state.best);
        state.iteration = ITERATION;
        state.orderedSamples = orderedSamples;
        state.unexplainedSamples = -1;
        const Ptr<Termination> criterion = createConfirmedOrderTermination();
        criterion->start(context);
        criterion->adapt(context, state);
        ordered = state.wanted == SAMPLES_ORDERED;
        unexplained = state.unexplainedSamples;
        iterations = criterion->iterations(context, state);
    }

    enum { ITERATION = 1234 };

    bool ordered;     //!< the criterion requests only samples that follow the order
    int unexplained;  //!< number of samples drawn from the best model's outliers that the criterion
                      //!< requires before the search ends; -1: not decided yet
    int iterations;   //!< Termination::iterations
};

//! A scene for H in which the first `copied` true matches occur `times` times each. `copies` gets
//! the indices of these matches and of their copies.
Scene withCopies(int size, double inlierRatio, int copied, int times, std::vector<int>& copies)
{
    SceneOptions options;
    options.setSize(size, inlierRatio);
    options.noise = 0.2;
    Scene scene = makeScene(HOMOGRAPHY, options);
    copies.clear();
    for (int i = 0; (int)copies.size() < copied * times; ++i)
        for (int k = 0; scene.truth[i] && k < times; ++k)
        {
            copies.push_back(k ? scene.size() : i);
            if (k == 0)
                continue;
            scene.points1.push_back(scene.points1[i]);
            scene.points2.push_back(scene.points2[i]);
            scene.clean1.push_back(scene.clean1[i]);
            scene.clean2.push_back(scene.clean2[i]);
            scene.truth.push_back(1);
        }
    return scene;
}

//! 120 true matches have the best scores, and all other scores are random. If these matches are
//! 40 copies each of three matches, they must not count as evidence that the order is informative.
//! If they are 120 different matches, they must count.
TEST(Usac_ConfirmedOrder, copiesAreNoEvidence)
{
    for (bool repeated : {false, true})
    {
        std::vector<int> copies;
        const Scene scene = withCopies(1000, 0.25, repeated ? 3 : 120, repeated ? 40 : 1, copies);
        RNG rng(7);
        std::vector<float> scores;
        for (int i = 0; i < scene.size(); ++i)
            scores.push_back(rng.uniform(1.f, 2.f));
        for (int i : copies)
            scores[i] = 0;
        EXPECT_EQ(!repeated, Decision(scene, scores, 1).ordered);
    }
}

//! If the outliers are fewer than the inliers that another model needs, the search must end without
//! a single sample of the outliers.
TEST(Usac_ConfirmedOrder, tooFewOutliersForAnotherModel)
{
    SceneOptions options;
    options.setSize(300, 0.8);
    const Scene scene = makeScene(HOMOGRAPHY, options);
    const Decision found(scene, makeScores(scene.truth, 0.9, 1), 1000);
    EXPECT_TRUE(found.ordered);
    EXPECT_EQ(0, found.unexplained);
    EXPECT_EQ((int)Decision::ITERATION, found.iterations);
}

}
}  // namespace
