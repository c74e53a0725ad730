// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

#include "two_view_scenes.hpp"

// Tests of the configurations of two images that estimateTwoViewGeometry distinguishes.

namespace opencv_test {
namespace {

TEST(Usac_TwoViewGeometry, calibrated)
{
    for (uint64 seed = 1; seed <= 20; ++seed)
    {
        const Scene scene = twoViewScene(seed);
        const TwoViewPair pair = pairOf(scene);
        const TwoViewGeometry found = estimateTwoViewGeometry(pair, twoPixels());
        ASSERT_EQ((int)TWO_VIEW_CALIBRATED, found.configuration) << seed;
        checkFields(found, pair);
        EXPECT_LT(angleBetween(found.R, scene.R), 2 * DEGREE) << seed;
        EXPECT_GT(Vec3d(found.t.ptr<double>()).dot(scene.t), std::cos(15 * DEGREE)) << seed;
        EXPECT_NEAR(1, cv::norm(found.t), 1e-12);
        const Vec3d t(found.t.ptr<double>());
        const Matx33d cross(0, -t[2], t[1], t[2], 0, -t[0], -t[1], t[0], 0);
        const Matx33d E = cross * Matx33d(found.R.ptr<double>()) * (1 / std::sqrt(2.)),
                      own(found.E.ptr<double>());
        EXPECT_LT(std::min(cv::norm(E - own), cv::norm(E + own)), 1e-9);
        Matx33d F = scene.K.inv().t() * own * scene.K.inv();
        F *= 1 / cv::norm(F);
        EXPECT_LT(cv::norm(F - Matx33d(found.F.ptr<double>())), 1e-12);
        ASSERT_EQ(3, found.rotations.rows);
        EXPECT_EQ(0, cv::norm(found.rotations, found.R));
        int right = 0, all = 0;
        for (int i = 0; i < scene.size(); ++i)
        {
            all += scene.truth[i];
            right += scene.truth[i] && found.mask.at<uchar>(i);
        }
        EXPECT_GT(right, 0.9 * all) << seed;
    }
}

//! The models must equal, bit by bit, those of the functions for a single problem.
TEST(Usac_TwoViewGeometry, as_the_functions_of_one_problem)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        const Scene scene = twoViewScene(seed);
        Params params = twoPixels();
        const TwoViewGeometry calibrated = estimateTwoViewGeometry(pairOf(scene), params);
        const TwoViewGeometry plain = estimateTwoViewGeometry(scene.points1, scene.points2,
                                                              noArray(), noArray(), params);
        ASSERT_EQ((int)TWO_VIEW_CALIBRATED, calibrated.configuration);
        ASSERT_EQ((int)TWO_VIEW_UNCALIBRATED, plain.configuration);
        params.significance = 1e-4;
        Mat mask;
        Report report;
        params.maxIterations = (int)std::min(10000.,
                                             TwoViewRules().samples(twoPixels(), 5, scene.size()));
        const Mat E = estimateEssential(scene.points1, scene.points2, scene.K, params, mask,
                                        report);
        EXPECT_EQ(0, cv::norm(E, calibrated.E));
        EXPECT_EQ(0, cv::norm(mask, calibrated.mask));
        EXPECT_EQ(report.chance, calibrated.report.chance);
        params.maxIterations = (int)std::min(10000.,
                                             TwoViewRules().samples(twoPixels(), 7, scene.size()));
        const Mat F = estimateFundamental(scene.points1, scene.points2, params, mask, report);
        EXPECT_EQ(0, cv::norm(F, plain.F));
        EXPECT_EQ(0, cv::norm(mask, plain.mask));
        EXPECT_EQ(report.iterations, plain.report.iterations);
    }
}

