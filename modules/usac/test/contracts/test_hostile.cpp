// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"

// Tests with few or many difficult points: far away, with tiny coordinates, on a line, or all with
// the same corresponding point.

namespace opencv_test {
namespace {

typedef UsacProblem UsacHostile;
INSTANTIATE_TEST_CASE_P(/**/, UsacHostile, testing::ValuesIn(TWO_VIEW_PROBLEMS));

Point2d randomPixel(RNG& rng) { return uniformPoint(rng, 0., 640., 0., 480.); }

//! The default scene with `rows` additional matches, in which some coordinates are `value` or
//! -`value`.
Scene withRows(ProblemType problem, double value, int rows)
{
    Scene scene = makeScene(problem);
    RNG rng(5);
    for (int i = 0; i < rows; ++i)
    {
        Point2d p = randomPixel(rng), q = randomPixel(rng);
        if (i % 3 == 0)
            p.x = value;
        else if (i % 3 == 1)
            q = Point2d(value, -value);
        else
            p.y = q.x = value;
        const int row = (i * 7) % scene.size();
        scene.points1.insert(scene.points1.begin() + row, p);
        scene.points2.insert(scene.points2.begin() + row, q);
    }
    return scene;
}

TEST_P(UsacHostile, rows_far_out_do_not_spoil_the_others)
{
    const Scene clean = makeScene(problem());
    const double values[] = {1e6, 1e10, -1e18, 1e30, 1.7e308, -1.7e308};
    const int rows[] = {1, 10, 50, 120};
    for (int v = 0; v < 6; ++v)
        for (int r = 0; r < 4; ++r)
        {
            SCOPED_TRACE(cv::format("%d rows of %g", rows[r], values[v]));
            const Scene scene = withRows(problem(), values[v], rows[r]);
            Mat mask;
            Report report;
            const Mat model = estimatePoints(problem(), scene.points1, scene.points2, Params(),
                                             mask, report);
            EXPECT_LT(modelError(clean, model), 0.8);
            checkResult(problem(), scene.points1, scene.points2, Params().threshold, model, mask,
                        report);
        }
    const Scene scene = withRows(problem(), 1e30, 60);
    checkEveryWay(problem(), scene.points1, scene.points2);
}

TEST_P(UsacHostile, denormals)
{
    const Scene clean = makeScene(problem()), scene = withRows(problem(), 1e-310, 40);
    const std::vector<Mat> models = checkEveryWay(problem(), scene.points1, scene.points2);
    EXPECT_LT(modelError(clean, models[0]), 0.8);
    std::vector<Point2d> tiny1 = clean.points1, tiny2 = clean.points2;
    for (size_t i = 0; i < tiny1.size(); ++i)
    {
        tiny1[i] *= 1e-310;
        tiny2[i] *= 1e-310;
    }
    checkEveryWay(problem(), tiny1, tiny2);
    checkEveryWay(problem(), tiny1, clean.points2);
}

//! Points, threshold and camera matrix are scaled by the same factor. A model must be found at
//! every scale.
TEST_P(UsacHostile, scales)
{
    const double scales[] = {1e-75, 1e-30, 1e-10, 1e10, 1e30, 1e75};
    for (int s = 0; s < 6; ++s)
    {
        SCOPED_TRACE(cv::format("scale %g", scales[s]));
        Scene scene = makeScene(problem());
        for (int i = 0; i < scene.size(); ++i)
        {
            scene.points1[i] *= scales[s];
            scene.points2[i] *= scales[s];
        }
        Matx33d K = scene.K * scales[s];
        K(2, 2) = 1;
        Params params;
        params.threshold *= scales[s];
        Mat mask;
        Report report;
        const Mat model = estimatePoints(problem(), scene.points1, scene.points2, params, mask,
                                         report, K);
        ASSERT_FALSE(model.empty());
        checkResult(problem(), scene.points1, scene.points2, params.threshold, model, mask, report,
                    K);
        EXPECT_GT(report.inliers, 150);
    }
}

//! The singular values of the model in normalized coordinates, in which the points have unit scale;
//! the model has unit norm.
Vec3d singularValues(ProblemType problem, const std::vector<Point2d>& points1,
                     const std::vector<Point2d>& points2, const Mat& model)
{
    const Matx33d M = toInternal(Usac::create(problem, points1, points2)->points(),
                                 Matx33d(model.ptr<double>()));
    Vec3d w;
    SVD::compute(M, w, SVD::NO_UV);
    return w;
}

//! For any line l2, the matrix l2 l1^T of rank 1 is consistent with all matches whose point in
//! image 1 is on the line l1, but it is not a fundamental matrix. Although most points of image 1
//! are on a line here, an F of rank 1 must not be returned.
TEST(Usac_Hostile, most_points_of_one_image_on_a_line)
{
    const double lines[] = {0, 300, 1e6};
    for (int k = 0; k < 3; ++k)
    {
        SCOPED_TRACE(cv::format("x = %g", lines[k]));
        Scene scene = makeScene(FUNDAMENTAL);
        RNG rng(5);
        for (int i = 0; i < 450; ++i)
        {
            scene.points1.push_back(Point2d(lines[k], rng.uniform(0., 480.)));
            scene.points2.push_back(randomPixel(rng));
        }
        const std::vector<Mat> models = checkEveryWay(FUNDAMENTAL, scene.points1, scene.points2);
        for (size_t i = 0; i < models.size(); ++i)
            if (!models[i].empty())
            {
                const Vec3d w = singularValues(FUNDAMENTAL, scene.points1, scene.points2,
                                               models[i]);
                EXPECT_GT(w[1], 1e-7 * w[0]) << allPresets()[i].name;
            }
    }
}

//! The singular matrix that maps the whole plane to one point has the most inliers here, but it is
//! not a homography and must not be returned.
TEST(Usac_Hostile, most_matches_share_one_target)
{
    Scene scene = makeScene(HOMOGRAPHY);
    RNG rng(5);
    for (int i = 0; i < 500; ++i)
    {
        scene.points1.push_back(randomPixel(rng));
        scene.points2.push_back(Point2d(320, 100));
    }
    const std::vector<Mat> models = checkEveryWay(HOMOGRAPHY, scene.points1, scene.points2);
    for (size_t i = 0; i < models.size(); ++i)
        if (!models[i].empty())
        {
            const Vec3d w = singularValues(HOMOGRAPHY, scene.points1, scene.points2, models[i]);
            EXPECT_GT(w[0] * w[1] * w[2], 1e-10) << allPresets()[i].name;
        }
    checkEveryWay(HOMOGRAPHY, scene.points2, scene.points1);
    const std::vector<Point2d> one(scene.points1.size(), Point2d(320, 100));
    const std::vector<Mat> none = checkEveryWay(HOMOGRAPHY, scene.points1, one);
    for (size_t i = 0; i < none.size(); ++i)
        EXPECT_TRUE(none[i].empty()) << allPresets()[i].name;
}

//! Both epipoles are at the origin, so that only two entries of the exact F are not 0. At the
//! larger scales, in pixel coordinates, rounding errors of the other entries can be larger than
//! these two entries, and could give F rank 3. The returned F must have rank 2.
TEST(Usac_Hostile, exact_forward_motion_has_rank_two)
{
    const double scales[] = {1, 1e3, 1e6};
    for (int s = 0; s < 3; ++s)
    {
        SCOPED_TRACE(cv::format("scale %g", scales[s]));
        RNG rng(3);
        std::vector<Point2d> points1, points2;
        for (int i = 0; i < 120; ++i)
        {
            const Point2d p = uniformPoint(rng, -1200., 1200., -900., 900.);
            const double depth = rng.uniform(4., 8.);
            points1.push_back(p * (scales[s] / depth));
            points2.push_back(p * (scales[s] / (depth - 1)));
        }
        const std::vector<Mat> models = checkEveryWay(FUNDAMENTAL, points1, points2,
                                                      1.5 * scales[s]);
        EXPECT_FALSE(models[0].empty());
    }
}

//! The determinant of an F from seven points is 0 only up to the error of the root of a cubic
//! polynomial. The returned F must have rank 2 nevertheless.
TEST(Usac_Hostile, rank_of_a_minimal_model)
{
    Params params = Params::ransac();
    params.polishing = POLISHING_NONE;
    params.maxIterations = 30;
    for (uint64 seed = 1; seed <= 100; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        const Scene scene = makeScene(FUNDAMENTAL, options);
        const Mat F = estimate(scene, params);
        ASSERT_FALSE(F.empty());
        const Vec3d w = singularValues(FUNDAMENTAL, scene.points1, scene.points2, F);
        EXPECT_LT(w[2], 1e-14) << "seed " << seed;
    }
}

//! The decision to scale H to h33 = 1 must depend on the projective weights of the points, not on
//! the other entries of H, which depend on the scale of the points. Here h33 must be 1 at every
//! scale.
TEST(Usac_Hostile, h33_is_one_at_any_scale)
{
    const double scales[] = {1e-14, 1e-3, 1, 1e6, 1e14};
    const Scene scene = makeScene(HOMOGRAPHY);
    for (int s = 0; s < 5; ++s)
    {
        SCOPED_TRACE(cv::format("scale %g", scales[s]));
        std::vector<Point2d> points1, points2;
        for (int i = 0; i < scene.size(); ++i)
        {
            points1.push_back(scene.points1[i] * scales[s]);
            points2.push_back(scene.points2[i] * scales[s]);
        }
        const std::vector<Mat> models = checkEveryWay(HOMOGRAPHY, points1, points2,
                                                      1.5 * scales[s]);
        for (size_t i = 0; i < models.size(); ++i)
            EXPECT_TRUE(!models[i].empty() && models[i].at<double>(2, 2) == 1)
                << allPresets()[i].name;
    }
}

//! The squares of the coordinates are out of the range of double. A call is allowed to find no
//! model. If it finds one, mask and report must be correct.
TEST_P(UsacHostile, scales_near_the_ends_of_the_range)
{
    const Scene scene = makeScene(problem());
    const double scales[] = {1e-290, 1e-170, 1e170, 1e290};
    for (int s = 0; s < 4; ++s)
    {
        SCOPED_TRACE(cv::format("scale %g", scales[s]));
        std::vector<Point2d> points1 = scene.points1, points2 = scene.points2;
        for (int i = 0; i < scene.size(); ++i)
        {
            points1[i] *= scales[s];
            points2[i] *= scales[s];
        }
        checkEveryWay(problem(), points1, points2, 1.5 * scales[s], 30);
        checkEveryWay(problem(), scene.points1, points2, 1.5 * scales[s], 30);
    }
}

}  // namespace
}  // namespace opencv_test
