// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "contracts/pose_contracts.hpp"
#include "support/params_fields.hpp"

// Tests of absolute poses with difficult points, cameras and lenses, and with every option.

namespace opencv_test {
namespace {

const double FAR = 1e300, TINY = 1e-310;

PoseSceneOptions optionsOf(int coefficients)
{
    PoseSceneOptions options;
    options.size = 120;
    options.coefficients = coefficients;
    return options;
}

//! The scene with `rows` additional rows, in which some coordinates are `value`.
PoseScene withRows(int coefficients, double value, int rows)
{
    PoseScene scene = makePoseScene(optionsOf(coefficients));
    RNG rng(5);
    for (int i = 0; i < rows; ++i)
    {
        Point3d X = Point3d(uniformVector(rng, -2., 2.));
        Point2d x = uniformPoint(rng, 0., 640., 0., 480.);
        double* const numbers[] = {&X.x, &X.y, &X.z, &x.x, &x.y};
        for (int k = 0; k < 5; ++k)
            if (i % 6 == k || (i % 6 == 5 && k > 2))
                *numbers[k] = value;
        const int row = (i * 7) % scene.size();
        scene.object.insert(scene.object.begin() + row, X);
        scene.image.insert(scene.image.begin() + row, x);
    }
    return scene;
}

TEST(Usac_PoseHostile, some_rows_of_any_number)
{
    const double values[] = {NAN,   INFINITY, -INFINITY, 0,    TINY, 5e-324,
                             1e-30, 1e10,     -1e18,     1e30, FAR,  -DBL_MAX};
    for (double value : values)
        for (int coefficients : {0, 5})
            for (int rows : {1, 30, 60})
            {
                SCOPED_TRACE(
                    cv::format("%d rows of %g, %d coefficients", rows, value, coefficients));
                const PoseScene scene = withRows(coefficients, value, rows);
                Mat mask;
                Report report;
                const Mat pose = checkedPose(scene, Params(), mask, report);
                ASSERT_FALSE(pose.empty());
                EXPECT_LT(rotationError(scene, Matx34d(pose)), 1);
                EXPECT_LT(centerError(scene, Matx34d(pose)), 0.05);
            }
}

TEST(Usac_PoseHostile, some_rows_of_any_number_with_every_preset)
{
    for (double value : {(double)NAN, (double)INFINITY, 1e18, FAR, TINY})
    {
        SCOPED_TRACE(value);
        checkEveryWay(withRows(value == FAR ? 0 : 8, value, 40));
    }
}

TEST(Usac_PoseHostile, all_rows_of_one_number)
{
    for (double value : {(double)NAN, (double)INFINITY, 0., TINY, 1., 1e18, FAR})
        for (int which = 0; which < 5; ++which)
        {
            SCOPED_TRACE(cv::format("coordinate %d is %g", which, value));
            PoseScene scene = makePoseScene(optionsOf(which % 2 ? 4 : 0));
            for (int i = 0; i < scene.size(); ++i)
            {
                double* const numbers[] = {&scene.object[i].x, &scene.object[i].y,
                                           &scene.object[i].z, &scene.image[i].x,
                                           &scene.image[i].y};
                *numbers[which] = value;
            }
            checkEveryWay(scene, 2, 30);
        }
}

TEST(Usac_PoseHostile, object_of_any_size)
{
    for (double scale : {1e-290, 1e-150, 1e-75, 1e-30, 1e-10, 1e10, 1e30, 1e75, 1e150, 1e290})
        for (int coefficients : {0, 5})
        {
            SCOPED_TRACE(cv::format("scale %g, %d coefficients", scale, coefficients));
            PoseSceneOptions options = optionsOf(coefficients);
            PoseScene scene = makePoseScene(options);
            for (Point3d& X : scene.object)
                X *= scale;
            const std::vector<Mat> poses = checkEveryWay(scene, 2, 30);
            for (size_t i = 0; i < poses.size() && scale > 1e-80 && scale < 1e80; ++i)
                EXPECT_FALSE(poses[i].empty()) << i;
        }
}

//! Image coordinates, camera matrix and threshold are given in a unit other than pixels. The pose
//! must be found nevertheless.
TEST(Usac_PoseHostile, image_of_any_size)
{
    for (double scale : {1e-30, 1e-10, 1e10, 1e30})
        for (int coefficients : {0, 5})
        {
            SCOPED_TRACE(cv::format("scale %g, %d coefficients", scale, coefficients));
            PoseScene scene = makePoseScene(optionsOf(coefficients));
            for (Point2d& x : scene.image)
                x *= scale;
            scene.K = scene.K * scale;
            scene.K(2, 2) = 1;
            for (const Mat& pose : checkEveryWay(scene, 2 * scale, 30))
                EXPECT_FALSE(pose.empty());
        }
}

//! The object is so far from the origin that coordinates lose digits. With an offset of up to 1e9,
//! the default preset must find the pose; all results must satisfy all contracts.
TEST(Usac_PoseHostile, object_far_from_its_origin)
{
    for (double offset : {1e3, 1e6, 1e9, 1e12, 1e15})
    {
        SCOPED_TRACE(offset);
        PoseSceneOptions options = optionsOf(4);
        options.offset = Vec3d(offset, -offset / 3, offset / 7);
        const std::vector<Mat> poses = checkEveryWay(makePoseScene(options), 2, 30);
        EXPECT_TRUE(offset > 1e9 || !poses[0].empty());
    }
}

TEST(Usac_PoseHostile, every_shape_with_every_preset)
{
    for (int shape = POSE_CLOUD; shape <= POSE_CLUSTER; ++shape)
        for (double noise : {0., 0.5})
        {
            SCOPED_TRACE(cv::format("shape %d, noise %g", shape, noise));
            PoseSceneOptions options = optionsOf(shape % 2 ? 12 : 0);
            options.shape = (PoseShape)shape;
            options.noise = noise;
            options.behind = 10;
            options.atCenter = 5;
            options.copies = 1 + shape % 2;
            checkEveryWay(makePoseScene(options));
        }
}

//! Numbers of points from none to more than a minimal sample. All results must satisfy all
//! contracts.
TEST(Usac_PoseHostile, few_points)
{
    for (int size = 0; size <= 8; ++size)
        for (int coefficients : {0, 5})
        {
            SCOPED_TRACE(cv::format("%d points, %d coefficients", size, coefficients));
            PoseScene scene = makePoseScene(optionsOf(coefficients));
            scene.object.resize(size);
            scene.image.resize(size);
            checkEveryWay(scene);
        }
}

//! Random lenses, many of which fold the image, have poles or show no point. For odd `i`, half of
//! the image points are random and the others are those of a camera without distortion; for even
//! `i`, all are made with the lens. The result must be consistent with the lens.
TEST(Usac_PoseHostile, wild_lenses)
{
    const int lengths[] = {4, 5, 8, 12, 14};
    RNG rng(3);
    int found = 0;
    for (int i = 0; i < 200; ++i)
    {
        SCOPED_TRACE(i);
        PoseScene scene = makePoseScene(optionsOf(0));
        scene.distortion.resize(lengths[i % 5]);
        for (double& d : scene.distortion)
            d = rng.uniform(-1., 1.) * std::pow(10., rng.uniform(-3., i % 10 == 0 ? 20. : 1.));
        for (int row = 0; row < scene.size() / 2; ++row)
            scene.image[row] = uniformPoint(rng, -3000., 3000.);
        scene.image = i % 2 ? scene.image : project(scene, scene.pose, scene.object);
        Params params;
        params.maxIterations = 50;
        Mat mask;
        Report report;
        found += !checkedPose(scene, params, mask, report).empty();
    }
    EXPECT_GT(found, 50);
}

//! All pairs of values of two of the listed options, with the defaults of the other listed options.
//! Each accepted combination must find a pose that satisfies all contracts. Combinations that
//! Params::check() refuses are skipped.
TEST(Usac_PoseHostile, every_option)
{
    const struct
    {
        const char* field;
        int values;
        bool bits;
    } options[] = {{"sampler", 5, false},           {"quality", 6, false},
                   {"localOptimization", 7, false}, {"polishing", 4, false},
                   {"verification", 3, false},      {"termination", 5, true},
                   {"ordering", 4, false},          {"neighborhood", 3, false}};
    const int fields = sizeof(options) / sizeof(options[0]);
    int tried = 0;
    for (int coefficients : {0, 5})
    {
        const PoseScene scene = makePoseScene(optionsOf(coefficients));
        for (int a = 0; a < fields; ++a)
            for (int b = a + 1; b < fields; ++b)
                for (int k = 0; k < options[a].values * options[b].values; ++k)
                {
                    const int x = k % options[a].values, y = k / options[a].values;
                    SCOPED_TRACE(cv::format("option %d: %d, option %d: %d", a, x, b, y));
                    Params params;
                    Assignment(params, options[a].field, options[a].bits ? 1 << x : x);
                    Assignment(params, options[b].field, options[b].bits ? 1 << y : y);
                    params.maxIterations = 50;
                    if (k % 2 || params.sampler == SAMPLER_IMPORTANCE)
                        for (float score : scene.scores)
                            params.scores.push_back(1 - score);
                    params.scoreOrder = SCORES_HIGHER_IS_BETTER;
                    try
                    {
                        params.check(scene.size());
                    }
                    catch (const cv::Exception&)
                    {
                        continue;
                    }
                    ++tried;
                    Mat mask;
                    Report report;
                    EXPECT_FALSE(checkedPose(scene, params, mask, report).empty());
                }
    }
    EXPECT_GT(tried, 800);
}

//! The oracle brokenResult() must detect a wrong row of the mask and a wrong pose, because the
//! tests that use this oracle would otherwise be worthless.
TEST(Usac_PoseHostile, oracle_sees_what_is_wrong)
{
    for (int coefficients : {0, 4, 8, 14})
    {
        const PoseScene scene = makePoseScene(optionsOf(coefficients));
        Mat mask;
        Report report;
        Mat pose = checkedPose(scene, Params(), mask, report);
        const EstimatorCall call = callOf(scene, Params());
        for (int row = 0; row < mask.rows; ++row)
        {
            Mat wrong = mask.clone();
            wrong.at<uchar>(row) ^= 1;
            report.inliers = countNonZero(wrong);
            EXPECT_NE("", brokenResult(call, pose, wrong, report)) << "row " << row;
        }
        report.inliers = countNonZero(mask);
        Mat other = pose.clone();
        other.colRange(0, 3) *= 1 + 1e-8;
        EXPECT_NE("", brokenResult(call, other, mask, report)) << "no rotation";
        other = -pose;
        EXPECT_NE("", brokenResult(call, other, mask, report)) << "behind the camera";
        other = pose.clone();
        other.at<double>(1, 3) = NAN;
        EXPECT_NE("", brokenResult(call, other, mask, report));
    }
}

}  // namespace
}  // namespace opencv_test