//! If the y axis of both cameras points upward, one focal length of each is negative. The motion
//! must be the true one, mirrored like the axis.
TEST(Usac_TwoViewGeometry, y_axis_upward)
{
    const Matx33d mirror(1, 0, 0, 0, -1, 0, 0, 0, 1);
    for (int seed = 1; seed <= 20; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.outliers = 100;
        options.motion = seed % 2 ? MOTION_GENERAL : MOTION_FORWARD;
        const Scene scene = makeScene(ESSENTIAL, options);
        TwoViewPair pair = pairOf(scene);
        pair.cameraMatrix1.at<double>(1, 1) *= -1;
        pair.cameraMatrix2.at<double>(1, 1) *= -1;
        const TwoViewGeometry found = estimateTwoViewGeometry(pair, twoPixels());
        ASSERT_EQ((int)TWO_VIEW_CALIBRATED, found.configuration) << seed;
        EXPECT_LT(angleBetween(found.R, mirror * scene.R * mirror), 2 * DEGREE) << seed;
        EXPECT_GT(Vec3d(found.t.ptr<double>()).dot(mirror * scene.t), std::cos(15 * DEGREE))
            << seed;
    }
}

//! The first model that is accepted must determine the threshold of all models of the pair.
TEST(Usac_TwoViewGeometry, estimated_threshold)
{
    for (uint64 seed = 1; seed <= 8; ++seed)
        for (int kind = 0; kind < 3; ++kind)  // 0: with cameras; 1: without cameras; 2: a plane
        {
            const Scene scene = twoViewScene(seed, kind == 2 ? 1 : 0);
            const TwoViewPair pair = pairOf(scene, kind != 1);
            Params params = twoPixels();
            const int expected = estimateTwoViewGeometry(pair, params).configuration;
            params.threshold = 6;
            params.thresholdType = THRESHOLD_ESTIMATED;
            const TwoViewGeometry found = estimateTwoViewGeometry(pair, params);
            SCOPED_TRACE(cv::format("seed %d, kind %d", (int)seed, kind));
            EXPECT_EQ(expected, found.configuration);
            checkFields(found, pair);
            EXPECT_NEAR(0.5, found.report.sigma, 0.15);
            EXPECT_NEAR(1, found.report.threshold, 0.5);
            const std::vector<TwoViewGeometry> both = estimateTwoViewGeometries({pair, pair},
                                                                                params);
            EXPECT_EQ(0, cv::norm(found.mask, both[1].mask));
        }
}

//! With a given threshold, the report must contain the noise only if Params::covariance is set.
TEST(Usac_TwoViewGeometry, noise_with_a_given_threshold)
{
    const Scene scene = twoViewScene(1);
    Params params = twoPixels();
    EXPECT_EQ(0, estimateTwoViewGeometry(pairOf(scene), params).report.sigma);
    params.covariance = 1;
    EXPECT_NEAR(0.5, estimateTwoViewGeometry(pairOf(scene), params).report.sigma, 0.1);
}

TEST(Usac_TwoViewGeometry, focal_lengths_that_are_not_known)
{
    for (uint64 seed = 1; seed <= 5; ++seed)
    {
        const Scene scene = twoViewScene(seed);
        for (int known = 0; known < 3; ++known)
        {
            TwoViewPair pair = pairOf(scene);
            if (known != 1)
                pair.cameraMatrix1.release();
            if (known != 2)
                pair.cameraMatrix2.release();
            const TwoViewGeometry found = estimateTwoViewGeometry(pair, twoPixels());
            EXPECT_EQ((int)TWO_VIEW_UNCALIBRATED, found.configuration) << seed << " " << known;
            checkFields(found, pair);
            EXPECT_TRUE(found.E.empty() && found.R.empty() && found.t.empty() &&
                        found.rotations.empty());
        }
    }
}

