// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/essential/essential.hpp"
#include "problems/two_view/two_view.hpp"
#include "termination/termination.hpp"

namespace opencv_test {
namespace {

//! Draws uniform samples. Every second sample is marked as not counted by the termination criteria
//! (State::counts).
class HalfCounting : public Sampler
{
public:
    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        state.rng.distinct(context.points.size, context.components.minimalSolver->sampleSize(),
                           sample);
        state.counts = state.iteration % 2 == 0;
    }
};

Report reportOf(const Scene& scene, const Params& params, const Ptr<Sampler>& sampler)
{
    const Ptr<Usac> usac = createUsac(scene, params);
    usac->components().sampler = sampler;
    Report report;
    EXPECT_FALSE(usac->run(noArray(), &report).empty());
    return report;
}

//! Probability C(inliers, m) / C(n, m) that a sample without replacement is all-inlier.
double subsets(double inliers, double n, int m)
{
    double p = 1;
    for (int i = 0; i < m; ++i)
        p *= (inliers - i) / (n - i);
    return p;
}

//! Number of samples log(1 - confidence) / log(1 - C(inliers, m) / C(n, m)) for the default
//! confidence 0.99.
double wantedSamples(double inliers, double n, int m)
{
    return std::log(0.01) / std::log1p(-subsets(inliers, n, m));
}

TEST(Usac_CountedSamples, the_others_do_not_end_the_search)
{
    Params params;
    params.termination = TERMINATION_STANDARD | TERMINATION_EXACT;
    const Scene scene = makeScene(HOMOGRAPHY, 100, 150);
    const Report report = reportOf(scene, params, makePtr<HalfCounting>());
    EXPECT_EQ((int)STOP_STANDARD, report.stop);
    const double needed = wantedSamples(report.inliers, scene.size(), 4);
    EXPECT_NEAR(2 * needed, report.iterations, 0.3 * needed);
}

TEST(Usac_CountedSamples, all_count_where_one_model_has_most_points)
{
    Params params;
    params.termination = TERMINATION_STANDARD | TERMINATION_EXACT;
    const Scene scene = makeScene(FUNDAMENTAL, 230, 130);
    const Report report = reportOf(scene, params, makePtr<HalfCounting>());
    EXPECT_EQ((int)STOP_STANDARD, report.stop);
    const double needed = wantedSamples(report.inliers, scene.size(), 7);
    EXPECT_GT(2 * report.inliers, scene.size() + 14);
    EXPECT_NEAR(needed, report.iterations, 0.3 * needed + 2);
}

TEST(Usac_CountedSamples, same_match_twice_may_be_good)
{
    std::vector<Point2d> points1, points2;
    for (int i = 0; i < 6; ++i)
    {
        points1.push_back(Point2d(0.3 * i, 0.1 * i * i));
        points2.push_back(Point2d(1 + 0.2 * i, 0.3 * i));
    }
    points1[4] = points1[3];  // the same match twice
    points2[4] = points2[3];
    points2[5] = points2[0];  // two matches share a point of image 2
    const OwnPoints points(HOMOGRAPHY, points1, points2);
    Components parts;
    parts.minimalSolver = createUsac(makeScene(HOMOGRAPHY, 20, 5), Params())
                              ->components()
                              .minimalSolver;
    const Params params;
    Arena arena;
    const Context context(points.view(), parts, params, arena);
    const int different[] = {0, 1, 2, 3}, twice[] = {0, 1, 3, 4}, shared[] = {0, 1, 2, 5},
              both[] = {0, 5, 3, 4};
    const Ptr<Degeneracy> repeated = createRepeatedPoints();
    EXPECT_TRUE(repeated->validSample(context, different));
    EXPECT_FALSE(repeated->validSample(context, twice));
    EXPECT_FALSE(repeated->validSample(context, shared));
    EXPECT_TRUE(repeated->mayBeGood(context, twice));
    EXPECT_FALSE(repeated->mayBeGood(context, shared));
    EXPECT_FALSE(repeated->mayBeGood(context, both));
}

//! State::countedSamples and State::repeatedSamples are set as if the 150 matches were 30 different
//! ones, each five times, 18 of them true. From these counters, goodSampleProbability() must find
//! about the probability for 30 matches instead of that for 150.
TEST(Usac_CountedSamples, refused_samples_tell_how_many_matches_are_different)
{
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        const Scene scene = makeScene((ProblemType)problem, 90, 60);
        const Params params;
        const Ptr<Usac> usac = createUsac(scene, params);
        Arena arena;
        const Context context(usac->points(), usac->components(), params, arena);
        usac->components().start(context);
        const int m = usac->components().minimalSolver->sampleSize();
        State state;
        EXPECT_NEAR(subsets(90, 150, m), goodSampleProbability(context, state, 90), 1e-9)
            << problem;
        double passed = 1;
        for (int i = 0; i < m; ++i)
            passed *= (150 - 5. * i) / (150 - i);
        state.countedSamples = cvRound(1e6 * passed);
        state.repeatedSamples = 1000000 - state.countedSamples;
        const double p = goodSampleProbability(context, state, 90), exact = subsets(18, 30, m);
        EXPECT_LE(p, exact * 1.001) << problem;
        EXPECT_GE(p, exact * 0.8) << problem;
    }
}

