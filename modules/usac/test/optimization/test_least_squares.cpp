// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/problem_objects.hpp"
#include "residual/normal_equations.hpp"

namespace opencv_test {
namespace {

typedef Eigen::Matrix<double, 9, 1> Vector9;

Vector9 vectorOf(const Model& model) { return Eigen::Map<const Vector9>(model.val); }

std::vector<int> allOf(const Correspondences& points)
{
    std::vector<int> indices(points.size);
    for (int i = 0; i < points.size; ++i)
        indices[i] = i;
    return indices;
}

std::vector<double> randomWeights(int count, RNG& rng)
{
    std::vector<double> weights(count);
    for (int i = 0; i < count; ++i)
        weights[i] = rng.uniform(0., 2.);
    return weights;
}

//! Test parameters 0 to 2 are H, F and E with the standard residual; 3 to 5 are H, F and E with the
//! symmetric residual.
ProblemType problemOf(int param) { return (ProblemType)(param % 3); }

Formula::Kind kindOf(int param)
{
    if (problemOf(param) == HOMOGRAPHY)
        return param < 3 ? Formula::TRANSFER : Formula::SYMMETRIC_TRANSFER;
    return param < 3 ? Formula::SAMPSON : Formula::SYMMETRIC_EPIPOLAR;
}

//! The residuals times the square roots of the weights, computed independently of the solver.
Eigen::VectorXd residuals(Formula::Kind kind, const Correspondences& p,
                          const std::vector<int>& indices, const double* weights, const Matx33d& M)
{
    const int rows = kind == Formula::TRANSFER             ? 2
                     : kind == Formula::SYMMETRIC_TRANSFER ? 4
                     : kind == Formula::SAMPSON            ? 1
                                                           : 2;
    Eigen::VectorXd r(rows * indices.size());
    for (size_t k = 0; k < indices.size(); ++k)
    {
        const int i = indices[k];
        const Vec3d x1(p.exact[X1][i], p.exact[Y1][i], 1), x2(p.exact[X2][i], p.exact[Y2][i], 1),
            y = M * x1;
        const double w = std::sqrt(weights ? weights[k] : 1), n = w * x2.dot(y);
        const Vec3d z = M.t() * x2, back = M.inv() * x2;
        const double first = y[0] * y[0] + y[1] * y[1], second = z[0] * z[0] + z[1] * z[1];
        const double transfer[4] = {w * (y[0] / y[2] - x2[0]), w * (y[1] / y[2] - x2[1]),
                                    w * (back[0] / back[2] - x1[0]),
                                    w * (back[1] / back[2] - x1[1])};
        const double lines[2] = {n / std::sqrt(first), n / std::sqrt(second)},
                     sampson = n / std::sqrt(first + second);
        const double* values = kind == Formula::SAMPSON              ? &sampson
                               : kind == Formula::SYMMETRIC_EPIPOLAR ? lines
                                                                     : transfer;
        for (int j = 0; j < rows; ++j)
            r[rows * k + j] = values[j];
    }
    return r;
}

double costOf(Formula::Kind kind, const Correspondences& p, const std::vector<int>& indices,
              const double* weights, const Model& M)
{
    return residuals(kind, p, indices, weights, M).squaredNorm();
}

//! The model with noise in its entries, scaled to unit norm.
Model perturbed(const Model& truth, double size, RNG& rng)
{
    Matx33d result = truth;
    for (int i = 0; i < 9; ++i)
        result.val[i] += rng.gaussian(size);
    return result * (1 / cv::norm(result));
}

Scene sceneOf(ProblemType problem, double noise, uint64 seed = 1)
{
    SceneOptions options;
    options.seed = seed;
    options.outliers = 0;
    options.inliers = 60;
    options.noise = noise;
    return makeScene(problem, options);
}

typedef testing::TestWithParam<int> Usac_LeastSquares;

TEST_P(Usac_LeastSquares, normalEquationsAgainstDifferences)
{
    const ProblemType problem = problemOf(GetParam());
    const Formula::Kind kind = kindOf(GetParam());
    const Scene scene = sceneOf(problem, 3);
    const Ptr<Usac> usac = createUsac(scene, Params());
    const Correspondences& points = usac->points();
    const std::vector<int> indices = allOf(points);
    RNG rng(1);
    const std::vector<double> weights = randomWeights(points.size, rng);
    for (int repeat = 0; repeat < 10; ++repeat)
    {
        const double* w = repeat % 2 ? weights.data() : 0;
        const Model model = perturbed(toInternal(points, scene.model), 0.01, rng);
        const Eigen::VectorXd r = residuals(kind, points, indices, w, model);
        Eigen::MatrixXd J(r.size(), 9);
        for (int i = 0; i < 9; ++i)
        {
            const double step = 1e-6;
            Model plus = model, minus = model;
            plus.val[i] += step;
            minus.val[i] -= step;
            J.col(i) = (residuals(kind, points, indices, w, plus) -
                        residuals(kind, points, indices, w, minus)) /
                       (2 * step);
        }
        NormalEquations sums;
        sums.accumulate(*residualOf(kind), PointChunks(points, indices.data(), points.size, w),
                        model);
        EXPECT_NEAR(r.squaredNorm(), sums.cost, 1e-10 * r.squaredNorm());
        const Vector9 Jtr = J.transpose() * r;
        const Eigen::Matrix<double, 9, 9> JtJ = J.transpose() * J;
        EXPECT_LE((Jtr - sums.Jtr).norm(), 1e-6 * J.norm() * r.norm());
        EXPECT_LE((JtJ - sums.JtJ).norm(), 1e-6 * JtJ.norm());
        EXPECT_GT(Jtr.norm(),
                  1e-3 * J.norm() *
                      // the model is not at a minimum, where a wrong gradient would be small, too
                      r.norm());
    }
}

void expectOnManifold(ProblemType problem, const Matx33d& model)
{
    EXPECT_NEAR(1, cv::norm(model), 1e-12);
    if (problem == HOMOGRAPHY)
        return;
    Vec3d w;
    SVD::compute(model, w);
    EXPECT_NEAR(0, w[2], 1e-12);
    if (problem == ESSENTIAL)
    {
        EXPECT_NEAR(w[0], w[1], 1e-12);
    }
}

//! The model of a parameterization must be the closest one to the given matrix, so that a step
//! along the manifold leads away from this matrix. Half of the matrices are near the manifold,
//! which a faster method is used for.
TEST_P(Usac_LeastSquares, manifoldPointIsTheClosest)
{
    const ProblemType problem = problemOf(GetParam());
    RNG rng(3);
    for (int repeat = 0; repeat < 100; ++repeat)
    {
        Model start(3, 3);
        for (int i = 0; i < 9; ++i)
            start.val[i] = rng.gaussian(1);
        if (repeat % 2)
            start = perturbed(Parameterization(problem, start).model(),
                              std::pow(10., rng.uniform(-12., -2.)), rng);
        const Parameterization here(problem, start);
        const Vector9 direction = vectorOf(start).normalized();
        const double cosine = direction.dot(vectorOf(here.model()));
        for (int k = 0; k < 20; ++k)
        {
            Parameterization::Step step(here.dimension());
            for (int i = 0; i < here.dimension(); ++i)
                step[i] = rng.gaussian(0.05);
            EXPECT_LE(direction.dot(vectorOf(here.plus(step).model())), cosine + 1e-12);
        }
    }
}

//! Largest absolute cosine between the residuals and their derivative along one of the tangents of
//! the manifold; 0 at a minimum.
double slope(Formula::Kind kind, const Correspondences& points, const std::vector<int>& indices,
             const double* weights, const Model& model)
{
    NormalEquations sums;
    sums.accumulate(*residualOf(kind),
                    PointChunks(points, indices.data(), (int)indices.size(), weights), model);
    const Parameterization::Basis basis = Parameterization(points.problem, model).tangent();
    double largest = 0;
    for (int k = 0; k < basis.cols(); ++k)
    {
        const double length = std::sqrt(basis.col(k).dot(sums.JtJ * basis.col(k)) * sums.cost);
        largest = std::max(largest, std::abs(basis.col(k).dot(sums.Jtr)) / length);
    }
    return largest;
}

TEST_P(Usac_LeastSquares, reachesTheMinimum)
{
    const ProblemType problem = problemOf(GetParam());
    const Formula::Kind kind = kindOf(GetParam());
    const Ptr<NonMinimalSolver> solver = createLeastSquaresSolver(problem, kind);
    RNG rng(4);
    int steep = 0;
    for (int repeat = 0; repeat < 60; ++repeat)
    {
        const Scene scene = sceneOf(problem, 1, repeat);
        const Ptr<Usac> usac = createUsac(scene, Params());
        const Correspondences& points = usac->points();
        const std::vector<int> indices = allOf(points);
        const std::vector<double> weights = randomWeights(points.size, rng);
        const double* w = repeat % 2 ? weights.data() : 0;
        const Model truth = Parameterization(problem, toInternal(points, scene.model)).model();
        const Model start = Parameterization(problem, perturbed(truth, 1e-3, rng)).model();
        Model model = start;
        ASSERT_TRUE(solver->fit(points, indices.data(), points.size, w, model));
        expectOnManifold(problem, model);
        const double cost = costOf(kind, points, indices, w, model);
        EXPECT_LT(cost, costOf(kind, points, indices, w, start));
        EXPECT_LE(cost, costOf(kind, points, indices, w, truth) * (1 + 1e-6));
        steep += slope(kind, points, indices, w, model) > 1e-2;
        Model again = model;
        ASSERT_TRUE(solver->fit(points, indices.data(), points.size, w, again));
        EXPECT_NEAR(cost, costOf(kind, points, indices, w, again), 1e-4 * cost);
    }
    EXPECT_LE(steep, 1);
}

//! From any start, a fit must either not raise the cost, or fail and leave the model unchanged.
TEST_P(Usac_LeastSquares, neverRaisesTheCost)
{
    const ProblemType problem = problemOf(GetParam());
    const Formula::Kind kind = kindOf(GetParam());
    const Ptr<NonMinimalSolver> solver = createLeastSquaresSolver(problem, kind);
    const Scene scene = sceneOf(problem, 5);
    const Ptr<Usac> usac = createUsac(scene, Params());
    const Correspondences& points = usac->points();
    const std::vector<int> indices = allOf(points);
    RNG rng(6);
    int fitted = 0;
    for (int repeat = 0; repeat < 300; ++repeat)
    {
        Model start(3, 3);
        for (int i = 0; i < 9; ++i)
            start.val[i] = rng.gaussian(1);
        start = Parameterization(problem, start).model();
        const int count = rng.uniform(4, points.size + 1);
        const std::vector<int> some(indices.begin(), indices.begin() + count);
        const std::vector<double> weights = randomWeights(count, rng);
        Model model = start;
        const bool done = solver->fit(points, some.data(), count, weights.data(), model);
        fitted += done;
        if (done)
        {
            EXPECT_LE(costOf(kind, points, some, weights.data(), model),
                      costOf(kind, points, some, weights.data(), start) * (1 + 1e-9));
        }
        else
        {
            EXPECT_EQ(start, model);
        }
        EXPECT_TRUE(checkRange(Mat(Matx33d(model))));
    }
    EXPECT_GT(fitted, 200);
}

INSTANTIATE_TEST_CASE_P(All, Usac_LeastSquares, testing::Range(0, 6));

}  // namespace
}  // namespace opencv_test
