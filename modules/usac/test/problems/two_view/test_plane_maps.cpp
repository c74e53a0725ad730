// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/linear_map.hpp"
#include "support/own_points.hpp"
#include "support/contracts.hpp"
#include "problems/registry.hpp"

// Tests of the affine map and the similarity between two images.

namespace opencv_test {
namespace {

const ProblemType TYPES[] = {AFFINITY, SIMILARITY};

Ptr<Problem> problemOf(ProblemType type)
{
    return createProblem(type, noArray(), noArray(), noArray(), noArray());
}

Matx23d randomMap(ProblemType type, RNG& rng)
{
    const double angle = rng.uniform(-CV_PI, CV_PI), scale = std::exp(rng.uniform(-1., 1.));
    const double a = scale * std::cos(angle), b = scale * std::sin(angle);
    const Point2d t = uniformPoint(rng, -50., 50.);
    Matx23d map(a, -b, t.x, b, a, t.y);
    for (int k = 0; k < 6 && type == AFFINITY; ++k)
        map.val[k] += rng.gaussian(0.2 * scale);
    return map;
}

TEST(Usac_PlaneMaps, minimalSolversAreExact)
{
    RNG rng(2);
    for (int t = 0; t < 2; ++t)
    {
        const Ptr<MinimalSolver> solver = problemOf(TYPES[t])->createMinimalSolver();
        for (int trial = 0; trial < 1000; ++trial)
        {
            const Matx23d map = randomMap(TYPES[t], rng);
            std::vector<Point2d> points1, points2;
            for (int i = 0; i < solver->sampleSize(); ++i)
            {
                points1.push_back(uniformPoint(rng, -1., 1.));
                const Vec2d q = map * Vec3d(points1[i].x, points1[i].y, 1);
                points2.push_back(Point2d(q[0], q[1]));
            }
            const OwnPoints own(HOMOGRAPHY, points1, points2);
            const int sample[] = {0, 1, 2};
            Model models[MAX_MODELS];
            const Point2d side = points1[1] - points1[0];
            const double width = t == 0 ? std::abs(side.cross(points1[2] - points1[0]))
                                        : side.dot(side);
            if (width < 1e-3)
                continue;
            ASSERT_EQ(1, solver->solve(own.view(), sample, models));
            for (int k = 0; k < 6; ++k)
                EXPECT_NEAR(map.val[k], models[0].val[k], 1e-10 / width * (1 + cv::norm(map)));
            EXPECT_EQ(0, models[0].val[6]);
            EXPECT_EQ(0, models[0].val[7]);
            EXPECT_EQ(1, models[0].val[8]);
        }
    }
}

TEST(Usac_PlaneMaps, degenerateSamples)
{
    const Point2d a(0.1, 0.2), b(0.5, 0.3), middle = (a + b) * 0.5, c(0.4, -0.7);
    const Point2d lists[][3] = {{a, b, middle}, {a, a, c}, {a, b, c}};
    const int sample[] = {0, 1, 2};
    Model models[MAX_MODELS];
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
        {
            const std::vector<Point2d> points1(lists[i], lists[i] + 3),
                points2(lists[k], lists[k] + 3);
            const OwnPoints own(HOMOGRAPHY, points1, points2);
            EXPECT_EQ(i == 2 && k == 2, problemOf(AFFINITY)->createMinimalSolver()->solve(
                                            own.view(), sample, models));
            EXPECT_EQ(
                i != 1 && k != 1,
                problemOf(SIMILARITY)->createMinimalSolver()->solve(own.view(), sample, models));
        }
}

//! A fit must agree with the least-squares solution of the linear equations, because both minimize
//! the same sum for these maps.
TEST(Usac_PlaneMaps, leastSquares)
{
    for (int t = 0; t < 2; ++t)
    {
        RNG rng(4);
        const Matx23d map = randomMap(TYPES[t], rng);
        std::vector<Point2d> points1, points2;
        std::vector<double> weights;
        std::vector<int> all;
        for (int i = 0; i < 50; ++i)
        {
            points1.push_back(uniformPoint(rng, -1., 1.));
            const Vec2d q = map * Vec3d(points1[i].x, points1[i].y, 1);
            points2.push_back(Point2d(q[0], q[1]) + gaussianPoint(rng, 0.01));
            weights.push_back(rng.uniform(0.1, 1.));
            all.push_back(i);
        }
        const Matx23d expected = linearMap(TYPES[t], points1, points2, weights);
        const OwnPoints own(HOMOGRAPHY, points1, points2);
        const Ptr<Problem> problem = problemOf(TYPES[t]);
        Model model = Matx33d(1, 0.1, 3, -0.1, 1, 4, 0, 0, 1);
        const Ptr<NonMinimalSolver> fit = problem->createNonMinimalSolver(
            problem->createResidual(RESIDUAL_STANDARD));
        ASSERT_TRUE(fit->fit(own.view(), all.data(), 50, weights.data(), model));
        for (int k = 0; k < 6; ++k)
            EXPECT_NEAR(expected.val[k], model.val[k], 1e-10) << t << " " << k;
    }
}

}  // namespace
}  // namespace opencv_test