//! F must reveal a wrong focal length, even if many true matches are on a plane, with which an E
//! estimated with wrong focal lengths can agree. `rotations` must contain one rotation, that of the
//! essential matrix nearest to F.
TEST(Usac_TwoViewGeometry, wrong_focal_lengths)
{
    for (uint64 seed = 1; seed <= 20; ++seed)
    {
        const double onPlane[] = {0, 0.35, 0.5, 0.65};
        TwoViewPair pair = pairOf(twoViewScene(seed, onPlane[seed % 4]));
        pair.cameraMatrix1.at<double>(0, 0) *= 4;
        pair.cameraMatrix1.at<double>(1, 1) *= 4;
        Params params = twoPixels();
        params.threshold = 1;
        const TwoViewGeometry found = estimateTwoViewGeometry(pair, params);
        EXPECT_EQ((int)TWO_VIEW_UNCALIBRATED, found.configuration) << seed;
        EXPECT_TRUE(found.E.empty() && found.R.empty());
        EXPECT_EQ(3, found.rotations.rows);
    }
}

//! Adds `count` wrong matches that agree with each other: copies of right matches whose points in
//! image 2 are moved by `distance` pixels, alternately to the left and to the right, as in images
//! of a facade with equal windows.
void addRepetitions(Scene& scene, int count, double distance)
{
    for (int i = 0; count > 0; ++i)
    {
        if (!scene.truth[i])
            continue;
        const Point2d moved(--count % 2 ? distance : -distance, 0);
        scene.points1.push_back(Point2d(scene.points1[i]));
        scene.points2.push_back(scene.points2[i] + moved);
    }
}

//! The number of pairs, out of 40 with repeated structure and right focal lengths, for which F is
//! returned instead of E. `count` and `distance` are those of addRepetitions().
int replacedByRepetitions(double baseline, double planeFraction, int count, double distance,
                          double threshold)
{
    Params params = twoPixels();
    params.threshold = threshold;
    int replaced = 0;
    for (int seed = 1; seed <= 40; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.baseline = baseline;
        options.planeFraction = planeFraction;
        options.outliers = 0;
        Scene scene = makeScene(ESSENTIAL, options);
        addRepetitions(scene, count, distance);
        const TwoViewGeometry found = estimateTwoViewGeometry(pairOf(scene), params);
        replaced += found.configuration == TWO_VIEW_UNCALIBRATED;
    }
    return replaced;
}

//! If the focal lengths are right, E must not be replaced by an F that has more inliers because it
//! also fits wrong matches.
TEST(Usac_TwoViewGeometry, repeated_structure)
{
    for (double distance : {10, 20, 40})  // of 40; 23 to 36 without contradictsCameras()
        EXPECT_LE(replacedByRepetitions(1, 0.8, 80, distance, 1), 5) << distance;
}

//! If the threshold is wide for the noise and the motion is small, an F that fits wrong matches can
//! still explain all inliers of E. E must be preferred because its errors are smaller.
TEST(Usac_TwoViewGeometry, repeated_structure_of_small_motions)
{
    int replaced = 0;
    for (double planeFraction : {0., 0.5})
        for (double threshold : {1.5, 2., 3.})
            replaced += replacedByRepetitions(0.2, planeFraction, 60, 40, threshold);
    EXPECT_LE(replaced, 12);  // of 240; 19 if the errors of both models are not compared
}

TEST(Usac_TwoViewGeometry, plane)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        const Scene scene = twoViewScene(seed, 1, 60);
        const TwoViewPair pair = pairOf(scene);
        const TwoViewGeometry found = estimateTwoViewGeometry(pair, twoPixels());
        ASSERT_EQ((int)TWO_VIEW_PLANAR, found.configuration) << seed;
        checkFields(found, pair);
        EXPECT_FALSE(found.H.empty() || found.R.empty());
        double least = CV_PI;
        for (int k = 0; k < found.rotations.rows / 3; ++k)
            least = std::min(least,
                             angleBetween(found.rotations.rowRange(3 * k, 3 * k + 3), scene.R));
        EXPECT_LT(least, 3 * DEGREE) << seed;
        const TwoViewGeometry unknown = estimateTwoViewGeometry(pairOf(scene, false), twoPixels());
        EXPECT_EQ((int)TWO_VIEW_PLANAR_OR_PANORAMIC, unknown.configuration) << seed;
        EXPECT_TRUE(unknown.R.empty());
    }
}

