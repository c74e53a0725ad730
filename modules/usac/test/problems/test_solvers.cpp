// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/problem_objects.hpp"

#include <Eigen/Core>

namespace opencv_test {
namespace {

Ptr<MinimalSolver> solverOf(ProblemType problem)
{
    return problem == HOMOGRAPHY    ? createHomography4Solver()
           : problem == FUNDAMENTAL ? createFundamental7Solver()
                                    : createEssential5Solver();
}

std::vector<Model> solve(const MinimalSolver& solver, const Correspondences& points,
                         const int* sample)
{
    Model models[MAX_MODELS];
    const int count = solver.solve(points, sample, models);
    EXPECT_GE(count, 0);
    EXPECT_LE(count, (int)MAX_MODELS);
    for (int i = 0; i < count; ++i)
        EXPECT_NEAR(1, cv::norm(Matx33d(models[i])), 1e-9);  // fails for NaN, too
    return std::vector<Model>(models, models + count);
}

std::vector<Model> solveFirst(const MinimalSolver& solver, const Correspondences& points)
{
    const int sample[MAX_SAMPLE_SIZE] = {0, 1, 2, 3, 4, 5, 6, 7};
    return solve(solver, points, sample);
}

//! Largest algebraic error over the sample, with homogeneous points of unit norm. The model must
//! have unit norm, too.
double constraintError(const Correspondences& p, const int* sample, int count, const Model& model)
{
    double largest = 0;
    for (int k = 0; k < count; ++k)
    {
        const int i = sample[k];
        Vec3d x1(p.exact[X1][i], p.exact[Y1][i], 1), x2(p.exact[X2][i], p.exact[Y2][i], 1);
        x1 *= 1 / cv::norm(x1);
        x2 *= 1 / cv::norm(x2);
        const Vec3d y = Matx33d(model) * x1;
        largest = std::max(largest, p.problem->errorDimension() == 2 ? cv::norm(x2.cross(y))
                                                                     : std::abs(x2.dot(y)));
    }
    return largest;
}

//! How far a model of unit norm violates the constraints that the determinant is 0 (F, E) and that
//! the two nonzero singular values are equal (E). 0 for H.
double manifoldError(ProblemType problem, const Matx33d& M)
{
    if (problem == HOMOGRAPHY)
        return 0;
    if (problem == FUNDAMENTAL)
        return std::abs(determinant(M));
    const Matx33d EEt = M * M.t();
    return std::max(std::abs(determinant(M)),
                    cv::norm(EEt * M * 2. - M * (EEt(0, 0) + EEt(1, 1) + EEt(2, 2))));
}

struct Exactness
{
    Exactness() : samples(0), unsolved(0), missed(0) {}
    int samples, unsolved, missed;  //!< missed: there are solutions, but not the true model
    std::vector<double> constraint, manifold;
};

void solveScene(ProblemType problem, uint64 seed, double planeFraction, Exactness& result)
{
    SceneOptions options;
    options.seed = seed;
    options.outliers = 0;
    options.noise = 0;
    options.planeFraction = planeFraction;
    const Scene scene = makeScene(problem, options);
    const Ptr<Usac> usac = createUsac(scene, Params());
    const Correspondences& points = usac->points();
    const Ptr<MinimalSolver> solver = solverOf(problem);
    const Model truth = toInternal(points, scene.model);
    for (int i = 0; i < 100; ++i)
    {
        int sample[MAX_SAMPLE_SIZE];
        Rng(seed, i).distinct(points.size, solver->sampleSize(), sample);
        const std::vector<Model> models = solve(*solver, points, sample);
        double closest = 2;
        for (size_t k = 0; k < models.size(); ++k)
        {
            closest = std::min(closest, modelDistance(models[k], truth));
            result.constraint.push_back(
                constraintError(points, sample, solver->sampleSize(), models[k]));
            result.manifold.push_back(manifoldError(problem, models[k]));
        }
        ++result.samples;
        result.unsolved += models.empty();
        result.missed += !models.empty() && closest > 1e-5;
    }
}

//! The value that the given fraction of the values does not exceed.
double quantile(std::vector<double>& values, double fraction)
{
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, (size_t)(fraction * values.size()))];
}

typedef testing::TestWithParam<int> Usac_Solvers_Problem;

TEST_P(Usac_Solvers_Problem, exactWithoutNoise)
{
    const ProblemType problem = (ProblemType)GetParam();
    Exactness result;
    for (uint64 seed = 1; seed <= 20; ++seed)
        solveScene(problem, seed, 0, result);
    EXPECT_EQ(2000, result.samples);
    EXPECT_LE(result.unsolved, 10);
    EXPECT_LE(result.missed, 6);
    EXPECT_LE(quantile(result.constraint, 1), 1e-8);
    EXPECT_LE(quantile(result.constraint, 0.9), 1e-12);
    // E: only 98.5 %, because the polynomial of its solver is ill-conditioned near double roots
    EXPECT_LE(quantile(result.manifold, problem == ESSENTIAL ? 0.985 : 1), 1e-8);
    EXPECT_LE(quantile(result.manifold, 0.9), 1e-11);
}

