// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/run_context.hpp"
#include "test_precomp.hpp"
#include "support/problem_objects.hpp"

namespace opencv_test {
namespace {

struct Outcome
{
    Outcome() : successes(0), degenerate(0) {}
    int successes, degenerate;
    std::vector<double> errors;
};

//! Estimates F in scenes that differ only in their seeds. A success is a root mean square error
//! below 2 pixels over the true matches off the plane.
Outcome estimateScenes(const SceneOptions& common, int scenes, const Params& params)
{
    Outcome outcome;
    for (int i = 0; i < scenes; ++i)
    {
        SceneOptions options = common;
        options.seed = 100 + i;
        const Scene scene = makeScene(FUNDAMENTAL, options);
        Report report;
        const Mat F = estimate(scene, params, noArray(), &report);
        const double error = modelError(scene, F, OFF_PLANE);
        outcome.errors.push_back(error);
        outcome.successes += error < 2;
        outcome.degenerate += report.degenerate;
    }
    std::sort(outcome.errors.begin(), outcome.errors.end());
    return outcome;
}

Params paramsWith(int degeneracy)
{
    Params params;
    params.degeneracy = degeneracy;
    params.maxIterations = 1000;
    params.threshold = 1.5;
    return params;
}

const int WITHOUT = DEGENERACY_ORIENTATION, WITH = DEGENERACY_ORIENTATION | DEGENERACY_DEGENSAC;

TEST(Usac_Degensac, dominantPlanes)
{
    const double fractions[] = {0.6, 0.7, 0.8, 0.9, 0.95};
    const int SCENES = 40;
    int with = 0, without = 0;
    for (int k = 0; k < 5; ++k)
    {
        SceneOptions options;
        options.planeFraction = fractions[k];
        options.inliers = 300;
        options.outliers = 100;
        const Outcome a = estimateScenes(options, SCENES, paramsWith(WITH));
        const Outcome b = estimateScenes(options, SCENES, paramsWith(WITHOUT));
        EXPECT_GE(a.successes, b.successes - 2) << "fraction on the plane " << fractions[k];
        EXPECT_GE(a.successes, SCENES * 8 / 10) << "fraction on the plane " << fractions[k];
        EXPECT_GT(a.degenerate, SCENES / 2) << "fraction on the plane " << fractions[k];
        EXPECT_EQ(0, b.degenerate);
        with += a.successes;
        without += b.successes;
    }
    EXPECT_GE(with, without + 5 * SCENES / 10) << "of " << 5 * SCENES;
}

TEST(Usac_Degensac, generalScenesAreNotWorse)
{
    const int SCENES = 80;
    for (int k = 0; k < 2; ++k)
    {
        SceneOptions options;
        options.inliers = k ? 300 : 100;
        options.outliers = 100;
        const Outcome a = estimateScenes(options, SCENES, paramsWith(WITH));
        const Outcome b = estimateScenes(options, SCENES, paramsWith(WITHOUT));
        EXPECT_GE(a.successes, b.successes - 2);
        EXPECT_LE(a.errors[SCENES / 2], 1.1 * b.errors[SCENES / 2]);
        EXPECT_LE(a.errors[SCENES * 9 / 10], 1.2 * b.errors[SCENES * 9 / 10]);
    }
}

//! If recover() replaces a model, the new model must have a lower cost.
TEST(Usac_Degensac, neverRaisesTheCost)
{
    int replaced = 0, detected = 0, tried = 0;
    for (uint64 seed = 1; seed <= 8; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.planeFraction = seed % 2 ? 0.8 : 0;
        const Scene scene = makeScene(FUNDAMENTAL, options);
        const Params params;
        const Ptr<Usac> usac = createUsac(scene, params);
        Arena arena;
        const Context context(usac->points(), usac->components(), params, arena);
        usac->components().start(context);
        const Ptr<Degeneracy> degensac = createDegensac();
        std::vector<int> good;  // true matches, from which samples are drawn
        for (int i = 0; i < scene.size(); ++i)
            if (scene.truth[usac->points().inputIndex[i]])
                good.push_back(i);
        for (int i = 0; i < 60; ++i)
        {
            int sample[MAX_SAMPLE_SIZE];
            Model models[MAX_MODELS];
            Rng(seed, i).distinct((int)good.size(), 7, sample);
            for (int k = 0; k < 7; ++k)
                sample[k] = good[sample[k]];
            const int count = usac->components().minimalSolver->solve(usac->points(), sample,
                                                                      models);
            for (int k = 0; k < count; ++k, ++tried)
            {
                State state;
                state.rng = Rng(1, i);
                const Quality before = context.rate(models[k]);
                Model model = models[k];
                Quality quality = before;
                ASSERT_TRUE(degensac->recover(context, state, sample, model, quality));
                const Quality after = context.rate(model);
                EXPECT_EQ(after.cost, quality.cost);
                EXPECT_EQ(after.inliers, quality.inliers);
                EXPECT_LE(after.cost, before.cost);
                const bool changed = model != models[k];
                EXPECT_EQ(changed, after.cost < before.cost);
                replaced += changed;
                detected += state.degenerate;
                if (changed)
                {
                    EXPECT_NEAR(0, determinant(Matx33d(model)), 1e-9);
                }
            }
        }
    }
    EXPECT_GT(replaced, 20);
    EXPECT_GE(detected, replaced);
    EXPECT_LT(detected, tried);
}

//! Samples of exact points, of which a known number is on a plane. A plane must nearly always be
//! detected if at least five of the seven points are on it, and only rarely otherwise.
TEST(Usac_Degensac, detectsFiveOfSeven)
{
    SceneOptions options;
    options.planeFraction = 0.5;
    options.noise = 0;
    options.outliers = 0;
    int found[8] = {0}, tried[8] = {0};
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        options.seed = seed;
        const Scene scene = makeScene(FUNDAMENTAL, options);
        Params params;
        params.threshold = 0.1;
        const Ptr<Usac> usac = createUsac(scene, params);
        Arena arena;
        const Context context(usac->points(), usac->components(), params, arena);
        usac->components().start(context);
        const Ptr<Degeneracy> degensac = createDegensac();
        const Model truth = toInternal(usac->points(), scene.model);
        std::vector<int> on, off;
        for (int i = 0; i < scene.size(); ++i)
            (scene.onPlane[usac->points().inputIndex[i]] ? on : off).push_back(i);
        for (int planar = 2; planar <= 7; ++planar)
            for (int i = 0; i < 20; ++i, ++tried[planar])
            {
                int first[MAX_SAMPLE_SIZE], second[MAX_SAMPLE_SIZE], sample[MAX_SAMPLE_SIZE];
                Rng rng(seed, i), places(seed, 1000 + i);
                rng.distinct((int)on.size(), planar, first);
                rng.distinct((int)off.size(), 7 - planar, second);
                for (int k = 0; k < 7; ++k)
                    sample[k] = k < planar ? on[first[k]] : off[second[k - planar]];
                for (int k = 6; k > 0; --k)
                    std::swap(sample[k], sample[places.uniform(k + 1)]);
                State state;
                Model model = truth;
                Quality quality = context.rate(model);
                degensac->recover(context, state, sample, model, quality);
                found[planar] += state.degenerate;
            }
    }
    for (int planar = 5; planar <= 7; ++planar)
        EXPECT_GE(found[planar], tried[planar] * 95 / 100) << planar << " on the plane";
    for (int planar = 2; planar <= 4; ++planar)
        EXPECT_LE(found[planar], tried[planar] * 10 / 100) << planar << " on the plane";
}

//! A model whose inliers are mostly on a plane must be corrected even if there is no sample, as
//! after a local optimization.
TEST(Usac_Degensac, planeOfInliersIsFoundWithoutASample)
{
    int mended = 0;
    const int SCENES = 20;
    for (int i = 0; i < SCENES; ++i)
    {
        SceneOptions options;
        options.planeFraction = 0.7;
        options.seed = 50 + i;
        const Scene scene = makeScene(FUNDAMENTAL, options);
        Ptr<Usac> usac = createUsac(scene, Params());
        const Params params;
        Arena arena;
        const Context context(usac->points(), usac->components(), params, arena);
        usac->components().start(context);
        // F = [e]x H with the homography H of the plane and a wrong epipole e
        std::vector<cv::Point2d> plane1, plane2;
        for (int k = 0; k < scene.size(); ++k)
            if (scene.onPlane[k])
            {
                plane1.push_back(scene.clean1[k]);
                plane2.push_back(scene.clean2[k]);
            }
        const cv::Matx33d H = cv::findHomography(plane1, plane2, 0);
        const cv::Matx33d e(0, -1, 700, 1, 0, 900, -700, -900, 0);
        Model model = toInternal(usac->points(), e * H);
        Quality quality = context.rate(model);
        const Quality before = quality;
        State state;
        EXPECT_TRUE(createDegensac()->recover(context, state, 0, model, quality));
        EXPECT_TRUE(state.degenerate);
        mended += quality.betterThan(before) && quality.inliers >= before.inliers + 20;
    }
    EXPECT_GE(mended, SCENES * 8 / 10);
}

//! Random matches and a model F that does not allow a plane to be detected. recover() with and
//! without a sample must not change the model.
void expectNoPlane(const Model& F, double threshold)
{
    RNG rng(5);
    std::vector<Point2d> points1, points2;
    for (int i = 0; i < 20; ++i)
    {
        points1.push_back(uniformPoint(rng, -1., 1.));
        points2.push_back(uniformPoint(rng, -1., 1.));
    }
    points2[0] = Point2d(0, 0);
    const OwnPoints own(FUNDAMENTAL, points1, points2, threshold);
    const Params params;
    const Components components;
    Arena arena;
    const Context context(own.view(), components, params, arena);
    const int samples[2][7] = {{0, 1, 2, 3, 4, 5, 6}, {1, 2, 0, 4, 5, 6, 3}};
    for (int k = 0; k < 3; ++k)
    {
        State state;
        Model model = F;
        Quality quality(1, 7);
        EXPECT_TRUE(
            createDegensac()->recover(context, state, k < 2 ? samples[k] : 0, model, quality));
        EXPECT_FALSE(state.degenerate) << k;
        EXPECT_EQ(F, model);
        EXPECT_EQ(1, quality.cost);
    }
}

//! A matrix of rank 1 or 0 has no unique epipole, so that no plane can be found.
TEST(Usac_Degensac, noEpipole)
{
    expectNoPlane(Matx33d(1, 0, 0, 0, 0, 0, 0, 0, 0), 10);
    expectNoPlane(Matx33d::zeros(), 10);
}

//! The first match is at the epipole of image 2 and therefore on the plane of any two other
//! matches. recover() must not detect a plane.
TEST(Usac_Degensac, matchOnTheEpipole)
{
    expectNoPlane(Matx33d(0, -1, 0, 1, 0, 0, 0, 0, 0), 1e-3);
    expectNoPlane(Matx33d(0, -1, 0, 1, 0, 0, 0, 0, 0), 1e-9);
}

}  // namespace
}  // namespace opencv_test
