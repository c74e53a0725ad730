// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/problem_objects.hpp"
#include "numeric/decompositions.hpp"

#include <numeric>

// The tangents of a parameterization must be linearly independent, even at the models of special
// motions, where the tangents of a parameterization by angles are dependent.

namespace opencv_test {
namespace {

typedef Eigen::Matrix<double, 9, 1> Vector9;

Vector9 vectorOf(const Model& model) { return Eigen::Map<const Vector9>(model.val); }

Scene sceneOf(ProblemType problem, Motion motion, double noise, double baseline = 1)
{
    SceneOptions options;
    options.motion = motion;
    options.baseline = baseline;
    options.inliers = 100;
    options.outliers = 0;
    options.noise = noise;
    return makeScene(problem, options);
}

/** Smallest and largest singular value of the derivatives of plus() with respect to the step at
step 0, from finite differences. tangent() must return the same derivatives. */
Vec2d conditionOf(const Parameterization& here)
{
    const double h = 1e-5;
    Eigen::MatrixXd J(9, here.dimension());
    for (int k = 0; k < here.dimension(); ++k)
    {
        Parameterization::Step step = Parameterization::Step::Zero(here.dimension());
        step[k] = h;
        J.col(k) = (vectorOf(here.plus(step).model()) - vectorOf(here.plus(-step).model())) /
                   (2 * h);
    }
    EXPECT_LE((J - here.tangent()).norm(), 1e-8);
    const Eigen::VectorXd values = singularValues(J);
    return Vec2d(values[here.dimension() - 1], values[0]);
}

//! The parameters of these tests are a problem and a camera motion.
typedef testing::TestWithParam<std::tuple<int, int>> Usac_Parameterization;

TEST_P(Usac_Parameterization, isRegularAtSpecialMotions)
{
    const ProblemType problem = (ProblemType)std::get<0>(GetParam());
    const double baselines[] = {1, 1e-3};
    for (int k = 0; k < 2; ++k)
    {
        const Scene scene = sceneOf(problem, (Motion)std::get<1>(GetParam()), 0, baselines[k]);
        const Ptr<Usac> usac = createUsac(scene, Params());
        const Vec2d values = conditionOf(
            Parameterization(problem, toInternal(usac->points(), scene.model)));
        EXPECT_GT(values[0], 0.7);
        EXPECT_LT(values[1], 1.01);
    }
}

//! Three Gauss-Newton steps must reach the minimum, which is impossible if the tangents lack a
//! direction.
TEST_P(Usac_Parameterization, leastSquaresInThreeSteps)
{
    const ProblemType problem = (ProblemType)std::get<0>(GetParam());
    const Scene scene = sceneOf(problem, (Motion)std::get<1>(GetParam()), 0.5);
    const Ptr<Usac> usac = createUsac(scene, Params());
    const Correspondences& points = usac->points();
    std::vector<int> all(points.size);
    for (int i = 0; i < points.size; ++i)
        all[i] = i;
    const NonMinimalSolver& solver = *usac->components().nonMinimalSolver;
    Model steps = toInternal(points, scene.model), best = steps;
    ASSERT_TRUE(solver.fit(points, all.data(), points.size, 0, steps, 3));
    for (int i = 0; i < 20; ++i)
        ASSERT_TRUE(solver.fit(points, all.data(), points.size, 0, best, 10));
    std::vector<double> errors(points.size);
    double cost[2];
    for (int k = 0; k < 2; ++k)
    {
        usac->components().residual->squaredErrors(k == 0 ? steps : best, points.exact, points.size,
                                                   errors.data());
        cost[k] = std::accumulate(errors.begin(), errors.end(), 0.);
    }
    EXPECT_LE(cost[0], cost[1] * (1 + 1e-6));
}

INSTANTIATE_TEST_CASE_P(All, Usac_Parameterization,
                        testing::Combine(testing::Range(0, 3),
                                         testing::Range((int)MOTION_GENERAL, (int)MOTION_CAR + 1)));

//! The ratio of the smaller to the larger nonzero singular value of F is between 1/1000 and 1. For
//! each ratio, the tangents must be orthonormal.
TEST(Usac_Parameterization_Fundamental, isRegularForAllSingularValues)
{
    RNG rng(1);
    const double ratios[] = {1, 1 - 1e-9, 0.5, 1e-3};
    for (int k = 0; k < 4; ++k)
    {
        Matx33d A;
        for (int i = 0; i < 9; ++i)
            A.val[i] = rng.gaussian(1);
        Matx31d w;
        Matx33d U, Vt;
        SVD::compute(A, w, U, Vt);
        const Matx33d F = U * Matx33d(1, 0, 0, 0, ratios[k], 0, 0, 0, 0) * Vt;
        const Parameterization here(FUNDAMENTAL, F);
        EXPECT_LE(modelDistance(here.model(), F * (1 / cv::norm(F))), 1e-14);
        const Vec2d values = conditionOf(here);
        EXPECT_NEAR(1, values[0], 1e-6);
        EXPECT_NEAR(1, values[1], 1e-6);
    }
}

}  // namespace
}  // namespace opencv_test