TEST(Usac_TwoViewGeometry, rotation)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        const Scene scene = turnedScene(seed);
        const TwoViewPair pair = pairOf(scene);
        const TwoViewGeometry found = estimateTwoViewGeometry(pair, twoPixels());
        ASSERT_EQ((int)TWO_VIEW_PANORAMIC, found.configuration) << seed;
        checkFields(found, pair);
        EXPECT_LT(angleBetween(found.R, scene.R), 0.5 * DEGREE) << seed;
        EXPECT_EQ(0, cv::norm(found.t));
        EXPECT_EQ((int)TWO_VIEW_PLANAR_OR_PANORAMIC,
                  estimateTwoViewGeometry(pairOf(scene, false), twoPixels()).configuration);
    }
}

TEST(Usac_TwoViewGeometry, watermark)
{
    RNG rng(1);
    Mat_<Point2d> first(60, 1), second(60, 1);
    for (int i = 0; i < 60; ++i)  // a date in the corner, shifted by 3 pixels in image 2
    {
        first(i) = uniformPoint(rng, 10., 200., 440., 475.);
        second(i) = first(i) + Point2d(3, 0) + gaussianPoint(rng, 0.3);
    }
    TwoViewPair pair(first, second);
    // the image sizes are unknown
    EXPECT_NE((int)TWO_VIEW_WATERMARK, estimateTwoViewGeometry(pair, twoPixels()).configuration);
    pair.imageSize1 = pair.imageSize2 = Size(SCENE_WIDTH, SCENE_HEIGHT);
    EXPECT_EQ((int)TWO_VIEW_WATERMARK, estimateTwoViewGeometry(pair, twoPixels()).configuration);
    // the tolerance for the common shift is in pixels, whatever the unit of the sigmas is
    Params params = twoPixels();
    params.threshold = 2. / 20;
    pair.sigmas.assign(60, 20.f);
    EXPECT_EQ((int)TWO_VIEW_WATERMARK, estimateTwoViewGeometry(pair, params).configuration);
    pair.sigmas.clear();
    pair.taken2 = second + Scalar(0, -200);  // original positions of the points, not in the corner
    EXPECT_NE((int)TWO_VIEW_WATERMARK, estimateTwoViewGeometry(pair, twoPixels()).configuration);
}

TEST(Usac_TwoViewGeometry, no_overlap)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        Scene scene = twoViewScene(seed, 0, 100);
        RNG rng(seed);
        for (int i = 0; i < scene.size(); ++i)
            scene.points2[i] = uniformPoint(rng, 0., 640., 0., 480.);
        const TwoViewGeometry found = estimateTwoViewGeometry(pairOf(scene), twoPixels());
        EXPECT_EQ((int)TWO_VIEW_DEGENERATE, found.configuration) << seed;
        EXPECT_EQ(0, found.inliers);
        EXPECT_EQ(0, countNonZero(found.mask));
        EXPECT_EQ(scene.size(), found.mask.rows);
        EXPECT_NE("", found.reason);
        EXPECT_TRUE(found.F.empty() && found.E.empty() && found.H.empty() && found.R.empty());
        Params few = twoPixels();
        few.maxIterations = 100;
        const String reason = estimateTwoViewGeometry(pairOf(scene, false), few).reason;
        EXPECT_NE(String::npos, reason.find("; all 100 samples drawn, confidence 0.")) << reason;
    }
}

TEST(Usac_TwoViewGeometry, few_matches)
{
    const Scene scene = twoViewScene(1);
    for (int count : {0, 1, 7, 14})
    {
        const std::vector<Point2d> first(scene.points1.begin(), scene.points1.begin() + count),
            second(scene.points2.begin(), scene.points2.begin() + count);
        const TwoViewGeometry found = estimateTwoViewGeometry(first, second, scene.K, scene.K);
        EXPECT_EQ((int)TWO_VIEW_DEGENERATE, found.configuration);
        EXPECT_EQ(format("%d matches, 15 are needed", count), found.reason);
        EXPECT_EQ(count, found.mask.rows);
        EXPECT_EQ(0, found.iterations);
    }
}

