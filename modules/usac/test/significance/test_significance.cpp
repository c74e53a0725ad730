// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"
#include "support/scenes.hpp"

namespace opencv_test {
namespace {

//! Random matches, of which only one is true.
Scene randomScene(ProblemType problem, int size, uint64 seed)
{
    SceneOptions options;
    options.inliers = 1;
    options.outliers = size - 1;
    options.seed = seed;
    return makeScene(problem, options);
}

Scene rightScene(ProblemType problem, int size, double inlierRatio, uint64 seed)
{
    SceneOptions options;
    options.setSize(size, inlierRatio);
    options.seed = seed;
    return makeScene(problem, options);
}

Report significantReport(const Scene& scene, Params params)
{
    params.significance = 1;
    return reportOf(scene, params);
}

//! For random matches and each level a, Report::chance must be at most a with a probability of at
//! most a. With F and E, Report::chance must not always be near 1.
TEST(Usac_Significance, calibratedOnRandomMatches)
{
    const int sizes[] = {15, 60, 300}, iterations[] = {100, 500}, RUNS = 40;
    const Params presets[] = {Params::usacV20(), Params::magsacPlusPlus(), Params::loRansac()};
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        int calls = 0, below[3] = {0}, half = 0;
        const double levels[] = {0.1, 0.01, 0.001};
        for (int s = 0; s < 3; ++s)
            for (int i = 0; i < 2; ++i)
                for (int p = 0; p < 3; ++p)
                    for (int run = 0; run < RUNS; ++run, ++calls)
                    {
                        Params params = presets[p];
                        params.maxIterations = iterations[i];
                        const double chance = significantReport(randomScene((ProblemType)problem,
                                                                            sizes[s], run + 1),
                                                                params)
                                                  .chance;
                        half += chance <= 0.5;
                        for (int level = 0; level < 3; ++level)
                            below[level] += chance <= levels[level];
                    }
        for (int level = 0; level < 3; ++level)
        {
            const double expected = calls * levels[level];
            EXPECT_LE(below[level], expected + 3 * std::sqrt(expected))
                << "problem " << (int)problem << " level " << levels[level];
        }
        // not for maps: they have hardly more inliers than their sample, so chance is always near 1
        if (!mapsPoints((ProblemType)problem))
        {
            EXPECT_GE(half, calls / 25) << "problem " << (int)problem;
        }
    }
}

//! The same for random pairs of 3-D points. As for maps, random models have few inliers, so that
//! Report::chance is allowed to be always near 1.
TEST(Usac_Significance, calibratedOnRandomPairsInSpace)
{
    const int sizes[] = {15, 60, 300};
    const Params presets[] = {Params::usacV20(), Params::magsacPlusPlus(), Params::loRansac()};
    for (int type = RIGID_3D; type <= SIMILARITY_3D; ++type)
    {
        int calls = 0, below[3] = {0}, half = 0;
        const double levels[] = {0.1, 0.01, 0.001};
        for (double threshold : {0.05, 0.3})  // radius of a ball whose volume is 0.007 % or 1.4 %
                                              // of that of the cube of side 2
            for (int size : sizes)
                for (int p = 0; p < 3; ++p)
                    for (int run = 0; run < 40; ++run, ++calls)
                    {
                        RNG rng(1000 * size + run);
                        Mat points1(size, 3, CV_64F), points2(size, 3, CV_64F);
                        rng.fill(points1, RNG::UNIFORM, -1, 1);
                        rng.fill(points2, RNG::UNIFORM, -1, 1);
                        Params params = presets[p];
                        params.maxIterations = 300;
                        params.significance = 1;
                        params.threshold = threshold;
                        Report report;
                        Usac::create((ProblemType)type, points1, points2, params)
                            ->run(noArray(), &report);
                        half += report.chance <= 0.5;
                        for (int level = 0; level < 3; ++level)
                            below[level] += report.chance <= levels[level];
                    }
        for (int level = 0; level < 3; ++level)
        {
            const double expected = calls * levels[level];
            EXPECT_LE(below[level], expected + 3 * std::sqrt(expected))
                << "problem " << type << " " << levels[level];
        }
        if (cvtest::debugLevel > 0)
            printf("problem %d: of %d calls, chance is at most 0.1 in %d, 0.01 in %d, 0.001 in %d, "
                   "0.5 in %d\n",
                   type, calls, below[0], below[1], below[2], half);
    }
}

//! Correct models of few points, or with a low inlier ratio, must be distinguished from random
//! models: Report::chance must be below 0.001 in at least 19 of 20 scenes.
TEST(Usac_Significance, rightModelsOfFewPoints)
{
    const struct
    {
        ProblemType problem;
        int size;
        double inlierRatio;
    } cases[] = {{HOMOGRAPHY, 15, 0.7},  {HOMOGRAPHY, 30, 0.6},   {FUNDAMENTAL, 15, 0.9},
                 {FUNDAMENTAL, 30, 0.6}, {ESSENTIAL, 15, 0.8},    {ESSENTIAL, 30, 0.6},
                 {HOMOGRAPHY, 200, 0.2}, {FUNDAMENTAL, 200, 0.4}, {ESSENTIAL, 200, 0.3}};
    for (size_t c = 0; c < sizeof(cases) / sizeof(cases[0]); ++c)
    {
        int significant = 0;
        for (uint64 seed = 1; seed <= 20; ++seed)
        {
            const Scene scene = rightScene(cases[c].problem, cases[c].size, cases[c].inlierRatio,
                                           seed);
            significant += significantReport(scene, Params()).chance < 1e-3;
        }
        EXPECT_GE(significant, 19)
            << "problem " << (int)cases[c].problem << ", " << cases[c].size << " points";
    }
}

//! Random matches must give no model (except for at most one of 20 sets): 200 matches by default,
//! and 15 matches if the caller sets a limit (Params::significance). By default, 15 matches are too
//! few to reject a model.
TEST(Usac_Significance, randomMatchesGiveNoModel)
{
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        int models[2] = {0}, few = 0;
        for (uint64 seed = 1; seed <= 20; ++seed)
        {
            const Scene many = randomScene((ProblemType)problem, 200, seed),
                        scarce = randomScene((ProblemType)problem, 15, seed);
            Params params;
            params.maxIterations = 1000;
            Report report;
            Mat mask;
            const Mat model = estimate(many, params, mask, &report);
            models[0] += !model.empty();
            EXPECT_EQ(model.empty(), estimate(many, params).empty()) << "the same without a report";
            if (model.empty())
            {
                EXPECT_EQ((int)STOP_NOT_SIGNIFICANT, report.stop);
                EXPECT_EQ(0, countNonZero(mask));
                EXPECT_EQ(0, report.inliers);
                EXPECT_EQ(0, report.independentInliers);
                EXPECT_GT(report.chance, 0.01);
                EXPECT_NE(String::npos, report.describe().find("random"));
            }
            few += !estimate(scarce, params).empty();
            params.significance = 0.01;
            models[1] += !estimate(scarce, params).empty();
            params.significance = 1;
            EXPECT_FALSE(estimate(many, params).empty());
        }
        EXPECT_LE(models[0], 1) << "problem " << (int)problem;
        EXPECT_LE(models[1], 1) << "problem " << (int)problem;
        EXPECT_EQ(20, few) << "problem " << (int)problem << ": too few points to reject";
    }
}

