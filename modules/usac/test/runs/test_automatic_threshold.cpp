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

TEST_P(UsacAutomaticThreshold, sameBits)
{
    const Scene scene = sceneOf(GetParam(), 0.5, 1);
    Params params = widest(10);
    const Ptr<Usac> usac = createUsac(scene, params);
    Report reports[3];
    Mat masks[3], models[3];
    models[0] = usac->run(masks[0], &reports[0]);
    models[1] = usac->run(masks[1], &reports[1]);
    params.threads = 3;
    models[2] = estimate(scene, params, masks[2], &reports[2]);
    for (int k = 1; k < 3; ++k)
    {
        EXPECT_TRUE(sameBits(models[0], models[k])) << k;
        EXPECT_TRUE(sameBits(masks[0], masks[k])) << k;
        EXPECT_EQ(reports[0].sigma, reports[k].sigma) << k;
        EXPECT_EQ(reports[0].threshold, reports[k].threshold) << k;
        EXPECT_EQ(reports[0].iterations, reports[k].iterations) << k;
    }
    EXPECT_FALSE(sameBits(models[0], createUsac(scene, Params())->run()));
}

//! After setPoints(), a Usac object must give the result of a new object, even with the largest
//! seed.
TEST_P(UsacAutomaticThreshold, otherPointsAndSeeds)
{
    const Scene first = sceneOf(GetParam(), 2, 1, 500), second = sceneOf(GetParam(), 0.1, 2);
    Params params = widest(10);
    params.seed = INT_MAX;
    const Ptr<Usac> usac = createUsac(first, params);
    Report before, after, expected;
    Mat mask, other;
    usac->run(mask, &before);
    usac->setPoints(second.points1, second.points2);
    const Mat model = usac->run(mask, &after);
    EXPECT_TRUE(sameBits(estimate(second, params, other, &expected), model));
    EXPECT_TRUE(sameBits(other, mask));
    EXPECT_EQ(expected.sigma, after.sigma);
    EXPECT_GT(before.sigma, 5 * after.sigma);
}