//! Distortion must be removed as by removeDistortion().
TEST(Usac_TwoViewGeometry, lenses)
{
    const Scene scene = twoViewScene(3);
    TwoViewPair taken = pairOf(scene), ideal = pairOf(scene);
    taken.distCoeffs1 = Mat(Vec4d(-0.1, 0.02, 0.001, -0.001));
    taken.distCoeffs2 = Mat(Vec4d(0.05, 0.01, 0, 0));
    ideal.points1 = removeDistortion(taken.points1, scene.K, taken.distCoeffs1);
    ideal.points2 = removeDistortion(taken.points2, scene.K, taken.distCoeffs2);
    const TwoViewGeometry a = estimateTwoViewGeometry(taken, twoPixels()),
                          b = estimateTwoViewGeometry(ideal, twoPixels());
    EXPECT_EQ(b.configuration, a.configuration);
    EXPECT_EQ(0, cv::norm(a.mask, b.mask));
    EXPECT_EQ(0, cv::norm(a.F, b.F));
    EXPECT_NE(0, cv::norm(a.F, estimateTwoViewGeometry(pairOf(scene), twoPixels()).F));
}

//! Scores of the pair must have the same effect as scores of the parameters.
TEST(Usac_TwoViewGeometry, scores)
{
    SceneOptions options;
    options.inliers = 40;
    options.outliers = 960;
    options.scoreInformation = 0.99;
    const Scene scene = makeScene(ESSENTIAL, options);
    Params params = twoPixels();
    params.maxIterations = 100;
    TwoViewPair pair = pairOf(scene);
    EXPECT_EQ((int)TWO_VIEW_DEGENERATE, estimateTwoViewGeometry(pair, params).configuration);
    pair.scores = scene.scores;
    const TwoViewGeometry byPair = estimateTwoViewGeometry(pair, params);
    EXPECT_EQ((int)TWO_VIEW_CALIBRATED, byPair.configuration);
    pair.scores.clear();
    params.scores = scene.scores;
    EXPECT_EQ(0, cv::norm(byPair.E, estimateTwoViewGeometry(pair, params).E));
}

//! If no model was found, TwoViewGeometry::reason must tell why.
TEST(Usac_TwoViewGeometry, reasons)
{
    const Scene scene = twoViewScene(1, 0, 200);
    TwoViewPair pair = pairOf(scene, false);
    for (int i = 3; i < scene.size(); ++i)
        pair.points1.at<Point2d>(i).x = NAN;
    EXPECT_EQ("F: too few points", estimateTwoViewGeometry(pair, twoPixels()).reason);
    const Mat same(30, 2, CV_64F, Scalar(100));
    EXPECT_EQ("F: too few points",
              estimateTwoViewGeometry(same, same, noArray(), noArray()).reason);
    pair = pairOf(scene, false);
    RNG rng(1);
    rng.fill(pair.points2, RNG::UNIFORM, 0, 480);
    Params params = twoPixels();
    params.maxTime = 1e-6;
    const TwoViewGeometry found = estimateTwoViewGeometry(pair, params);
    EXPECT_EQ((int)TWO_VIEW_DEGENERATE, found.configuration);
    EXPECT_NE(String::npos, found.reason.find(": the time limit was reached")) << found.reason;
    EXPECT_EQ((int)STOP_TIME, found.report.stop);
}