//! A wrong match occurs 100 times among 400 matches, so that every H that agrees with it has at
//! least 100 inliers. The copies must count as one inlier only.
TEST(Usac_CountedSamples, one_match_many_times_is_one)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        Scene scene = makeScene(HOMOGRAPHY, 200, 100, seed);
        const Scene original = scene;
        scene.points1.insert(scene.points1.end(), 100, scene.points1[0]);
        scene.points2.insert(scene.points2.end(), 100, Point2d(scene.points2[0].x + 200, 20));
        EXPECT_LT(modelError(original, estimate(scene, Params())), 1) << seed;
        EXPECT_LT(modelError(original, estimate(scene, Params::fast())), 1) << seed;
    }
}

TEST(Usac_CountedSamples, planes_take_more_samples_for_E)
{
    int planar = 0, general = 0;
    for (uint64 seed = 1; seed <= 10; ++seed)
        for (int plane = 0; plane < 2; ++plane)
        {
            SceneOptions options;
            options.seed = seed;
            options.planeFraction = plane ? 0.95 : 0;
            const Scene scene = makeScene(ESSENTIAL, options);
            const Params params;
            const Ptr<Usac> usac = createUsac(scene, params);
            Arena arena;
            const Context context(usac->points(), usac->components(), params, arena);
            usac->components().start(context);
            State state;
            const double success = createPlanarMotion()->successProbability(context, state,
                                                                            scene.model);
            (plane ? planar : general) += success < 1;
        }
    EXPECT_EQ(10, planar);
    EXPECT_EQ(0, general);
}

//! Number of samples of the search with an estimated threshold, divided by the number that the
//! standard criterion asks for; mean over 20 scenes.
double drawnWithEstimatedThreshold(ProblemType problem, int inliers, int outliers)
{
    Params params = Params::automatic();
    params.termination = TERMINATION_STANDARD | TERMINATION_EXACT;
    params.sampler = SAMPLER_UNIFORM;
    params.runnersUp = 0;
    const int scenes = 20, m = problem == FUNDAMENTAL ? 7 : 4;
    double sum = 0;
    for (int seed = 1; seed <= scenes; ++seed)
    {
        SceneOptions options;
        options.setSize(inliers + outliers, (double)inliers / (inliers + outliers));
        options.seed = params.seed = seed;
        const Scene scene = makeScene(problem, options);
        Report report;
        EXPECT_FALSE(createUsac(scene, params)->run(noArray(), &report).empty());
        sum += report.iterations / wantedSamples(report.inliers, scene.size(), m);
    }
    return sum / scenes;
}

//! The samples that are drawn to estimate the threshold count if most points are inliers of the
//! best model. Otherwise they do not count, because a wrong model can look better than the right
//! one at the widest threshold.
TEST(Usac_CountedSamples, samples_before_the_search)
{
    EXPECT_LE(drawnWithEstimatedThreshold(FUNDAMENTAL, 180, 120), 0.8);
    EXPECT_GE(drawnWithEstimatedThreshold(HOMOGRAPHY, 90, 160), 0.95);
}

}  // namespace
}  // namespace opencv_test