//! Correct models must be returned with few points, with a minimal sample only, and with thresholds
//! far below the noise or above the size of the image.
TEST(Usac_Significance, rightModelsAreReturned)
{
    for (int problem : TWO_VIEW_PROBLEMS)
        for (uint64 seed = 1; seed <= 5; ++seed)
        {
            const int sizes[] = {8, 15, 40, 300};
            for (int s = 0; s < 4; ++s)
                EXPECT_FALSE(
                    estimate(rightScene((ProblemType)problem, sizes[s], 1, seed), Params()).empty())
                    << sizes[s];
            Params params;
            params.threshold = 0.05;  // a tenth of the noise
            EXPECT_FALSE(estimate(rightScene((ProblemType)problem, 200, 0.6, seed), params).empty())
                << (int)problem;
            params.threshold = 1000;
            EXPECT_FALSE(estimate(rightScene((ProblemType)problem, 200, 0.6, seed), params).empty())
                << (int)problem;
        }
    SceneOptions options;
    options.inliers = 4;
    options.outliers = 0;
    EXPECT_FALSE(estimate(makeScene(HOMOGRAPHY, options), Params()).empty())
        << "no points but a minimal sample";
}

//! Random matches that are repeated must not count as evidence for a model. At most one of ten sets
//! is allowed to give a model.
TEST(Usac_Significance, repeatedMatches)
{
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        int models = 0;
        for (uint64 seed = 1; seed <= 10; ++seed)
        {
            Scene scene = randomScene((ProblemType)problem, 20, seed);
            for (int i = 0; i < 80; ++i)
            {
                scene.points1.push_back(scene.points1[i]);
                scene.points2.push_back(scene.points2[i]);
            }
            Params params;
            params.maxIterations = 500;
            params.significance = 0.01;
            models += !estimate(scene, params).empty();
        }
        EXPECT_LE(models, 1) << "problem " << (int)problem;
    }
}

//! Random matches, of which 80 of 200 lead to one point. Without degeneracy checks, the best model
//! maps everything to this point (unless it is a translation). It has no more independent inliers
//! than expected by chance, and there are enough other points to decide this, so that the run must
//! return no model.
TEST(Usac_Significance, mapsToOnePlace)
{
    for (ProblemType problem : {HOMOGRAPHY, AFFINITY, SIMILARITY, TRANSLATION_2D})
        for (UsacV20Method flag : {USACV20, USACV20_FAST, USACV20_ACCURATE, USACV20_MAGSAC})
        {
            int models = 0, refused = 0;
            for (uint64 seed = 1; seed <= 20; ++seed)
            {
                SceneOptions options;
                options.setSize(200, 0.005);
                options.outlierModel = OUTLIERS_PLACE;
                options.structured = 80;
                options.seed = seed;
                Params params = Params::fromMethod(flag);
                params.threshold = 1.5;
                params.degeneracy = 0;
                params.maxIterations = 1000;
                Report report;
                models += !estimate(makeScene(problem, options), params, noArray(), &report)
                               .empty();
                refused += report.stop == STOP_NOT_SIGNIFICANT;
            }
            EXPECT_EQ(0, models) << (int)problem << ", flag " << (int)flag;
            EXPECT_EQ(20, refused) << (int)problem << ", flag " << (int)flag;
        }
}

//! If all matches are repeated, there are too few different matches to decide whether a model is
//! random, so that the model must be returned.
TEST(Usac_Significance, repeatedRightMatchesStay)
{
    for (int problem : TWO_VIEW_PROBLEMS)
        for (uint64 seed = 1; seed <= 20; ++seed)
        {
            SceneOptions options;
            options.inliers = sampleSizeOf(problem) + 1;
            options.outliers = 2;
            options.copies = 20;
            options.noise = 0.1;
            options.seed = seed;
            Report report;
            EXPECT_FALSE(
                estimate(makeScene((ProblemType)problem, options), Params(), noArray(), &report)
                    .empty())
                << (int)problem << ", seed " << seed << ", chance " << report.chance;
        }
}

}
}  // namespace
