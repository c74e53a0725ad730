// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"

// Difficult points are not an error: there must be no exception and no endless loop, and every
// result must satisfy all contracts (checkResult).

namespace opencv_test {
namespace {

typedef UsacProblem UsacPoints;
INSTANTIATE_TEST_CASE_P(/**/, UsacPoints, testing::ValuesIn(TWO_VIEW_PROBLEMS));

//! Checks every preset and flag with these points. @return the model of Params::usacV20
Mat tryPoints(ProblemType problem, const std::vector<Point2d>& points1,
              const std::vector<Point2d>& points2, double pixels = 1.5)
{
    return checkEveryWay(problem, points1, points2, pixels)[0];
}

TEST_P(UsacPoints, few)
{
    const int m = sampleSizeOf(problem());
    for (uint64 seed = 1; seed <= 2; ++seed)
        for (int n = 0; n <= m + 2; ++n)
        {
            SCOPED_TRACE(cv::format("%d points, seed %d", n, (int)seed));
            SceneOptions options;
            options.inliers = 20;
            options.outliers = 0;
            options.noise = 0;
            options.seed = seed;
            Scene scene = makeScene(problem(), options);
            scene.points1.resize(n);
            scene.points2.resize(n);
            EXPECT_EQ(n < m, tryPoints(problem(), scene.points1, scene.points2).empty());
            Report report;
            Mat mask;
            estimatePoints(problem(), scene.points1, scene.points2, Params(), mask, report);
            EXPECT_EQ(n < m, report.stop == STOP_TOO_FEW_POINTS);
            if (n >= m)
            {
                EXPECT_EQ(n, report.inliers) << "exact points, all of one model";
            }
        }
}

TEST_P(UsacPoints, all_equal)
{
    const int sizes[] = {5, 7, 8, 100};
    for (int i = 0; i < 4; ++i)
    {
        const std::vector<Point2d> points1(sizes[i], Point2d(17, 23)),
            points2(sizes[i], Point2d(-3, 400));
        EXPECT_EQ(sampleSizeOf(problem()) > 1, tryPoints(problem(), points1, points2).empty());
    }
}

TEST_P(UsacPoints, collinear)
{
    std::vector<Point2d> points1, points2, noisy1, noisy2, axis1, axis2;
    RNG rng(1);
    for (int i = 0; i < 100; ++i)
    {
        const double s = rng.uniform(0., 400.), t = rng.uniform(0., 400.);
        points1.push_back(Point2d(s, 2 * s + 1));
        points2.push_back(Point2d(t, 30 - t));
        noisy1.push_back(points1[i] + gaussianPoint(rng, 0.3));
        noisy2.push_back(points2[i] + gaussianPoint(rng, 0.3));
        axis1.push_back(Point2d(s, 100));
        axis2.push_back(Point2d(s + 10, 100));
    }
    tryPoints(problem(), points1, points2);
    tryPoints(problem(), noisy1, noisy2);
    const Mat model = tryPoints(problem(), axis1, axis2);
    if (problem() == HOMOGRAPHY || problem() == AFFINITY)
    {
        EXPECT_TRUE(model.empty()) << "a line does not determine a homography or an affine map";
    }
    else if (problem() == SIMILARITY || problem() == TRANSLATION_2D)
    {
        const Mat moved = Mat_<double>({2, 3}, {1, 0, 10, 0, 1, 0});
        EXPECT_LT(cvtest::norm(model, moved, NORM_INF), 1e-9)
            << "a line determines a similarity and a translation";
    }
}

TEST_P(UsacPoints, static_camera)
{
    const Scene scene = makeScene(problem());
    std::vector<Point2d> moved = scene.points1;
    RNG rng(3);
    for (size_t i = 0; i < moved.size(); ++i)
        moved[i] += gaussianPoint(rng, 1e-3);
    const Mat exact = tryPoints(problem(), scene.points1, scene.points1);
    const Mat nearly = tryPoints(problem(), scene.points1, moved);
    if (mapsPoints(problem()))
    {
        EXPECT_LT(cvtest::norm(exact, Mat::eye(exact.size(), CV_64F), NORM_INF), 1e-9);
        EXPECT_LT(cvtest::norm(nearly, Mat::eye(nearly.size(), CV_64F), NORM_INF), 1e-2);
    }
}

TEST_P(UsacPoints, one_plane_and_pure_rotation)
{
    for (uint64 seed = 1; seed <= 2; ++seed)
    {
        SceneOptions options;
        options.planeFraction = 1;
        options.seed = seed;
        options.noise = seed % 2 ? 0 : 0.3;
        const Scene plane = makeScene(problem(), options);
        tryPoints(problem(), plane.points1, plane.points2);
        Scene turned = makeScene(problem(), options);
        for (int i = 0; i < turned.size(); ++i)
        {
            const Vec3d x(turned.points1[i].x, turned.points1[i].y, 1);
            const Vec3d y = turned.K * turned.R * turned.K.inv() * x;
            turned.points2[i] = Point2d(y[0] / y[2], y[1] / y[2]);
        }
        tryPoints(problem(), turned.points1, turned.points2);
    }
}

TEST_P(UsacPoints, only_outliers)
{
    RNG rng(11);
    std::vector<Point2d> points1, points2;
    for (int i = 0; i < 200; ++i)
    {
        points1.push_back(uniformPoint(rng, 0., 640., 0., 480.));
        points2.push_back(uniformPoint(rng, 0., 640., 0., 480.));
    }
    tryPoints(problem(), points1, points2, 1);
    tryPoints(problem(), points1, points2, 1e-9);
    tryPoints(problem(), points1, points2, 1e9);
}

TEST_P(UsacPoints, not_finite_rows_are_never_inliers)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    const Scene clean = makeScene(problem());
    Scene scene = clean;
    const double bad[] = {nan, inf, -inf};
    for (int i = 0; i < 24; ++i)
    {
        const int row = (i * 12) % scene.size();
        Point2d p(100, 100), q(100, 100);
        double* values[] = {&p.x, &p.y, &q.x, &q.y};
        *values[i % 4] = bad[i % 3];
        scene.points1.insert(scene.points1.begin() + row, p);
        scene.points2.insert(scene.points2.begin() + row, q);
    }
    const Mat model = tryPoints(problem(), scene.points1, scene.points2);
    EXPECT_LT(modelError(clean, model), 0.8);
    Mat mask;
    Report report;
    estimatePoints(problem(), scene.points1, scene.points2, Params(), mask, report);
    for (int i = 0; i < mask.rows; ++i)
    {
        const Point2d p = scene.points1[i], q = scene.points2[i];
        const double sum = p.x + p.y + q.x + q.y;
        if (!(std::abs(sum) < 1e300))
        {
            EXPECT_EQ(0, mask.at<uchar>(i)) << "row " << i;
        }
    }
    const std::vector<Point2d> all(20, Point2d(nan, 1));
    EXPECT_TRUE(tryPoints(problem(), all, all).empty());
}

/** Points and (for E) the camera matrix are shifted and scaled, and the threshold is scaled. The
inliers must be the same, except for at most one match whose error is so close to the threshold that
rounding decides. */
TEST_P(UsacPoints, offset_and_scale_keep_the_inliers)
{
    const Scene scene = makeScene(problem());
    Mat expected;
    ASSERT_FALSE(estimate(scene, Params(), expected).empty());
    const double offsets[] = {0, -1000, 1e5}, scales[] = {1e-3, 1, 1e3};
    for (int o = 0; o < 3; ++o)
        for (int s = 0; s < 3; ++s)
        {
            SCOPED_TRACE(cv::format("offset %g, scale %g", offsets[o], scales[s]));
            const Point2d offset(offsets[o], offsets[o]);
            Scene moved = scene;
            for (int i = 0; i < scene.size(); ++i)
            {
                moved.points1[i] = (scene.points1[i] + offset) * scales[s];
                moved.points2[i] = (scene.points2[i] + offset) * scales[s];
            }
            Matx33d K = scene.K;
            K(0, 2) += offset.x;
            K(1, 2) += offset.y;
            K = K * scales[s];
            K(2, 2) = 1;
            Params params;
            params.threshold *= scales[s];
            Mat mask;
            Report report;
            const Mat model = estimatePoints(problem(), moved.points1, moved.points2, params, mask,
                                             report, K);
            checkResult(problem(), moved.points1, moved.points2, params.threshold, model, mask,
                        report, K);
            EXPECT_LE(countNonZero(mask != expected), 1);
        }
}

}  // namespace
}  // namespace opencv_test
