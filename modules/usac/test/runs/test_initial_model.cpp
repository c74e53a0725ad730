// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/absolute_pose/pose_scenes.hpp"
#include "support/contracts.hpp"

// Tests of Params::initialModel.

namespace opencv_test {
namespace {

class UsacInitialModel : public UsacProblem
{};
INSTANTIATE_TEST_CASE_P(/**/, UsacInitialModel, testing::ValuesIn(TWO_VIEW_PROBLEMS));

Mat runWith(const Scene& scene, const Params& params, Mat& mask, Report& report)
{
    return estimatePoints(scene.problem, scene.points1, scene.points2, params, mask, report);
}

//! The points moved by ten pixels, as from one frame of a video to the next.
std::vector<Point2d> moved(std::vector<Point2d> points)
{
    for (Point2d& point : points)
        point += Point2d(8, 6);
    return points;
}

//! The right model must be found although no right match is within the threshold of the initial
//! model, and eight samples hardly ever contain an all-inlier one. The threshold is 1.5 pixels.
TEST_P(UsacInitialModel, of_the_previous_frame)
{
    int lost = 0;
    for (uint64 seed = 1; seed <= 30; ++seed)
    {
        SceneOptions options;
        options.setSize(150, mapsPoints(problem()) ? 0.2 : 0.4);
        options.seed = seed;
        const Scene scene = makeScene(problem(), options);
        Scene before = scene;
        before.points2 = moved(scene.points2);
        Params params;
        params.threshold = 1.5;
        params.setInitialModel(createUsac(before, params)->fit(noArray(), scene.truth));
        params.maxIterations = 8;
        lost += !(modelError(scene, estimate(scene, params)) < 1.5);
    }
    EXPECT_LE(lost, 1);
}

//! A wrong initial model must not prevent the correct model from being found.
TEST_P(UsacInitialModel, wrong_one_does_no_harm)
{
    const Scene scene = makeScene(problem());
    Params params;
    Mat mask, again;
    Report report, other;
    const Mat model = runWith(scene, params, mask, report);
    ASSERT_FALSE(model.empty());
    RNG rng(3);
    for (int trial = 0; trial < 10; ++trial)
    {
        Mat wrong(model.size(), CV_64F);
        rng.fill(wrong, RNG::NORMAL, 0, 1);
        params.setInitialModel(wrong);
        ASSERT_FALSE(runWith(scene, params, again, other).empty());
        EXPECT_GE(other.inliers, 0.95 * report.inliers);
    }
}

//! The initial model fits another motion and has already been optimized. A model computed from a
//! sample of true matches often has a higher cost until it is optimized itself. The true model must
//! be found nevertheless.
TEST(Usac_InitialModel, of_another_motion_does_not_hide_the_right_one)
{
    int missed[2] = {0, 0};
    double samples[2] = {0, 0};
    for (uint64 seed = 1; seed <= 40; ++seed)
    {
        SceneOptions options;
        options.setSize(300, 0.4);
        options.outlierModel = OUTLIERS_PLANE;
        options.structured = 90;
        options.seed = seed;
        const Scene scene = makeScene(HOMOGRAPHY, options);
        std::vector<Point2d> other1, other2;
        for (int i = 0; i < scene.size(); ++i)
            if (!scene.truth[i])
            {
                other1.push_back(scene.points1[i]);
                other2.push_back(scene.points2[i]);
            }
        Params params = Params::fast();
        params.maxIterations = 100000;
        for (int with = 0; with < 2; ++with)
        {
            if (with)
                params.setInitialModel(estimateHomography(other1, other2, Params()));
            Report report;
            missed[with] += !(modelError(scene, estimate(scene, params, noArray(), &report)) < 1.5);
            samples[with] += report.iterations;
        }
    }
    // 11 of 40 runs would fail if only a model with a lower cost than the initial model were
    // optimized
    EXPECT_LE(missed[1], missed[0] + 2);
    EXPECT_LE(samples[1], 1.5 * samples[0]);
}

TEST_P(UsacInitialModel, mistakes_are_named)
{
    const Scene scene = makeScene(problem());
    Mat mask;
    Report report;
    for (int mistake = 0; mistake < 4; ++mistake)
    {
        Params params;
        params.initialModel.assign(mistake == 0   ? 5
                                   : mistake == 1 ? 13
                                                  : 9,
                                   mistake == 2 ? NAN : 0.);
        if (mistake == 3)
            params.initialModel.assign(9, INFINITY);
        expectException([&]() { runWith(scene, params, mask, report); }, "initialModel");
    }
    Params params;
    expectException([&]() { params.setInitialModel(Mat(3, 3, CV_64FC2)); }, "model");
    params.setInitialModel(Matx33f::eye());
    EXPECT_EQ(9u, params.initialModel.size());
    params.setInitialModel(noArray());
    EXPECT_TRUE(params.initialModel.empty());
}

//! A matrix that is transposed or has another wrong shape must be refused, because its numbers
//! would be read in a wrong order, and the previous initial model must be kept.
TEST(Usac_InitialModel, shapes)
{
    Params params;
    params.setInitialModel(Mat::eye(3, 3, CV_64F), Mat::eye(8, 8, CV_64F));
    const Params before = params;
    for (const Size& size : {Size(2, 3), Size(3, 4), Size(2, 6), Size(6, 2)})
    {
        const Mat wrong = Mat::ones(size, CV_64F);
        expectException([&]() { params.setInitialModel(wrong); }, "model: ");
    }
    for (const Size& size : {Size(64, 1), Size(1, 64), Size(8, 7), Size(4, 16)})
    {
        const Mat wrong = Mat::ones(size, CV_64F);
        expectException([&]() { params.setInitialModel(Mat::eye(3, 3, CV_64F) * 2, wrong); },
                        "covariance: ");
    }
    EXPECT_EQ(before.initialModel, params.initialModel);
    EXPECT_EQ(before.initialCovariance, params.initialCovariance);
    const Mat right = Mat(Matx23d(1, 2, 3, 4, 5, 6));
    for (const Mat& given : {right, right.reshape(1, 1), right.reshape(1, 6)})
    {
        params.setInitialModel(given);
        EXPECT_EQ(std::vector<double>({1, 2, 3, 4, 5, 6}), params.initialModel);
    }
    params.setInitialModel(Mat::ones(3, 4, CV_32F));
    EXPECT_EQ(12u, params.initialModel.size());
    params.setInitialModel(Mat::ones(2, 2, CV_64F));  // a model of a custom problem
    EXPECT_EQ(4u, params.initialModel.size());
}

}  // namespace
}  // namespace opencv_test
