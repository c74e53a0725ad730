// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"
#include "problems/absolute_pose/pose_scenes.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"
#include "support/run_context.hpp"
#include "significance/inlier_noise.hpp"

namespace opencv_test {
namespace {

const double NOISES[] = {0.1, 0.5, 2};

Scene sceneOf(int problem, double noise, int seed, int size = 300, double ratio = 0.6)
{
    SceneOptions options;
    options.setSize(size, ratio);
    options.noise = noise;
    options.seed = seed;
    return makeScene((ProblemType)problem, options);
}

Params widest(double pixels)
{
    Params params = Params::automatic();
    params.threshold = pixels;
    return params;
}

//! Standard deviation per component, in pixels, of the errors of the true matches under a fit to
//! them.
double sigmaOf(const Scene& scene)
{
    const Ptr<Usac> usac = createUsac(scene, Params());
    const Mat errors = usac->errors(usac->fit(noArray(), scene.truth));
    double sum = 0;
    for (int i = 0; i < scene.size(); ++i)
        sum += scene.truth[i] ? errors.at<double>(i) * errors.at<double>(i) : 0;
    const int degrees = usac->points().problem->errorDimension();
    return std::sqrt(sum / degrees / std::max(countNonZero(scene.truth), 1));
}

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

typedef testing::TestWithParam<int> UsacAutomaticThreshold;
INSTANTIATE_TEST_CASE_P(/**/, UsacAutomaticThreshold, testing::ValuesIn(TWO_VIEW_PROBLEMS));

//! The standard deviation of the noise must be found within 10 % in the median and within 35 % in
//! each scene. The properties documented for a given threshold must also hold for the estimated
//! threshold.
TEST_P(UsacAutomaticThreshold, noiseOfScenes)
{
    for (double noise : NOISES)
        for (double given : {5., 15.})
        {
            SCOPED_TRACE(cv::format("noise %g, threshold at most %g", noise, given));
            std::vector<double> ratios;
            for (int seed = 1; seed <= 9; ++seed)
            {
                const Scene scene = sceneOf(GetParam(), noise, seed);
                Mat mask;
                Report report;
                const Mat model = estimate(scene, widest(given), mask, &report);
                ASSERT_FALSE(model.empty());
                checkResult(scene, report.threshold, model, mask, report);
                ratios.push_back(report.sigma / sigmaOf(scene));
                EXPECT_NEAR(1, ratios.back(), 0.35) << seed;
                EXPECT_LE(report.threshold, given * (1 + 1e-9)) << seed;
                EXPECT_GE(report.threshold, std::min(1.7 * report.sigma, given)) << seed;
                EXPECT_LE(report.threshold, 6 * report.sigma) << seed;
                EXPECT_GE(report.searchMs, 0) << seed;
                EXPECT_FALSE(report.sample.empty()) << seed;
            }
            EXPECT_NEAR(1, median(ratios), 0.1);
        }
}

//! The threshold is estimated with an upper bound of three and of ten times the right threshold.
//! The mean error of the models must be at most 1.1 times that with the right threshold.
TEST_P(UsacAutomaticThreshold, asAccurateAsTheRightThreshold)
{
    double right = 0, estimated = 0;
    for (double noise : NOISES)
        for (int seed = 1; seed <= 12; ++seed)
        {
            const Scene scene = sceneOf(GetParam(), noise, seed, 300, 0.5);
            Params params;
            params.threshold = 3 * noise;
            right += modelError(scene, estimate(scene, params)) / noise;
            for (int factor : {3, 10})
                estimated += modelError(scene, estimate(scene, widest(factor * params.threshold))) /
                             noise / 2;
        }
    EXPECT_LE(estimated, 1.1 * right);
}

//! Random matches must give no model, whether they are uniform or in clusters, except by chance in
//! about one of a hundred cases.
TEST_P(UsacAutomaticThreshold, randomMatches)
{
    const int SIZE = 300, REPEATS = 50;
    int models = 0;
    for (int clusters = 0; clusters < 2; ++clusters)
        for (int run = 0; run < REPEATS; ++run)
        {
            RNG rng(run + 1);
            std::vector<Point2d> points[2];
            for (int i = 0; i < SIZE; ++i)
                for (int k = 0; k < 2; ++k)
                {
                    const Point2d center(100 + 100 * rng.uniform(0, 5),
                                         100 + 60 * rng.uniform(0, 5)),
                        moved(rng.gaussian(20), rng.gaussian(20)),
                        anywhere(rng.uniform(0., 640.), rng.uniform(0., 480.));
                    points[k].push_back(clusters ? center + moved : anywhere);
                }
            Report report;
            Mat mask;
            const Mat model = estimatePoints((ProblemType)GetParam(), points[0], points[1],
                                             widest(4.5), mask, report);
            models += !model.empty();
            EXPECT_EQ(model.empty(), countNonZero(mask) == 0) << run << ": " << report.describe();
        }
    EXPECT_LE(models, 2) << "of " << 2 * REPEATS;
}

//! If the noise cannot be estimated, the threshold must be two thirds of the given one.
TEST_P(UsacAutomaticThreshold, tooFewPoints)
{
    Scene scene = sceneOf(GetParam(), 0.5, 1, 8, 1);
    std::reverse(scene.points2.begin(), scene.points2.end());  // makes all matches wrong
    Params params = widest(6);
    params.significance = 1;
    Report report;
    Mat mask;
    const Mat model = estimate(scene, params, mask, &report);
    EXPECT_EQ(0, report.sigma);
    EXPECT_NEAR(4, report.threshold, 1e-9);
    if (!model.empty())
        checkResult(scene, 4, model, mask, report);
    const Ptr<Usac> usac = createUsac(scene, params);
    usac->refine(usac->fit(), noArray(), mask, &report);
    EXPECT_EQ(0, report.sigma);
    EXPECT_NEAR(4, report.threshold, 1e-9);
}

//! Without noise, the threshold must be at most 1/200 of the given one, and at least 1/1024 of it
//! (the smallest value allowed). All true matches must be inliers.
TEST_P(UsacAutomaticThreshold, exactPoints)
{
    const Scene scene = sceneOf(GetParam(), 0, 1);
    Report report;
    Mat mask;
    const Mat model = estimate(scene, widest(5), mask, &report);
    ASSERT_FALSE(model.empty());
    EXPECT_LE(report.threshold, 5 / 200.);
    EXPECT_GE(report.threshold, 5 / 1025.);
    for (int i = 0; i < scene.size(); ++i)
        EXPECT_LE((int)scene.truth[i], (int)mask.at<uchar>(i)) << i;
}

//! refine() must estimate the threshold under the given model; fit() must use the given threshold.
TEST_P(UsacAutomaticThreshold, givenModels)
{
    const Scene scene = sceneOf(GetParam(), 0.5, 1);
    const Ptr<Usac> usac = createUsac(scene, widest(10));
    Report report, other;
    Mat mask;
    const Mat fitted = usac->fit(noArray(), scene.truth, mask, &report);
    EXPECT_NEAR(10, report.threshold, 1e-9);
    EXPECT_EQ(0, report.sigma);
    const Mat refined = usac->refine(fitted, noArray(), mask, &report);
    EXPECT_NEAR(1, report.sigma / sigmaOf(scene), 0.2);
    EXPECT_LE(report.threshold, 4);
    checkResult(scene, report.threshold, refined, mask, report);
    usac->run(mask, &other);
    EXPECT_NEAR(1, other.threshold / report.threshold, 0.3);
}

//! With 20 inliers, the errors under a fit are much smaller than the noise. The errors of maps
//! contain the noise of both images.
TEST_P(UsacAutomaticThreshold, noiseOfFewInliers)
{
    const double noise = mapsPoints((ProblemType)GetParam()) ? 0.5 * std::sqrt(2.) : 0.5;
    std::vector<double> ratios;
    for (int seed = 1; seed <= 101; ++seed)
    {
        Report report;
        estimate(sceneOf(GetParam(), 0.5, seed, 40, 0.5), widest(5), noArray(), &report);
        ratios.push_back(report.sigma / noise);
    }
    EXPECT_NEAR(1, median(ratios), 0.1);
}

//! Copies of an outlier have no noise, so that the noise must be estimated only from different
//! matches. (This is not tested with F and E: a model that fits the outlier, too, might fit more
//! matches than the true one.)
TEST_P(UsacAutomaticThreshold, repeatedMatches)
{
    if (!mapsPoints((ProblemType)GetParam()))
        return;
    int right = 0;
    const int SCENES = 10;
    for (int seed = 1; seed <= SCENES; ++seed)
    {
        SceneOptions options;
        options.setSize(100, 0.6);
        options.seed = seed;
        Scene scene = makeScene((ProblemType)GetParam(), options);
        int wrong = 0;
        while (scene.truth[wrong])
            ++wrong;
        for (int i = 0; i < 60; ++i)  // copies of a wrong match
        {
            scene.points1.push_back(scene.points1[wrong]);
            scene.points2.push_back(scene.points2[wrong]);
            scene.truth.push_back(0);
        }
        Report report;
        Mat mask;
        const Mat model = estimate(scene, widest(4.5), mask, &report);
        right += report.sigma > 0.7 * sigmaOf(scene) && report.sigma < 1.4 * sigmaOf(scene);
    }
    EXPECT_GE(right, SCENES - 1);
}

//! The noise must also be found with other presets, for example with a score that estimates a
//! threshold itself (LMedS), or that is marginalized over the noise (MAGSAC).
TEST_P(UsacAutomaticThreshold, otherScores)
{
    const Scene scene = sceneOf(GetParam(), 0.5, 1, 300, 0.7);
    for (Params params : {Params::magsacPlusPlus(), Params::magsac(), Params::lmeds(),
                          Params::mlesac(), Params::ransac(), Params::fast(), Params::accurate()})
    {
        params.threshold = 10;
        params.thresholdType = THRESHOLD_ESTIMATED;
        Report report;
        Mat mask;
        const Mat model = estimate(scene, params, mask, &report);
        ASSERT_FALSE(model.empty());
        EXPECT_NEAR(1, report.sigma / sigmaOf(scene), 0.25) << (int)params.quality;
        EXPECT_LE(report.threshold, 4) << (int)params.quality;
        checkResult(scene, report.threshold, model, mask, report, params.widestReach);
    }
}

//! The map enlarges the noise of image 1 five times in one direction, so that most errors are much
//! smaller than the largest ones. The inliers with large errors must not be taken for another
//! motion.
TEST(Usac_AutomaticThreshold, noiseEnlargedInOneDirection)
{
    const int SCENES = 20, SIZE = 600, RIGHT = 400;
    const double NOISE = 0.15;
    for (int seed = 1; seed <= SCENES; ++seed)
    {
        RNG rng(seed);
        const double angle = rng.uniform(0., CV_PI), c = std::cos(angle), s = std::sin(angle);
        const Matx22d A(5 * c, -5 * s, s, c);
        std::vector<Point2d> points1(SIZE), points2(SIZE);
        for (int i = 0; i < SIZE; ++i)
        {
            points1[i] = Point2d(rng.uniform(0., 1000.), rng.uniform(0., 1000.));
            points2[i] = i < RIGHT ? A * points1[i]
                                   : Point2d(rng.uniform(0., 1000.), rng.uniform(0., 1000.));
            points1[i] += NOISE * Point2d(rng.gaussian(1), rng.gaussian(1));
            points2[i] += NOISE * Point2d(rng.gaussian(1), rng.gaussian(1));
        }
        Params params = widest(2);
        params.seed = seed;
        Mat mask;
        Report report;
        const Mat map = estimateAffinity2D(points1, points2, params, mask, report);
        ASSERT_FALSE(map.empty());
        EXPECT_GT(countNonZero(mask), 0.9 * RIGHT) << seed;
        EXPECT_LT(countNonZero(mask), 1.03 * RIGHT) << seed;
    }
}

}  // namespace
}  // namespace opencv_test