INSTANTIATE_TEST_CASE_P(All, Usac_Solvers_Problem, testing::Values(0, 1, 2));

void randomPoints(RNG& rng, int count, std::vector<Point2d>& points1, std::vector<Point2d>& points2)
{
    points1.clear();
    points2.clear();
    for (int i = 0; i < count; ++i)
    {
        points1.push_back(uniformPoint(rng, -1., 1.));
        points2.push_back(uniformPoint(rng, -1., 1.));
    }
}

//! Number of real F with det F = 0 in the null space of the constraints, from an SVD and the
//! discriminant of the cubic. Returns -1 if rounding could change the number.
int countFundamental(const Correspondences& p)
{
    Matx<double, 7, 9> A;
    for (int i = 0; i < 7; ++i)
    {
        const double row[] = {p.exact[X2][i] * p.exact[X1][i],
                              p.exact[X2][i] * p.exact[Y1][i],
                              p.exact[X2][i],
                              p.exact[Y2][i] * p.exact[X1][i],
                              p.exact[Y2][i] * p.exact[Y1][i],
                              p.exact[Y2][i],
                              p.exact[X1][i],
                              p.exact[Y1][i],
                              1};
        std::copy(row, row + 9, A.val + 9 * i);
    }
    const SVD svd(A, SVD::FULL_UV);
    Matx33d F[2];
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 9; ++i)
            F[k].val[i] = svd.vt.at<double>(7 + k, i);
    // coefficients of det(x F0 + F1) from its values at 0, 1 and -1 and its leading coefficient
    const double d = determinant(F[1]), plus = determinant(F[0] + F[1]),
                 minus = determinant(F[1] - F[0]);
    const double a = determinant(F[0]), b = (plus + minus) / 2 - d, c = (plus - minus) / 2 - a;
    const double parts[] = {18 * a * b * c * d, -4 * b * b * b * d, b * b * c * c,
                            -4 * a * c * c * c, -27 * a * a * d * d};
    double discriminant = 0, size = 0;
    for (int i = 0; i < 5; ++i)
    {
        discriminant += parts[i];
        size = std::max(size, std::abs(parts[i]));
    }
    return std::abs(discriminant) < 1e-6 * size ? -1 : discriminant > 0 ? 3 : 1;
}

TEST(Usac_Solvers, allFundamentalMatrices)
{
    RNG rng(3);
    const Ptr<MinimalSolver> solver = createFundamental7Solver();
    int compared = 0, three = 0;
    for (int i = 0; i < 1000; ++i)
    {
        std::vector<Point2d> points1, points2;
        randomPoints(rng, 7, points1, points2);
        const OwnPoints points(FUNDAMENTAL, points1, points2);
        const int expected = countFundamental(points.view());
        if (expected < 0)
            continue;
        ++compared;
        three += expected == 3;
        EXPECT_EQ(expected, (int)solveFirst(*solver, points.view()).size()) << "sample " << i;
    }
    EXPECT_GT(compared, 900);
    EXPECT_GT(three, 100);
}

void copyPoint(std::vector<Point2d>& points1, std::vector<Point2d>& points2, int from, int to)
{
    points1[to] = points1[from];
    points2[to] = points2[from];
}

TEST_P(Usac_Solvers_Problem, repeatedPointsGiveNothing)
{
    const ProblemType problem = (ProblemType)GetParam();
    const Ptr<MinimalSolver> solver = solverOf(problem);
    RNG rng(8);
    for (int repeat = 0; repeat < 200; ++repeat)
    {
        std::vector<Point2d> points1, points2;
        randomPoints(rng, 8, points1, points2);
        const int from = rng.uniform(0, solver->sampleSize());
        copyPoint(points1, points2, from,
                  (from + 1 + rng.uniform(0, solver->sampleSize() - 1)) % solver->sampleSize());
        EXPECT_TRUE(solveFirst(*solver, OwnPoints(problem, points1, points2).view()).empty());
    }
    const std::vector<Point2d> equal1(8, Point2d(0.3, -0.2)), equal2(8, Point2d(0.1, 0.7)),
        zeros(8, Point2d(0, 0));
    EXPECT_TRUE(solveFirst(*solver, OwnPoints(problem, equal1, equal2).view()).empty());
    EXPECT_TRUE(solveFirst(*solver, OwnPoints(problem, zeros, zeros).view()).empty());
}

TEST_P(Usac_Solvers_Problem, collinearPointsGiveNothing)
{
    const ProblemType problem = (ProblemType)GetParam();
    const Ptr<MinimalSolver> solver = solverOf(problem);
    RNG rng(9);
    for (int repeat = 0; repeat < 200; ++repeat)
    {
        std::vector<Point2d> points1, points2;
        randomPoints(rng, 8, points1, points2);
        const Point2d a1 = points1[0], d1 = points1[1] - a1, a2 = points2[0], d2 = points2[1] - a2;
        for (int i = 2; i < 8; ++i)
        {
            points1[i] = a1 + d1 * rng.uniform(-2., 2.);
            points2[i] = a2 + d2 * rng.uniform(-2., 2.);
        }
        EXPECT_TRUE(solveFirst(*solver, OwnPoints(problem, points1, points2).view()).empty());
    }
}

