// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "pose_scenes.hpp"
#include "problems/absolute_pose/camera.hpp"
#include "problems/absolute_pose/lens_residual.hpp"
#include "problems/absolute_pose/pose_parameterization.hpp"
#include "problems/kernels.hpp"

// The lens model is compared with cv::projectPoints, and the derivatives of errors are compared
// with finite differences.

namespace opencv_test {
namespace {

const int LENS_COEFFICIENTS[] = {4, 5, 8, 12, 14};

//! Coefficients of a typical lens.
Mat lens(int coefficients)
{
    const double c[] = {-0.25, 0.08,  0.002,  -0.001, -0.01, 0.05, 0.02,
                        -0.01, 0.003, -0.001, 0.002,  0.001, 0.02, -0.03};
    return Mat(1, coefficients, CV_64F, (void*)c).clone();
}

std::vector<Vec2d> pointsWithin(double radius)
{
    std::vector<Vec2d> points(1, Vec2d(0, 0));
    RNG rng(5);
    for (int i = 0; i < 200; ++i)
    {
        const double r = radius * std::sqrt(rng.uniform(0., 1.)), a = rng.uniform(0., 2 * CV_PI);
        points.push_back(Vec2d(r * std::cos(a), r * std::sin(a)));
    }
    return points;
}

TEST(Usac_Distortion, is_that_of_projectPoints_and_inverted)
{
    for (int coefficients : LENS_COEFFICIENTS)
    {
        SCOPED_TRACE(coefficients);
        const Mat c = lens(coefficients);
        const Distortion distortion(c);
        for (const Vec2d& p : pointsWithin(0.7))
        {
            std::vector<Point2d> reference;
            projectPoints(std::vector<Point3d>(1, Point3d(p[0], p[1], 1)), Vec3d(), Vec3d(),
                          Matx33d::eye(), c, reference);
            Vec2d seen, back;
            Matx22d J;
            ASSERT_TRUE(distortion.distort(p, seen, &J));
            EXPECT_NEAR(reference[0].x, seen[0], 1e-14);
            EXPECT_NEAR(reference[0].y, seen[1], 1e-14);
            ASSERT_TRUE(distortion.undistort(seen, back));
            EXPECT_LE(cvtest::norm(p - back, NORM_INF), 1e-12);
            const double h = 1e-6;
            for (int k = 0; k < 2; ++k)
            {
                Vec2d step(0, 0), plus, minus;
                step[k] = h;
                distortion.distort(p + step, plus);
                distortion.distort(p - step, minus);
                const Vec2d difference = (plus - minus) * (0.5 / h);
                EXPECT_NEAR(difference[0], J(0, k), 1e-8);
                EXPECT_NEAR(difference[1], J(1, k), 1e-8);
            }
        }
    }
}

//! This lens images a point at distance r from the center at the distance r (1 - r^2 / 4), which
//! decreases beyond r^2 = 4 / 3. Points with a larger r must not be visible; otherwise they would
//! have the same image as points with a smaller r and could be inliers.
TEST(Usac_Distortion, ends_where_the_lens_folds)
{
    const Distortion distortion(Mat(Matx14d(-0.25, 0, 0, 0)));
    const double fold = std::sqrt(4. / 3), seenFold = fold * (1 - 0.25 * 4 / 3);
    Vec2d seen, back;
    for (double angle = 0; angle < 6; angle += 0.5)
    {
        const Vec2d direction(std::cos(angle), std::sin(angle));
        EXPECT_TRUE(distortion.distort(direction * (fold * 0.999), seen));
        EXPECT_FALSE(distortion.distort(direction * (fold * 1.001), seen));
        EXPECT_FALSE(distortion.distort(direction * 1.9, seen));
        EXPECT_TRUE(distortion.undistort(direction * (seenFold * 0.999), back));
        EXPECT_LE(cv::norm(back), fold);
        EXPECT_FALSE(distortion.undistort(direction * (seenFold * 1.01), back));
    }
    EXPECT_FALSE(distortion.distort(Vec2d(NAN, 0), seen));
    EXPECT_FALSE(distortion.undistort(Vec2d(INFINITY, 0), back));
    EXPECT_TRUE(Distortion(Mat()).none());
    EXPECT_TRUE(Distortion(Mat::zeros(1, 5, CV_64F)).none());
    EXPECT_FALSE(distortion.none());
}

//! Checks a residual with a lens: its derivatives, the agreement of linearize() and
//! squaredErrors(), and that points behind the camera have infinite errors.
void checkResidual(const Residual& residual, const Matx33d& camera)
{
    RNG rng(7);
    for (int trial = 0; trial < 50; ++trial)
    {
        Matx33d R;
        Rodrigues(gaussianVector(rng, 0.5), R);
        const Point2d side = gaussianPoint(rng, 0.3);
        const Vec3d t(side.x, side.y, 4);
        const Model model = PoseParameterization(camera, R, t).model();
        double datum[5], error[2], derivative[24], squared;
        for (double& number : datum)
            number = rng.uniform(-0.5, 0.5);
        ASSERT_EQ(2, residual.linearize(model, datum, error, derivative));
        const double* columns[5];
        for (int k = 0; k < 5; ++k)
            columns[k] = datum + k;
        residual.squaredErrors(model, columns, 1, &squared);
        EXPECT_NEAR(squared, error[0] * error[0] + error[1] * error[1], 1e-14);
        const double h = 1e-6;
        for (int i = 0; i < 12; ++i)
        {
            double plus[2], minus[2];
            Model moved = model;
            moved.val[i] += h;
            residual.error(moved, datum, plus);
            moved.val[i] -= 2 * h;
            residual.error(moved, datum, minus);
            for (int k = 0; k < 2; ++k)
                EXPECT_NEAR((plus[k] - minus[k]) / (2 * h), derivative[12 * k + i], 1e-8);
        }
        Model behind = model;
        for (double& number : behind.val)
            number = -number;
        residual.squaredErrors(behind, columns, 1, &squared);
        EXPECT_EQ(INFINITY, squared);
    }
}

TEST(Usac_Distortion, errors_and_derivatives)
{
    const Matx33d K(600, 5, 320, 0, 650, 240, 0, 0, 1);
    for (int coefficients : LENS_COEFFICIENTS)
    {
        const PoseCamera camera(K, lens(coefficients));
        checkResidual(LensResidual(camera, false), camera.matrix);
    }
}

}  // namespace
}  // namespace opencv_test
