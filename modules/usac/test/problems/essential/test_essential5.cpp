// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/eigenvalues.hpp"
#include "support/problem_objects.hpp"

#include <array>
#include <Eigen/LU>

namespace opencv_test {
namespace {

//! A camera motion and the properties of its scene, which has no outliers.
struct Case
{
    const char* name;
    Motion motion;
    double angle, baseline, plane, nearest, farthest;
};

const Case CASES[] = {{"general", MOTION_GENERAL, 12, 1, 0, 4, 9},
                      {"forward", MOTION_FORWARD, 0, 1, 0, 4, 9},
                      {"forward_turning", MOTION_FORWARD, 2, 1, 0, 4, 9},
                      {"sideways", MOTION_SIDEWAYS, 0, 1, 0, 4, 9},
                      {"sideways_over_frontal_plane", MOTION_SIDEWAYS, 0, 1, 1, 4, 9},
                      {"rectified", MOTION_RECTIFIED, 0, 1, 0, 4, 9},
                      {"aerial", MOTION_RECTIFIED, 0, 1, 0, 5.4, 6.6},
                      {"plane", MOTION_GENERAL, 12, 1, 1, 4, 9},
                      {"planar", MOTION_PLANAR, 10, 1, 0, 4, 9},
                      {"car", MOTION_CAR, 10, 1, 0, 4, 9},
                      {"small_baseline", MOTION_GENERAL, 12, 1e-3, 0, 4, 9}};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

typedef testing::TestWithParam<Case> Usac_Essential5;

//! Number of samples in a scene. Each sample consists of five consecutive matches.
enum { SAMPLES = 500 };

Scene sceneOf(const Case& c, uint64 seed, double noise)
{
    SceneOptions options;
    options.inliers = 5 * SAMPLES;
    options.outliers = 0;
    options.noise = noise;
    options.seed = seed;
    options.motion = c.motion;
    options.angle = c.angle;
    options.baseline = c.baseline;
    options.planeFraction = c.plane;
    options.frontalPlane = c.motion != MOTION_GENERAL;
    options.nearest = c.nearest;
    options.farthest = c.farthest;
    return makeScene(ESSENTIAL, options);
}

Ptr<OwnPoints> normalizedPoints(const Scene& scene)
{
    const Matx33d Kinv = scene.K.inv();
    std::vector<Point2d> points[2];
    for (int image = 0; image < 2; ++image)
        for (int i = 0; i < scene.size(); ++i)
        {
            const Point2d& p = (image ? scene.points2 : scene.points1)[i];
            const Vec3d x = Kinv * Vec3d(p.x, p.y, 1);
            points[image].push_back(Point2d(x[0], x[1]));
        }
    return makePtr<OwnPoints>(ESSENTIAL, points[0], points[1]);
}

double closest(const Model* models, int count, const Matx33d& model)
{
    double distance = 2;
    for (int k = 0; k < count; ++k)
        distance = std::min(distance, modelDistance(models[k], model));
    return distance;
}

//! How far the singular values of a matrix of unit norm are from those of an essential matrix: the
//! third singular value or, if larger, the difference of the first two.
double violation(const Matx33d& E)
{
    Vec3d w;
    SVD::compute(E, w);
    return std::max(w[0] - w[1], w[2]);
}

TEST_P(Usac_Essential5, finds_the_motion_of_exact_points)
{
    const Ptr<MinimalSolver> solver = createEssential5Solver();
    int samples = 0, near = 0, exact = 0, models = 0;
    double worst = 0;
    for (uint64 seed = 1; samples < 100000; ++seed)
    {
        const Scene scene = sceneOf(GetParam(), seed, 0);
        const Ptr<OwnPoints> points = normalizedPoints(scene);
        for (int k = 0; k < SAMPLES; ++k, ++samples)
        {
            const int sample[5] = {5 * k, 5 * k + 1, 5 * k + 2, 5 * k + 3, 5 * k + 4};
            Model found[MAX_MODELS];
            const int count = solver->solve(points->view(), sample, found);
            const double distance = closest(found, count, scene.model);
            near += distance < 1e-2;
            exact += distance < 1e-6;
            models += count;
            for (int i = 0; i < count && samples % 10 == 0; ++i)
                worst = std::max(worst, violation(found[i]));
        }
    }
    // With a baseline of 1/1000, rounding errors change the motion about a thousand times as much
    // as with a baseline of 1.
    EXPECT_GE(exact, samples * (GetParam().baseline < 1 ? 0.993 : 0.998));
    EXPECT_GE(near, samples * (GetParam().baseline < 1 ? 0.995 : 0.998));
    EXPECT_LE(worst, 1e-8);
    EXPECT_LE(models, 6 * samples);
}

//! Exponents of x, y and z in the monomials up to degree 3. A Cubic has a coefficient for each.
const int MONOMIALS[20][3] = {{3, 0, 0}, {2, 1, 0}, {2, 0, 1}, {1, 2, 0}, {1, 1, 1},
                              {1, 0, 2}, {0, 3, 0}, {0, 2, 1}, {0, 1, 2}, {0, 0, 3},
                              {2, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 2, 0}, {0, 1, 1},
                              {0, 0, 2}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
typedef std::array<long double, 20> Cubic;

//! sum += factor * a * b, where the degree of the product must not exceed 3
void addProduct(const Cubic& a, const Cubic& b, long double factor, Cubic& sum)
{
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20 && a[i] != 0; ++j)
            for (int k = 0; k < 20 && b[j] != 0; ++k)
                if (MONOMIALS[i][0] + MONOMIALS[j][0] == MONOMIALS[k][0] &&
                    MONOMIALS[i][1] + MONOMIALS[j][1] == MONOMIALS[k][1] &&
                    MONOMIALS[i][2] + MONOMIALS[j][2] == MONOMIALS[k][2])
                    sum[k] += factor * a[i] * b[j];
}

//! The ten constraints on E = N (x, y, z, 1)^T as coefficients of cubics, one per row.
MatrixXl constraintsOn(const MatrixXl& N)
{
    Cubic E[3][3], EEt[3][3], zero = {}, trace = {};
    for (int i = 0; i < 9; ++i)
    {
        E[i / 3][i % 3] = zero;
        for (int k = 0; k < 4; ++k)
            E[i / 3][i % 3][16 + k] = N(i, k);
    }
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
        {
            EEt[i][j] = zero;
            for (int k = 0; k < 3; ++k)
                addProduct(E[i][k], E[j][k], 1, EEt[i][j]);
            for (int k = 0; k < 20 && i == j; ++k)
                trace[k] += EEt[i][j][k];
        }
    MatrixXl C(10, 20);
    for (int row = 0; row < 10; ++row)
    {
        Cubic sum = zero;
        for (int k = 0; k < 3; ++k)
            if (row < 9)
                addProduct(EEt[row / 3][k], E[k][row % 3], 1, sum);
            else
            {
                Cubic minor = zero;
                addProduct(E[1][(k + 1) % 3], E[2][(k + 2) % 3], 1, minor);
                addProduct(E[1][(k + 2) % 3], E[2][(k + 1) % 3], -1, minor);
                addProduct(minor, E[0][k], 1, sum);
            }
        if (row < 9)
            addProduct(trace, E[row / 3][row % 3], -0.5L, sum);
        for (int k = 0; k < 20; ++k)
            C(row, k) = sum[k];
    }
    return C;
}

/** All real essential matrices of five points, computed in long double from the eigenvectors of the
action matrix @cite stewenius2006recent. The tested solver uses another method, so that the errors
of both are independent. */
std::vector<Matx33d> reference(const Correspondences& p, const int* sample)
{
    MatrixXl A(5, 9), G(4, 4);
    for (int k = 0; k < 5; ++k)
    {
        const int i = sample[k];
        const long double x1[] = {p.exact[X1][i], p.exact[Y1][i], 1},
                          x2[] = {p.exact[X2][i], p.exact[Y2][i], 1};
        for (int j = 0; j < 9; ++j)
            A(k, j) = x2[j / 3] * x1[j % 3];
    }
    RNG rng(77);
    for (int i = 0; i < 16; ++i)
        G(i / 4, i % 4) = rng.gaussian(1);
    const MatrixXl N = A.fullPivLu().kernel() * G;
    const MatrixXl C = constraintsOn(N), S = C.leftCols(10).fullPivLu().solve(C.rightCols(10));
    // matrix of the multiplication by x in the basis x2 xy xz y2 yz z2 x y z 1
    MatrixXl action = MatrixXl::Zero(10, 10);
    action.topRows(6) = -S.topRows(6);
    action(6, 0) = action(7, 1) = action(8, 2) = action(9, 6) = 1;
    MatrixXcl vectors;
    const MatrixXcl values = eigenvaluesOf(action, &vectors);
    std::vector<Matx33d> result;
    for (int i = 0; i < 10; ++i)
    {
        const std::complex<long double> value = values(i);
        if (std::abs(value.imag()) > 1e-9L * (1 + std::abs(value.real())))
            continue;
        const MatrixXl v = vectors.col(i).real().bottomRows(4);
        const MatrixXl E = N * v;
        Matx33d model;
        for (int k = 0; k < 9; ++k)
            model.val[k] = (double)(E(k) / E.norm());
        result.push_back(model);
    }
    return result;
}

TEST_P(Usac_Essential5, finds_all_solutions_of_noisy_points)
{
    const Ptr<MinimalSolver> solver = createEssential5Solver();
    int all = 0, found = 0, more = 0;
    const Scene scene = sceneOf(GetParam(), 1, 0.5);
    const Ptr<OwnPoints> points = normalizedPoints(scene);
    for (int k = 0; k < 300; ++k)
    {
        const int sample[5] = {5 * k, 5 * k + 1, 5 * k + 2, 5 * k + 3, 5 * k + 4};
        const std::vector<Matx33d> expected = reference(points->view(), sample);
        Model models[MAX_MODELS];
        const int count = solver->solve(points->view(), sample, models);
        all += (int)expected.size();
        more += std::max(count - (int)expected.size(), 0);
        for (size_t i = 0; i < expected.size(); ++i)
            found += closest(models, count, expected[i]) < 1e-6;
    }
    EXPECT_GT(all, 900);
    EXPECT_GE(found, (GetParam().baseline < 1 ? 0.995 : 0.998) * all);
    EXPECT_LE(more, 0.005 * all);
}

INSTANTIATE_TEST_CASE_P(Motions, Usac_Essential5, testing::ValuesIn(CASES));

}  // namespace
}  // namespace opencv_test