//! If there are many points, the search uses only a part of them, but the threshold must be that of
//! all points.
TEST_P(UsacAutomaticThreshold, manyPoints)
{
    const Scene scene = sceneOf(GetParam(), 0.5, 1, 50000);
    Report report;
    Mat mask;
    const Mat model = estimate(scene, widest(10), mask, &report);
    ASSERT_FALSE(model.empty());
    EXPECT_NEAR(1, report.sigma / sigmaOf(scene), 0.1);
    EXPECT_NEAR(0.6, (double)countNonZero(mask) / scene.size(), 0.05);
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

//! The noise can be estimated from the errors of an initial model, so that eight samples must
//! suffice.
TEST_P(UsacAutomaticThreshold, initialModel)
{
    const Scene scene = sceneOf(GetParam(), 0.5, 1, 300, 0.4);
    Report report;
    Mat mask;
    const Mat first = estimate(scene, widest(10), mask, &report);
    Params params = widest(10);
    params.setInitialModel(first);
    params.maxIterations = 8;
    Report again;
    const Mat model = estimate(scene, params, mask, &again);
    ASSERT_FALSE(model.empty());
    EXPECT_LE(again.iterations, 8);
    EXPECT_NEAR(1, again.threshold / report.threshold, 0.1);
    EXPECT_LE(modelError(scene, model), 1.5 * modelError(scene, first));
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

//! A second motion with fewer matches must not be taken for larger noise in more than one of ten
//! scenes.
TEST_P(UsacAutomaticThreshold, besideAnotherMotion)
{
    int right = 0;
    const int SCENES = 10;
    for (int seed = 1; seed <= SCENES; ++seed)
    {
        SceneOptions options;
        options.inliers = 200;
        options.outliers = 150;
        options.outlierModel = OUTLIERS_UNIFORM;
        options.second = 100;
        options.seed = seed;
        const Scene scene = makeScene((ProblemType)GetParam(), options);
        Report report;
        Mat mask;
        const Mat model = estimate(scene, widest(5), mask, &report);
        right += !model.empty() && modelError(scene, model) < 1.5;
    }
    EXPECT_GE(right, SCENES - 1);
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

TEST(Usac_AutomaticThreshold, poses)
{
    for (double noise : NOISES)
    {
        PoseSceneOptions options;
        options.size = 300;
        options.noise = noise;
        options.inlierRatio = 0.5;
        const PoseScene scene = makePoseScene(options);
        Mat mask;
        Report report;
        const Mat pose = estimateAbsolutePose(scene.object, scene.image, scene.K, scene.distortion,
                                              widest(10), mask, report);
        ASSERT_FALSE(pose.empty());
        EXPECT_NEAR(1, report.sigma / noise, 0.25);
        EXPECT_LE(report.threshold, 6 * noise);
        EXPECT_EQ(report.inliers, countNonZero(mask));
    }
}

TEST(Usac_AutomaticThreshold, motionsOfSpace)
{
    RigidSceneOptions options;
    options.size = 300;
    options.inlierRatio = 0.5;
    const RigidScene scene = makeRigidScene(options);
    Mat mask;
    Report report;
    const Mat motion = estimateRigid3D(scene.points1, scene.points2, widest(10 * scene.threshold),
                                       mask, report);
    ASSERT_FALSE(motion.empty());
    EXPECT_LE(rotationError(scene, Matx34d(motion)), 0.2) << "degrees";
    EXPECT_GT(report.sigma, 0);
    EXPECT_LE(report.threshold, 2 * scene.threshold);
    EXPECT_EQ(report.inliers, countNonZero(mask));
}

//! Estimates the noise from errors of known distribution, those of matches under the identity.
class NoiseOfErrors
{
public:
    //! @param tail fraction of the inliers with three times the noise
    //! @param inliers fraction of inliers
    //! @param precise true: uses preciseNoise(); false: uses roughNoise()
    InlierNoise estimate(double sigma, double tail, double inliers, int seed, bool precise) const
    {
        const int SIZE = 2000;
        RNG rng(seed);
        std::vector<Point2d> from, to;
        for (int i = 0; i < SIZE; ++i)
        {
            const Point2d point(rng.uniform(0., 640.), rng.uniform(0., 480.));
            const double scale = sigma * (rng.uniform(0., 1.) < tail ? 3 : 1);
            const Point2d moved(point.x + rng.gaussian(scale), point.y + rng.gaussian(scale)),
                other(rng.uniform(0., 640.), rng.uniform(0., 480.));
            from.push_back(point);
            to.push_back(rng.uniform(0., 1.) < inliers ? moved : other);
        }
        Params params;
        params.threshold = 10;
        const Ptr<Usac> usac = Usac::create(SIMILARITY, from, to, params);
        const RunContext context(usac->points(), usac->components(), params);
        const double scale = usac->points().frame[1].scale;
        Model model;
        EXPECT_TRUE(usac->points().problem->fromOutput(std::vector<double>({1, 0, 0, 0, 1, 0}),
                                                       usac->points(), model));
        InlierNoise noise = precise ? preciseNoise(context, model, 10 * scale)
                                    : roughNoise(context, model, 10 * scale, 300, seed % 2 == 0);
        noise.sigma /= scale;
        noise.threshold /= scale;
        return noise;
    }
};

TEST(Usac_InlierNoise, ofGaussianErrors)
{
    for (double sigma : {0.1, 0.5, 2.})
        for (double inliers : {0.2, 0.5, 0.95})
            for (int precise = 0; precise < 2; ++precise)
            {
                std::vector<double> sigmas, thresholds, parts;
                for (int seed = 1; seed <= 15; ++seed)
                {
                    const InlierNoise noise = NoiseOfErrors().estimate(sigma, 0, inliers, seed,
                                                                       precise != 0);
                    sigmas.push_back(noise.sigma / sigma);
                    thresholds.push_back(noise.threshold / sigma);
                    parts.push_back(noise.part / inliers);
                }
                SCOPED_TRACE(cv::format("sigma %g, inliers %g, %d", sigma, inliers, precise));
                EXPECT_NEAR(1, median(sigmas), precise ? 0.05 : 0.1);
                EXPECT_NEAR(precise ? 2.6 : 2.2, median(thresholds), precise ? 0.4 : 0.25);
                EXPECT_NEAR(1, median(parts), 0.12);
            }
}

//! The errors of 5 % of the inliers must exceed the threshold, even if a third of the inliers have
//! three times the noise.
TEST(Usac_InlierNoise, ofBadlyLocatedInliers)
{
    std::vector<double> sigmas, thresholds;
    for (int seed = 1; seed <= 15; ++seed)
    {
        const InlierNoise noise = NoiseOfErrors().estimate(0.4, 1. / 3, 0.7, seed, true);
        sigmas.push_back(noise.sigma / 0.4);
        thresholds.push_back(noise.threshold / 0.4);
    }
    // threshold x in sigmas: 2 / 3 exp(-x^2 / 2) + 1 / 3 exp(-x^2 / 18) = 0.05
    EXPECT_NEAR(5.84, median(thresholds), 0.6);
    EXPECT_NEAR(1, median(sigmas), 0.1);
}

TEST(Usac_InlierNoise, ofRandomMatchesIsUnknown)
{
    for (int seed = 1; seed <= 20; ++seed)
        EXPECT_EQ(0, NoiseOfErrors().estimate(1, 0, 0, seed, true).sigma) << seed;
}

}  // namespace
}  // namespace opencv_test