TEST(Usac_Solvers, homographyOfThreeCollinearPoints)
{
    const Ptr<MinimalSolver> solver = createHomography4Solver();
    RNG rng(10);
    for (int repeat = 0; repeat < 200; ++repeat)
    {
        std::vector<Point2d> line, general;
        randomPoints(rng, 4, line, general);
        const int k = repeat % 4;
        line[k] = line[(k + 1) % 4] +
                  (line[(k + 2) % 4] - line[(k + 1) % 4]) * rng.uniform(-1., 2.);
        EXPECT_TRUE(solveFirst(*solver, OwnPoints(HOMOGRAPHY, line, general).view()).empty());
        EXPECT_TRUE(solveFirst(*solver, OwnPoints(HOMOGRAPHY, general, line).view()).empty());
    }
}

//! Seven points on a plane are consistent with a family of fundamental matrices, so that the solver
//! must return none.
TEST(Usac_Solvers, fundamentalOfAPlane)
{
    Exactness result;
    for (uint64 seed = 1; seed <= 5; ++seed)
        solveScene(FUNDAMENTAL, seed, 1, result);
    EXPECT_EQ(result.samples, result.unsolved);
}

//! Four points are on a line l1 in image 1, the other three on a line l2 in image 2. The rank-1
//! matrix l2 l1^T satisfies all seven constraints, but must not be returned.
TEST(Usac_Solvers, fundamentalOfALineInEachImage)
{
    const Ptr<MinimalSolver> solver = createFundamental7Solver();
    RNG rng(13);
    for (int repeat = 0; repeat < 300; ++repeat)
    {
        std::vector<Point2d> points1, points2;
        for (int i = 0; i < 7; ++i)
        {
            const bool exact = repeat % 2 == 0;  // without any rounding of the coordinates
            const Point2d p = integerPoint(rng, -2, 3), q = uniformPoint(rng, -2., 2.);
            points1.push_back(exact ? p : q);
            points2.push_back(exact ? integerPoint(rng, -2, 3)
                                    : Point2d(q.y * q.y, q.x * q.x * q.x));
            if (i < 4)
                points1.back().y = 0.5 * points1.back().x + 0.25;
            else
                points2.back().x = 1 - points2.back().y;
        }
        const std::vector<Model> models = solveFirst(
            *solver, OwnPoints(FUNDAMENTAL, points1, points2).view());
        for (size_t k = 0; k < models.size(); ++k)
        {
            Mat w;
            SVD::compute(Mat(Matx33d(models[k])), w, SVD::NO_UV);
            EXPECT_GT(w.at<double>(1), 1e-8) << "repeat " << repeat;
        }
    }
}

//! Points on a coarse grid are degenerate in many ways. All returned models must be finite and
//! satisfy the equations of the sample.
TEST_P(Usac_Solvers_Problem, gridPointsAreSafe)
{
    const ProblemType problem = (ProblemType)GetParam();
    const Ptr<MinimalSolver> solver = solverOf(problem);
    const int sample[MAX_SAMPLE_SIZE] = {0, 1, 2, 3, 4, 5, 6, 7};
    RNG rng(12);
    int solved = 0, wrong = 0;
    for (int repeat = 0; repeat < 3000; ++repeat)
    {
        std::vector<Point2d> points1, points2;
        for (int i = 0; i < 8; ++i)
        {
            points1.push_back(integerPoint(rng, -2, 3));
            // in every third sample, the points of both images are equal, so that there is no
            // parallax
            points2.push_back(repeat % 3 ? integerPoint(rng, -2, 3) : points1.back());
        }
        const OwnPoints points(problem, points1, points2);
        const std::vector<Model> models = solveFirst(*solver, points.view());
        for (size_t k = 0; k < models.size(); ++k, ++solved)
            wrong += !(constraintError(points.view(), sample, solver->sampleSize(), models[k]) <
                       1e-6);
    }
    EXPECT_GT(solved, 300);
    EXPECT_EQ(0, wrong);
}

//! If the entries of H, which are products of triangle areas and coordinates, are so small that
//! their squares underflow, the solver must return no homography.
TEST(Usac_Solvers, homographyOfTinySquares)
{
    std::vector<Point2d> corners;
    for (int i = 0; i < 4; ++i)
        corners.push_back(Point2d(i % 2, i / 2));
    const double scales[] = {1, 1e-15, 1e-20, 1e-150};
    const Ptr<MinimalSolver> solver = solverOf(HOMOGRAPHY);
    for (int s = 0; s < 4; ++s)
    {
        std::vector<Point2d> tiny = corners;
        for (int i = 0; i < 4; ++i)
            tiny[i] *= scales[s];
        EXPECT_EQ(s < 2 ? 1u : 0u,
                  solveFirst(*solver, OwnPoints(HOMOGRAPHY, tiny, tiny).view()).size())
            << scales[s];
    }
}

}  // namespace
}  // namespace opencv_test
