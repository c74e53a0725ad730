// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/absolute_pose/pose_scenes.hpp"
#include "support/contracts.hpp"

// Tests of solvePnPRansac with the flags of this module, with Params, and with OpenCV's flags.

namespace opencv_test {
namespace {

const UsacV20Method METHODS[] = {USACV20,        USACV20_FAST,     USACV20_ACCURATE, USACV20_PROSAC,
                                 USACV20_MAGSAC, USACV20_PARALLEL, USACV20_AUTO};

PoseScene distortedScene()
{
    PoseSceneOptions options;
    options.coefficients = 5;
    return makePoseScene(options);
}

TEST(Usac_FindPose, is_estimateAbsolutePose)
{
    const PoseScene s = distortedScene();
    for (UsacV20Method method : METHODS)
    {
        Params params = Params::fromMethod(method);
        params.threshold = 3;
        params.confidence = 0.98;
        params.maxIterations = 500;
        Mat mask, rvec, tvec, inliers, R;
        const Mat pose = estimateAbsolutePose(s.object, s.image, s.K, s.distortion, params, mask);
        ASSERT_FALSE(pose.empty());
        for (int form = 0; form < 3; ++form)
        {
            const bool found = form == 0
                                   ? cv::solvePnPRansac(s.object, s.image, s.K, s.distortion, rvec,
                                                        tvec, false, 500, 3, 0.98, inliers, method)
                               : form == 1
                                   ? cv::usacv20::solvePnPRansac(s.object, s.image, s.K,
                                                                 s.distortion, rvec, tvec, false,
                                                                 500, 3, 0.98, inliers, (int)method)
                                   : cv::solvePnPRansac(s.object, s.image, s.K, s.distortion, rvec,
                                                        tvec, inliers, params);
            ASSERT_TRUE(found);
            ASSERT_EQ(Size(1, 3), rvec.size());
            ASSERT_EQ(Size(1, 3), tvec.size());
            ASSERT_EQ(CV_64F, rvec.type());
            ASSERT_EQ(CV_64F, tvec.type());
            Rodrigues(rvec, R);
            EXPECT_LE(cvtest::norm(R, pose.colRange(0, 3), NORM_INF), 1e-12);
            EXPECT_EQ(0, cvtest::norm(tvec, pose.col(3), NORM_INF));
            ASSERT_EQ(CV_32S, inliers.type());
            ASSERT_EQ(countNonZero(mask), (int)inliers.total());
            for (int i = 0; i < inliers.rows; ++i)
            {
                EXPECT_EQ(1, mask.at<uchar>(inliers.at<int>(i)));
                EXPECT_TRUE(i == 0 || inliers.at<int>(i) > inliers.at<int>(i - 1));
            }
        }
    }
}

TEST(Usac_FindPose, flags_of_opencv_are_handed_on)
{
    const PoseScene s = distortedScene();
    for (int flag : {(int)SOLVEPNP_ITERATIVE, (int)SOLVEPNP_EPNP, (int)SOLVEPNP_P3P})
    {
        Mat r[2], t[2], inliers[2];
        setRNGSeed(1);
        const bool theirs = cv::solvePnPRansac(s.object, s.image, s.K, s.distortion, r[0], t[0],
                                               false, 100, 8.f, 0.99, inliers[0], flag);
        setRNGSeed(1);
        const bool ours = cv::usacv20::solvePnPRansac(s.object, s.image, s.K, s.distortion, r[1],
                                                      t[1], false, 100, 8.f, 0.99, inliers[1],
                                                      flag);
        EXPECT_EQ(theirs, ours);
        EXPECT_EQ(0, cvtest::norm(r[0], r[1], NORM_INF));
        EXPECT_EQ(0, cvtest::norm(t[0], t[1], NORM_INF));
        EXPECT_EQ(0, cvtest::norm(inliers[0], inliers[1], NORM_INF));
    }
    Mat r, t, inliers;
    expectException(
        [&]() {
            cv::usacv20::solvePnPRansac(s.object, s.image, s.K, s.distortion, r, t, false, 100, 8.f,
                                        0.99, inliers, 1000);
        },
        "flags");
}

TEST(Usac_FindPose, failure_leaves_the_vectors)
{
    const PoseScene s = makePoseScene();
    const std::vector<Point3d> same(s.object.size(), Point3d(1, 2, 3));
    Vec3d r(1, 2, 3), t(4, 5, 6);
    Mat inliers(3, 1, CV_32S);
    EXPECT_FALSE(cv::solvePnPRansac(same, s.image, s.K, noArray(), r, t, false, 100, 3, 0.99,
                                    inliers, USACV20));
    EXPECT_EQ(Vec3d(1, 2, 3), r);
    EXPECT_EQ(Vec3d(4, 5, 6), t);
    EXPECT_TRUE(inliers.empty());
}

//! With 5 % inliers, 10 samples hardly ever include an all-inlier sample, so that a correct pose
//! can only come from the initial guess. With a wrong guess, the result must not be the correct
//! pose. Vectors that are not three finite numbers must raise an exception.
TEST(Usac_FindPose, guess_is_a_hypothesis)
{
    PoseSceneOptions options;
    options.inlierRatio = 0.05;
    options.size = 400;
    options.coefficients = 4;
    const PoseScene s = makePoseScene(options);
    Vec3d rvec;
    Rodrigues(s.pose.get_minor<3, 3>(0, 0), rvec);
    const Vec3d tvec(s.pose(0, 3), s.pose(1, 3), s.pose(2, 3));
    for (int wrong = 0; wrong < 2; ++wrong)
    {
        Mat r(rvec + Vec3d(0.003, -0.002, 0.002) * (wrong ? 300 : 1), true), t(tvec, true), inliers;
        const bool found = cv::solvePnPRansac(s.object, s.image, s.K, s.distortion, r, t, true, 10,
                                              2, 0.99, inliers, USACV20);
        const bool right = found && cv::norm(Mat(rvec), r) < 0.01;
        EXPECT_EQ(wrong == 0, right);
    }
    Mat r(2, 1, CV_64F, Scalar(0)), t(tvec, true), nan(3, 1, CV_64F, Scalar(NAN));
    const auto call = [&](Mat& a, Mat& b) {
        cv::solvePnPRansac(s.object, s.image, s.K, s.distortion, a, b, true, 10, 2, 0.99, noArray(),
                           USACV20);
    };
    expectException([&]() { call(r, t); }, "rvec");
    expectException([&]() { call(t, r); }, "tvec");
    expectException([&]() { call(nan, t); }, "rvec");
}

TEST(Usac_FindPose, inliers_are_optional)
{
    const PoseScene s = makePoseScene();
    Mat r[2], t[2], inliers;
    for (int without = 0; without < 2; ++without)
        EXPECT_TRUE(cv::solvePnPRansac(
            s.object, s.image, s.K, noArray(), r[without], t[without], false, 500, 3, 0.99,
            without ? (OutputArray)noArray() : (OutputArray)inliers, USACV20));
    EXPECT_EQ(0, cvtest::norm(r[0], r[1], NORM_INF));
    EXPECT_EQ(0, cvtest::norm(t[0], t[1], NORM_INF));
}

}  // namespace
}  // namespace opencv_test
