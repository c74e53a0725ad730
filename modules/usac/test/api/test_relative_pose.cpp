// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

// Tests of estimateRelativePose, which returns the motion of a camera between two views.

namespace opencv_test {
namespace {

TEST(Usac_RelativePose, exact_points)
{
    for (uint64 seed = 1; seed <= 40; ++seed)
    {
        SceneOptions options;
        options.noise = 0;
        options.seed = seed;
        options.motion = (Motion)(seed % 6);
        const Scene scene = makeScene(ESSENTIAL, options);
        Mat R, t, mask;
        RelativePose pose;
        Params params;
        params.threshold = 0.01;  // so small that hardly any wrong match is an inlier
        ASSERT_TRUE(relativePose(scene, params, R, t, mask, pose));
        EXPECT_LT(angleBetween(R, scene.R), 1e-4 * DEGREE) << seed;
        EXPECT_LT(angleBetween(t, scene.t), 1e-3 * DEGREE) << seed;
        EXPECT_NEAR(1, cv::norm(t), 1e-12);
        EXPECT_NEAR(1, determinant(R), 1e-12);
        EXPECT_LT(cv::norm(R * R.t() - Mat::eye(3, 3, CV_64F)), 1e-12);
        EXPECT_EQ(countNonZero(mask), pose.report.inliers);
        for (int i = 0; i < scene.size(); ++i)
            EXPECT_TRUE(!scene.truth[i] || mask.at<uchar>(i)) << seed << " " << i;
        const Matx33d cross(0, -t.at<double>(2), t.at<double>(1), t.at<double>(2), 0,
                            -t.at<double>(0), -t.at<double>(1), t.at<double>(0), 0);
        const Matx33d E = cross * Matx33d(R.ptr<double>()) * (1 / std::sqrt(2.)),
                      own(pose.essential.ptr<double>());
        EXPECT_LT(std::min(cv::norm(E - own), cv::norm(E + own)), 1e-9);
    }
}

//! With noise and wrong matches, the choice among the four motions of E must be that of
//! cv::recoverPose.
TEST(Usac_RelativePose, as_recoverPose)
{
    int differing = 0;
    for (uint64 seed = 1; seed <= 60; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.outliers = 200;
        options.motion = (Motion)(seed % 6);
        const Scene scene = makeScene(ESSENTIAL, options);
        Mat R, t, mask, theirR, theirT;
        RelativePose pose;
        ASSERT_TRUE(relativePose(scene, Params(), R, t, mask, pose));
        Mat theirMask;
        estimateEssential(scene.points1, scene.points2, scene.K, Params(), theirMask);
        recoverPose(pose.essential, scene.points1, scene.points2, scene.K, theirR, theirT,
                    theirMask);
        differing += cv::norm(R, theirR) > 1e-9 || cv::norm(t, theirT) > 1e-9;
        EXPECT_LT(angleBetween(R, scene.R), 2 * DEGREE) << seed;
    }
    EXPECT_EQ(0, differing);
}

//! The distortion of both lenses must be removed exactly, so that exact points give the exact pose.
TEST(Usac_RelativePose, two_cameras_with_lenses)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        RNG rng(seed);
        const Matx33d K1(800, 0, 320, 0, 790, 240, 0, 0, 1), K2(600, 0, 300, 0, 610, 250, 0, 0, 1);
        const std::vector<double> d1 = {-0.3, 0.1, 0.001, -0.001, 0.02},
                                  d2 = {0.1, -0.05, -0.002, 0.001, 0};
        const Vec3d r = uniformVector(rng, -.1, .1);
        const Vec3d t0 = uniformVector(rng, -1., 1.);
        std::vector<Point3d> X;
        for (int i = 0; i < 100; ++i)
            X.push_back(Point3d(uniformVector(rng, Vec3d(-1.5, -1., 4.), Vec3d(1.5, 1., 9.))));
        std::vector<Point2d> x1, x2;
        projectPoints(X, Vec3d(), Vec3d(), K1, d1, x1);
        projectPoints(X, r, t0, K2, d2, x2);
        Mat R, t, mask;
        RelativePose pose;
        Params params;
        params.threshold = 0.01;
        ASSERT_TRUE(estimateRelativePose(x1, x2, K1, d1, K2, d2, params, R, t, mask, pose));
        Matx33d truth;
        Rodrigues(r, truth);
        EXPECT_LT(angleBetween(R, truth), 1e-3 * DEGREE) << seed;
        EXPECT_LT(angleBetween(t, t0), 1e-2 * DEGREE) << seed;
        EXPECT_EQ(100, countNonZero(mask)) << seed;
        EXPECT_EQ(0, pose.behind);
    }
}

//! Moves the points of image 2 of the first `count` matches to the projections of X = -4 x1, where
//! x1 is the point of image 1 in normalized coordinates. X is behind camera 1, but its projection
//! is on the epipolar line of x1.
void moveBehind(Scene& scene, int count)
{
    const Matx33d inverse = scene.K.inv();
    for (int i = 0; i < count; ++i)
    {
        const Vec3d x1 = inverse * Vec3d(scene.points1[i].x, scene.points1[i].y, 1);
        const Vec3d x2 = scene.K * (scene.R * (x1 * -4.) + scene.t);
        scene.points2[i] = Point2d(x2[0] / x2[2], x2[1] / x2[2]);
    }
}