//! If only H is accepted, whether the camera has only rotated must be decided with the threshold
//! estimated for H: within the given threshold of 8 pixels, a rotation would explain all matches
//! of the plane, although the camera has moved.
TEST(Usac_TwoViewGeometry, estimated_threshold_of_a_plane_alone)
{
    int alone = 0;
    for (uint64 seed = 1; seed <= 12; ++seed)
    {
        Params params = twoPixels();
        params.threshold = 8;
        params.thresholdType = THRESHOLD_ESTIMATED;
        const TwoViewGeometry found = estimateTwoViewGeometry(pairOf(planeAlone(seed)), params);
        if (found.H.empty() || !found.E.empty() || !found.F.empty())
            continue;
        ++alone;
        EXPECT_EQ((int)TWO_VIEW_PLANAR, found.configuration) << seed;
        EXPECT_LT(found.report.threshold, 4) << seed;
    }
    EXPECT_GT(alone, 0);
}

//! The points of a watermark do not show the motion of the cameras, so that no rotations must be
//! returned for a watermark.
TEST(Usac_TwoViewGeometry, watermark_of_known_cameras)
{
    RNG rng(2);
    Mat_<Point2d> first(60, 1), second(60, 1);
    for (int i = 0; i < 60; ++i)
    {
        first(i) = uniformPoint(rng, 10., 600., 440., 475.);
        second(i) = first(i) + Point2d(3, 0) + gaussianPoint(rng, 0.3);
    }
    const Mat K(twoViewScene(1).K);
    TwoViewPair pair(first, second, K, K);
    const TwoViewGeometry moved = estimateTwoViewGeometry(pair, twoPixels());
    EXPECT_GE(moved.rotations.rows, 3);
    pair.imageSize1 = pair.imageSize2 = Size(SCENE_WIDTH, SCENE_HEIGHT);
    const TwoViewGeometry found = estimateTwoViewGeometry(pair, twoPixels());
    EXPECT_EQ((int)TWO_VIEW_WATERMARK, found.configuration);
    EXPECT_TRUE(found.rotations.empty());
    EXPECT_EQ(0, cv::norm(moved.mask, found.mask));
}

//! 45 % of the matches follow a rotation exactly. The others are shifted in image 2 by 3.35 pixels,
//! which is nearly the threshold of H, more of them to the right than to the left. All are inliers
//! of the homography of this rotation. But the rotation fitted to all of them is closer to those on
//! the right, so that those on the left are not its inliers, and the pair counts as planar. After
//! the rotation of E, `rotations` then contains the only rotation that H allows, even if the
//! determinant of H is negative (`center` 20000).
TEST(Usac_TwoViewGeometry, homography_that_is_a_rotation)
{
    for (double center : {320., 20000.})
    {
        const Matx33d K(600, 0, center, 0, 600, 240, 0, 0, 1);
        Matx33d R;
        Rodrigues(Vec3d(0, -0.05, 0), R);
        RNG rng(5);
        Mat_<Point2d> first(200, 1), second(200, 1);
        for (int i = 0; i < 200; ++i)
        {
            first(i) = uniformPoint(rng, center - 200, center + 200, 0., 480.);
            const Vec3d x = K * R * K.inv() * Vec3d(first(i).x, first(i).y, 1);
            const double shift = i < 90 ? 0 : i < 155 ? 3.35 : -3.35;
            second(i) = Point2d(x[0] / x[2] + shift, x[1] / x[2]);
        }
        Params params = Params::ransac();
        params.threshold = 2;
        params.polishing = POLISHING_NONE;
        params.termination = 0;
        params.maxIterations = 100;
        const TwoViewGeometry found = estimateTwoViewGeometry(
            TwoViewPair(first, second, Mat(K), Mat(K)), params);
        EXPECT_EQ((int)TWO_VIEW_PLANAR, found.configuration) << center;
        EXPECT_EQ(center > 1000, determinant(found.H) < 0);
        ASSERT_EQ(6, found.rotations.rows) << center;
        EXPECT_EQ(0, cv::norm(found.rotations.rowRange(0, 3), found.R)) << center;
        EXPECT_LT(cv::norm(found.rotations.rowRange(3, 6), Mat(R)), 1e-8) << center;
    }
}

}  // namespace
}  // namespace opencv_test
