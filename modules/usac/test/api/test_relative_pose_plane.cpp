// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

// Tests of estimateRelativePose with points on a plane, which two motions explain.

namespace opencv_test {
namespace {

//! 90 % of the true matches are on a plane, which is compatible with two motions. The points off
//! the plane must select the correct motion in at least 90 % of the scenes. In at least 80 %, the
//! other motion of the plane must be reported in `otherR` and `otherT`.
void checkPlanes(const Params& params)
{
    int right = 0, other = 0, scenes = 0;
    for (uint64 seed = 1; seed <= 40; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.outliers = 60;
        options.planeFraction = 0.9;
        const Scene scene = makeScene(ESSENTIAL, options);
        Mat R, t, mask;
        RelativePose pose;
        ASSERT_TRUE(relativePose(scene, params, R, t, mask, pose));
        ++scenes;
        right += angleBetween(R, scene.R) < 2 * DEGREE && angleBetween(t, scene.t) < 15 * DEGREE;
        if (pose.otherR.empty())
            continue;
        ++other;
        EXPECT_GT(pose.onPlane, 0.8 * 150) << seed;
        EXPECT_NEAR(1, determinant(pose.otherR), 1e-9);
        EXPECT_NEAR(1, cv::norm(pose.otherT), 1e-9);
        EXPECT_GT(pose.otherInliers, 0.4 * pose.report.inliers) << seed;
        EXPECT_LE(pose.otherInliers, pose.report.inliers) << seed;
        EXPECT_GT(cv::norm(pose.otherR, R) + cv::norm(pose.otherT, t), 0.05) << seed;
    }
    EXPECT_GE(right, 0.9 * scenes);
    EXPECT_GE(other, 0.8 * scenes);
}

TEST(Usac_RelativePosePlane, planes) { checkPlanes(Params()); }

//! Like the test `planes`, but with an estimated threshold: the search for the plane must use the
//! estimated threshold instead of Params::threshold.
TEST(Usac_RelativePosePlane, planesWithEstimatedThreshold)
{
    Params params = Params::automatic();
    params.threshold = 15;
    checkPlanes(params);
}

//! All true matches are on one plane, so that either of the two motions that are compatible with
//! the plane can be returned. The correct motion must be the returned one or the one in `otherR`
//! and `otherT`.
TEST(Usac_RelativePosePlane, nothing_but_a_plane)
{
    int either = 0;
    for (uint64 seed = 1; seed <= 40; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.noise = 0.2;
        options.outliers = 60;
        options.planeFraction = 1;
        const Scene scene = makeScene(ESSENTIAL, options);
        Mat R, t, mask;
        RelativePose pose;
        ASSERT_TRUE(relativePose(scene, Params(), R, t, mask, pose));
        bool found = angleBetween(R, scene.R) < 2 * DEGREE &&
                     angleBetween(t, scene.t) < 15 * DEGREE;
        if (!pose.otherR.empty())
            found = found || (angleBetween(pose.otherR, scene.R) < 2 * DEGREE &&
                              angleBetween(pose.otherT, scene.t) < 15 * DEGREE);
        either += found;
    }
    EXPECT_EQ(40, either);
}

//! If the second motion of a plane is returned, then covariance and noise in the report must be
//! those of this motion, as Usac::refine returns them, and not those of the model that the search
//! found. The mask must be that of the reported threshold.
TEST(Usac_RelativePosePlane, reportDescribesTheReturnedMotion)
{
    int replaced = 0, compared = 0, similar = 0;
    for (int i = 0; i < 120; ++i)
    {
        SceneOptions options;
        options.seed = 1 + i / 2;
        options.noise = 0.3;
        options.outliers = 60;
        options.planeFraction = 0.99;
        const Scene scene = makeScene(ESSENTIAL, options);
        Params params = i % 2 ? Params::automatic() : Params();
        params.threshold = i % 2 ? 6 : 1.5;
        params.covariance = true;
        Mat R, t, mask;
        RelativePose pose;
        ASSERT_TRUE(relativePose(scene, params, R, t, mask, pose));
        const Ptr<Usac> usac = Usac::create(ESSENTIAL, scene.points1, scene.points2, params,
                                            scene.K);
        Mat inliers;
        Report search, refined;
        const Mat E = usac->run(inliers, &search);
        const bool other = cvtest::norm(E, pose.essential, NORM_INF) > 1e-9;
        EXPECT_EQ(search.threshold, pose.report.threshold);
        const Mat errors = usac->errors(pose.essential);
        int within = 0;
        for (int k = 0; k < errors.rows; ++k)
        {
            const bool near = errors.at<double>(k) <= pose.report.threshold;
            within += near;
            EXPECT_TRUE(near || !mask.at<uchar>(k)) << i << " " << k;
        }
        EXPECT_EQ(within, pose.report.inliers + pose.behind) << i;
        EXPECT_LE(pose.report.independentInliers, pose.report.inliers) << i;
        EXPECT_GT(pose.report.independentInliers, 0.8 * pose.report.inliers) << i;
        EXPECT_EQ(other ? std::vector<int>() : search.sample, pose.report.sample) << i;
        EXPECT_NO_THROW(covarianceOfPose(pose.essential, pose.report.covariance, R, t));
        if (!other)
        {
            EXPECT_EQ(0, cvtest::norm(search.covariance, pose.report.covariance, NORM_INF));
            continue;
        }
        ++replaced;
        usac->refine(pose.essential, noArray(), inliers, &refined);
        EXPECT_NEAR(refined.sigma, pose.report.sigma, 0.05 * refined.sigma) << i;
        // A second refinement changes the model a little, and sometimes one of the few inliers off
        // the plane. An undetermined covariance is NaN.
        if (cv::checkRange(search.covariance) && cv::checkRange(refined.covariance))
        {
            ++compared;
            similar += cvtest::norm(refined.covariance, pose.report.covariance, NORM_L2) <
                       0.5 * cvtest::norm(search.covariance, pose.report.covariance, NORM_L2);
        }
    }
    EXPECT_GE(replaced, 10);
    EXPECT_GE(compared, 10);
    EXPECT_GE(similar, 0.9 * compared) << compared;
}

//! A scene in which 95 % of the true matches are on a plane.
Scene nearlyPlanar(double noise)
{
    SceneOptions options;
    options.noise = noise;
    options.outliers = 60;
    options.planeFraction = 0.95;
    return makeScene(ESSENTIAL, options);
}

//! Without a time limit, the plane of the scene is found. If the time is over before the plane is
//! searched for, the report must say so, and there must be no plane and no second motion.
TEST(Usac_RelativePosePlane, stopped)
{
    const Scene scene = nearlyPlanar(0.3);
    Mat R, t;
    RelativePose pose;
    ASSERT_TRUE(relativePose(scene, Params(), R, t, noArray(), pose));
    ASSERT_GT(pose.onPlane, 0);
    Params params;
    params.maxTime = 1e-3;
    relativePose(scene, params, R, t, noArray(), pose);
    EXPECT_EQ((int)STOP_TIME, pose.report.stop);
    EXPECT_EQ(0, pose.onPlane);
    EXPECT_TRUE(pose.otherR.empty());
}

//! If a run is canceled during the search for the plane, the report must say so, and the motion of
//! E must be returned. The progress function recognizes this second search by Report::setupMs,
//! which does not change within a search.
TEST(Usac_RelativePosePlane, canceledInTheSearchForThePlane)
{
    SceneOptions options;
    options.noise = 0.3;
    options.setSize(200000, 0.9);
    options.planeFraction = 0.95;
    const Scene scene = makeScene(ESSENTIAL, options);
    double setup = 0;
    bool canceled = false;
    Mat R, t, mask;
    RelativePose pose;
    {
        const ProgressScope scope([&](const Report& report) {
            canceled = canceled || (setup > 0 && report.setupMs != setup);
            setup = report.setupMs;
            return !canceled;
        });
        EXPECT_TRUE(relativePose(scene, Params(), R, t, mask, pose));
    }
    ASSERT_TRUE(canceled);
    EXPECT_EQ((int)STOP_CANCELLED, pose.report.stop);
    EXPECT_EQ(0, pose.onPlane);
    EXPECT_TRUE(pose.otherR.empty());
    EXPECT_GT(countNonZero(mask), scene.size() / 2);
    EXPECT_LT(angleBetween(R, scene.R), DEGREE);
}

//! The baseline is so short that the parallax between near and far points is only a few pixels.
//! Three quarters of the matches (sigma 0.1 pixels) are precise enough to show that the points are
//! not on a plane; the others (sigma 10 pixels) are not. If one threshold, wide enough for the
//! imprecise matches, were used for all of them, the scene would count as a plane.
TEST(Usac_RelativePosePlane, planeWithSigmas)
{
    for (int numbers : {1, 3, 6})
    {
        SceneOptions options;
        options.noise = 0;
        options.outliers = 0;
        options.baseline = 0.05;
        Scene scene = makeScene(ESSENTIAL, options);
        RNG rng(3);
        Params params;
        params.threshold = 3;
        for (int i = 0; i < scene.size(); ++i)
        {
            const double sigma = i % 4 ? 0.1 : 10;
            scene.points2[i] += gaussianPoint(rng, sigma);
            if (numbers == 1)
                params.sigmas.push_back((float)sigma);
            for (int k = 0; k < numbers / 3; ++k)
            {
                const float variance = k ? 0.f : (float)(sigma * sigma);
                const float values[] = {variance, 0, variance};
                params.sigmas.insert(params.sigmas.end(), values, values + 3);
            }
        }
        Mat R, t, mask;
        RelativePose pose;
        ASSERT_TRUE(relativePose(scene, params, R, t, mask, pose));
        EXPECT_EQ(0, pose.onPlane) << numbers;
        EXPECT_TRUE(pose.otherR.empty()) << numbers;
    }
}

//! No sigmas, equal sigmas and equal covariances of both images describe the same noise, and must
//! give the same plane, with a difference of at most one inlier. Sigmas that include 1e-6, the
//! smallest accepted value, must raise no exception, although the search for the plane divides all
//! sigmas by their mean of 1.5 and thus makes this one even smaller.
TEST(Usac_RelativePosePlane, planeWithEqualNoiseInAllForms)
{
    const Scene scene = nearlyPlanar(0.3);
    std::vector<int> planes;
    for (int numbers : {0, 1, 6})
    {
        Params params;
        for (int i = 0; i < scene.size() && numbers > 0; ++i)
            for (int k = 0; k < numbers; ++k)
                params.sigmas.push_back(k % 3 == 1 ? 0.f : 1.f);
        Mat R, t;
        RelativePose pose;
        ASSERT_TRUE(relativePose(scene, params, R, t, noArray(), pose));
        planes.push_back(pose.onPlane);
    }
    EXPECT_GT(planes[0], 0);
    EXPECT_NEAR(planes[0], planes[1], 1);
    EXPECT_NEAR(planes[0], planes[2], 1);
    Params params;
    for (int i = 0; i < scene.size(); ++i)
        params.sigmas.push_back(i % 2 ? 1e-6f : 3.f);
    Mat R, t;
    RelativePose pose;
    EXPECT_NO_THROW(relativePose(scene, params, R, t, noArray(), pose));
}

//! The homography of a dominant plane is compatible with two motions. The second motion is refined
//! with all points. If so many points are off the plane that this refinement ends at the first
//! motion, there is only one motion to report.
TEST(Usac_RelativePosePlane, second_motion_that_is_the_first)
{
    int alone = 0;
    for (uint64 seed = 1; seed <= 30; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.inliers = 100;
        options.outliers = 30;
        options.noise = 0;
        options.planeFraction = 0.8;
        const Scene scene = makeScene(ESSENTIAL, options);
        Mat R, t, mask;
        RelativePose pose;
        ASSERT_TRUE(relativePose(scene, Params(), R, t, mask, pose));
        alone += pose.onPlane > 0 && pose.otherR.empty();
        if (pose.otherR.empty())
        {
            EXPECT_TRUE(pose.otherT.empty()) << seed;
            EXPECT_EQ(0, pose.otherInliers) << seed;
        }
        else
            EXPECT_GT(cv::norm(pose.otherR, R) + cv::norm(pose.otherT, t), 0.05) << seed;
    }
    EXPECT_GT(alone, 0);
}

//! Five random matches that fit some E, but for which no homography is found, not even with the
//! doubled threshold that is used to find planes, because the orientation check rejects each sample
//! of four of them. There must be no plane and no second motion.
TEST(Usac_RelativePosePlane, no_plane_at_all)
{
    const Matx33d K(600, 0, 320, 0, 600, 240, 0, 0, 1);
    int without = 0;
    for (uint64 seed = 1; seed <= 50; ++seed)
    {
        RNG rng(seed);
        std::vector<Point2d> points1, points2;
        for (int i = 0; i < 5; ++i)
        {
            points1.push_back(uniformPoint(rng, 0., 640., 0., 480.));
            points2.push_back(uniformPoint(rng, 0., 640., 0., 480.));
        }
        Params params;
        params.significance = 1;
        Mat R, t, mask;
        RelativePose pose;
        const bool found = estimateRelativePose(points1, points2, K, noArray(), noArray(),
                                                noArray(), params, R, t, mask, pose);
        params.threshold *= 2;
        if (!found || !estimateHomography(points1, points2, params).empty())
            continue;
        ++without;
        EXPECT_EQ(5, pose.report.inliers + pose.behind) << seed;
        EXPECT_EQ(0, pose.onPlane) << seed;
        EXPECT_TRUE(pose.otherR.empty() && pose.otherT.empty()) << seed;
    }
    EXPECT_GT(without, 0);
}

}  // namespace
}  // namespace opencv_test