//! A match whose points are on their epipolar lines, but whose 3-D point would be behind a camera,
//! must not be an inlier.
TEST(Usac_RelativePose, points_behind)
{
    SceneOptions options;
    options.noise = 0;
    options.outliers = 0;
    Scene scene = makeScene(ESSENTIAL, options);
    const int behind = 10;
    moveBehind(scene, behind);
    Mat R, t, mask, inliers;
    RelativePose pose;
    Params params;
    estimateEssential(scene.points1, scene.points2, scene.K, params, inliers);
    ASSERT_TRUE(relativePose(scene, params, R, t, mask, pose));
    for (int i = 0; i < scene.size(); ++i)
        EXPECT_EQ(i >= behind, mask.at<uchar>(i) != 0) << i;
    EXPECT_EQ(behind, pose.behind);
    EXPECT_EQ(scene.size(), countNonZero(inliers));
    EXPECT_EQ(scene.size() - behind, pose.report.inliers);
}

//! Independent inliers must be counted among the inliers of the mask: matches that occur twice must
//! count once, and points behind a camera must not count.
TEST(Usac_RelativePose, independentInliers)
{
    SceneOptions options;
    options.noise = 0;
    options.outliers = 0;
    Scene scene = makeScene(ESSENTIAL, options);
    const int size = scene.size(), behind = 10, repeated = 20;
    moveBehind(scene, behind);
    for (int i = 0; i < repeated; ++i)
    {
        scene.points1.push_back(scene.points1[size - 1 - i]);
        scene.points2.push_back(scene.points2[size - 1 - i]);
    }
    Params params;
    params.threshold = 0.01;  // so small that different points count as independent
    Mat R, t, mask;
    RelativePose pose;
    ASSERT_TRUE(relativePose(scene, params, R, t, mask, pose));
    EXPECT_EQ(size + repeated - behind, pose.report.inliers);
    EXPECT_EQ(size - behind, pose.report.independentInliers);
}

//! Half of the points are at infinity, so that noise decides the sign of their depth. Nearly all of
//! these points must count as points in front of the cameras.
TEST(Usac_RelativePose, points_at_infinity)
{
    SceneOptions options;
    options.noise = 0.3;
    options.outliers = 0;
    Scene scene = makeScene(ESSENTIAL, options);
    RNG rng(7);
    const Matx33d H = scene.K * scene.R * scene.K.inv();
    for (int i = 0; i < scene.size(); i += 2)
    {
        const Vec3d x2 = H * Vec3d(scene.points1[i].x, scene.points1[i].y, 1);
        scene.points2[i] = Point2d(x2[0] / x2[2], x2[1] / x2[2]) + gaussianPoint(rng, 0.2);
    }
    Mat R, t, mask;
    RelativePose pose;
    ASSERT_TRUE(relativePose(scene, Params(), R, t, mask, pose));
    EXPECT_GE(countNonZero(mask), scene.size() - 4);
    EXPECT_LE(pose.behind, 2);
    EXPECT_LT(angleBetween(R, scene.R), 0.5 * DEGREE);
}

TEST(Usac_RelativePose, bad_input)
{
    const Scene scene = makeScene(ESSENTIAL);
    Mat R, t, mask;
    RelativePose pose;
    const std::vector<Point2d> few(scene.points1.begin(), scene.points1.begin() + 4);
    EXPECT_FALSE(estimateRelativePose(few, few, scene.K, noArray(), noArray(), noArray(), Params(),
                                      R, t, mask, pose));
    EXPECT_TRUE(R.empty() && t.empty() && pose.essential.empty() && pose.otherR.empty());
    EXPECT_EQ((int)STOP_TOO_FEW_POINTS, pose.report.stop);
    EXPECT_EQ(4, mask.rows);
    EXPECT_EQ(0, countNonZero(mask));
    EXPECT_THROW(estimateRelativePose(few, scene.points2, scene.K, noArray(), noArray(), noArray(),
                                      Params(), R, t, mask, pose),
                 cv::Exception);
    EXPECT_THROW(estimateRelativePose(scene.points1, scene.points2, noArray(), noArray(), noArray(),
                                      noArray(), Params(), R, t, mask, pose),
                 cv::Exception);
    std::vector<Point2d> nan(scene.points1);
    for (size_t i = 0; i < nan.size(); i += 3)
        nan[i].x = NAN;
    ASSERT_TRUE(estimateRelativePose(nan, scene.points2, scene.K, noArray(), noArray(), noArray(),
                                     Params(), R, t, mask, pose));
    for (size_t i = 0; i < nan.size(); i += 3)
        EXPECT_EQ(0, mask.at<uchar>((int)i));
}

}  // namespace
}  // namespace opencv_test
