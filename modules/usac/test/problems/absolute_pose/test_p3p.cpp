// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "pose_samples.hpp"
#include "problems/absolute_pose/absolute_pose.hpp"

namespace opencv_test {
namespace {

std::vector<Matx34d> solve(const MinimalSolver& solver, const Vec3d (&X)[3],
                           const Point2d (&image)[3])
{
    double columns[5][3];
    Correspondences points;
    points.size = 3;
    for (int k = 0; k < 5; ++k)
    {
        for (int i = 0; i < 3; ++i)
            columns[k][i] = k < 3 ? X[i][k] : k == 3 ? image[i].x : image[i].y;
        points.exact[k] = columns[k];
    }
    const int sample[] = {0, 1, 2};
    Model models[MAX_MODELS];
    const int count = solver.solve(points, sample, models);
    EXPECT_GE(count, 0);
    EXPECT_LE(count, 4);
    return std::vector<Matx34d>(models, models + count);
}

struct Tally
{
    Tally()
        : samples(0), missed(0), falseRoots(0), repeated(0), notOrthonormal(0), most(0),
          solutions(0)
    {}

    void add(const PoseSample& s, const std::vector<Matx34d>& poses, double tolerance)
    {
        double closest = DBL_MAX;
        for (size_t k = 0; k < poses.size(); ++k)
        {
            const Matx33d R = poses[k].get_minor<3, 3>(0, 0);
            falseRoots += !(reprojectionError(s, poses[k]) < 1e-4);
            notOrthonormal += !(cv::norm(R * R.t() - Matx33d::eye()) < 1e-12 && determinant(R) > 0);
            for (size_t j = 0; j < k; ++j)
                repeated += !(poseDistance(s, poses[j], poses[k]) > 1e-8);
            closest = std::min(closest, poseDistance(s, poses[k], s.pose));
        }
        ++samples;
        missed += !(closest < tolerance);
        most = std::max(most, (int)poses.size());
        solutions += (int)poses.size();
    }

    void expectSound(const char* what) const
    {
        EXPECT_EQ(0, falseRoots) << what;
        EXPECT_EQ(0, repeated) << what;
        EXPECT_EQ(0, notOrthonormal) << what;
    }

    int samples, missed, falseRoots, repeated, notOrthonormal, most, solutions;
};

void expectTruth(int samples)
{
    const Ptr<MinimalSolver> solver = createP3PSolver();
    for (int kind = 0; kind < POSE_SAMPLE_KINDS; ++kind)
    {
        RNG rng(1 + kind);
        Tally tally;
        for (int i = 0; i < samples; ++i)
        {
            const PoseSample s = randomPoseSample((PoseSampleKind)kind, rng);
            tally.add(s, solve(*solver, s.X, s.image), 1e-6);
        }
        EXPECT_LE(tally.missed, samples / 10000) << POSE_SAMPLE_NAMES[kind];
        EXPECT_GT(tally.most, 1) << POSE_SAMPLE_NAMES[kind];
        tally.expectSound(POSE_SAMPLE_NAMES[kind]);
        if (cvtest::debugLevel > 0)
            printf("%s: %d missed of %d, %.2f poses a sample\n", POSE_SAMPLE_NAMES[kind],
                   tally.missed, samples, (double)tally.solutions / samples);
    }
}

TEST(Usac_P3P, exact) { expectTruth(20000); }

//! The poses of OpenCV's solver that reproject the points with errors below 1e-9.
std::vector<Matx34d> posesOfOpenCV(const PoseSample& s, int method)
{
    const std::vector<Point3d> X(s.X, s.X + 3);
    const std::vector<Point2d> image(s.image, s.image + 3);
    std::vector<Mat> rotations, translations;
    cv::solveP3P(X, image, Matx33d::eye(), noArray(), rotations, translations, method);
    std::vector<Matx34d> result;
    for (size_t k = 0; k < rotations.size(); ++k)
    {
        Matx33d R;
        cv::Rodrigues(rotations[k], R);
        Matx34d pose;
        hconcat(R, Vec3d(translations[k]), pose);
        if (reprojectionError(s, pose) < 1e-9)
            result.push_back(pose);
    }
    return result;
}

//! Number of poses in `some` that are not in `others`.
int countLacking(const PoseSample& s, const std::vector<Matx34d>& some,
                 const std::vector<Matx34d>& others)
{
    int result = 0;
    for (size_t k = 0; k < some.size(); ++k)
    {
        double closest = DBL_MAX;
        for (size_t j = 0; j < others.size(); ++j)
            closest = std::min(closest, poseDistance(s, some[k], others[j]));
        result += closest > 1e-4;
    }
    return result;
}

/** The solver must find all poses that OpenCV's solvers find. OpenCV's solvers miss 4 of the 3100
poses that this solver finds, or return them with errors so large that they cannot be distinguished
from wrong poses; in these cases, a point is close to the camera center. */
TEST(Usac_P3P, sameAsOpenCV)
{
    const Ptr<MinimalSolver> solver = createP3PSolver();
    const PoseSampleKind kinds[] = {CUBE, FRONTAL_PLANE, CLOSE, WIDE};
    for (PoseSampleKind kind : kinds)
    {
        RNG rng(100 + kind);
        int lacking = 0, more = 0, count = 0;
        for (int i = 0; i < 300; ++i)
        {
            const PoseSample s = randomPoseSample(kind, rng);
            const std::vector<Matx34d> poses = solve(*solver, s.X, s.image);
            std::vector<Matx34d> known = posesOfOpenCV(s, SOLVEPNP_AP3P);
            const std::vector<Matx34d> others = posesOfOpenCV(s, SOLVEPNP_P3P);
            known.insert(known.end(), others.begin(), others.end());
            lacking += countLacking(s, known, poses);
            more += countLacking(s, poses, known);
            count += (int)poses.size();
        }
        EXPECT_EQ(0, lacking) << POSE_SAMPLE_NAMES[kind];
        EXPECT_LE(more, 3) << POSE_SAMPLE_NAMES[kind];
        EXPECT_GT(count, 300) << POSE_SAMPLE_NAMES[kind];
    }
}

//! Tolerance of poseDistance() for nearly double solutions, which rounding can move by this much.
const double DOUBLE_SOLUTION = 1e-5;

//! The equations are singular if the camera center is on the cylinder through the circumscribed
//! circle of the triangle, with its axis perpendicular to the triangle. On and near this cylinder,
//! the true pose must be found nevertheless.
TEST(Usac_P3P, dangerCylinder)
{
    const Ptr<MinimalSolver> solver = createP3PSolver();
    for (double off : {0., 1e-12, 1e-8, 1e-6, 1e-4, -1e-12, -1e-8, -1e-6, -1e-4})
    {
        RNG rng(5);
        Tally tally;
        for (int i = 0; i < 3000; ++i)
        {
            const double start = rng.uniform(0., 6.28), at = rng.uniform(0., 6.28);
            const double angles[] = {start, start + rng.uniform(0.5, 2.),
                                     start + rng.uniform(2.5, 5.5)};
            const Vec3d center((1 + off) * std::cos(at), (1 + off) * std::sin(at),
                               rng.uniform(2., 6.));
            const PoseSample s = triangleSeenFrom(center, angles, rng);
            tally.add(s, solve(*solver, s.X, s.image), DOUBLE_SOLUTION);
        }
        EXPECT_EQ(0, tally.missed) << off;
        EXPECT_GT(tally.most, 2) << off;
        tally.expectSound("danger cylinder");
    }
}

//! Equilateral and isosceles triangles, seen from their planes of symmetry and from elsewhere, can
//! have double solutions. The true pose must be found nevertheless.
TEST(Usac_P3P, symmetric)
{
    const Ptr<MinimalSolver> solver = createP3PSolver();
    RNG rng(6);
    Tally tally;
    for (int apex = 20; apex <= 160; apex += 20)
        for (int shape = 0; shape < 3; ++shape)
            for (int k = 0; k <= 40; ++k)
            {
                const double half = shape == 0 ? 2 * CV_PI / 3 : apex * CV_PI / 180,
                             radius = 0.1 * k;
                const double angles[] = {0, half, -half};
                const Vec3d center(shape == 2 ? 0 : radius, shape == 2 ? radius : 0, 3);
                const PoseSample s = triangleSeenFrom(center, angles, rng);
                tally.add(s, solve(*solver, s.X, s.image), DOUBLE_SOLUTION);
            }
    EXPECT_EQ(0, tally.missed);
    EXPECT_EQ(4, tally.most);
    tally.expectSound("symmetric");
}

//! If the points are collinear, two points coincide or two rays are equal, there must be no model,
//! even if this holds only up to rounding.
TEST(Usac_P3P, degenerate)
{
    const Ptr<MinimalSolver> solver = createP3PSolver();
    RNG rng(8);
    for (int i = 0; i < 3000; ++i)
    {
        const PoseSample s = randomPoseSample((PoseSampleKind)(i % POSE_SAMPLE_KINDS), rng);
        PoseSample line = s, place = s, ray = s, repeated = s;
        const double at = i % 5 == 0 ? 0.5 : rng.uniform(-2., 3.);
        const int k = i % 3, other = (k + 1) % 3;
        line.X[k] = s.X[other] + at * (s.X[(k + 2) % 3] - s.X[other]);
        EXPECT_EQ(0u, solve(*solver, line.X, line.image).size());
        place.X[k] = s.X[other];
        EXPECT_EQ(0u, solve(*solver, place.X, place.image).size());
        ray.image[k] = s.image[other];
        EXPECT_EQ(0u, solve(*solver, ray.X, ray.image).size());
        ray.image[k].x += 4e-16 * ray.image[k].x;  // differs by rounding only
        EXPECT_EQ(0u, solve(*solver, ray.X, ray.image).size());
        repeated.X[k] = s.X[other];
        repeated.image[k] = s.image[other];
        EXPECT_EQ(0u, solve(*solver, repeated.X, repeated.image).size());
        repeated.X[(k + 2) % 3] = s.X[other];
        EXPECT_EQ(0u, solve(*solver, repeated.X, repeated.image).size());
        repeated.image[(k + 2) % 3] = s.image[other];
        EXPECT_EQ(0u, solve(*solver, repeated.X, repeated.image).size());
    }
}

//! Input that is not finite, or whose squares are not finite, must give no model.
TEST(Usac_P3P, notFinite)
{
    const Ptr<MinimalSolver> solver = createP3PSolver();
    const double wrong[] = {NAN, INFINITY, -INFINITY, DBL_MAX, -DBL_MAX, 1e160};
    RNG rng(9);
    for (int i = 0; i < 100; ++i)
    {
        const PoseSample s = randomPoseSample(CUBE, rng);
        for (double value : wrong)
            for (int k = 0; k < 15; ++k)
            {
                PoseSample other = s;
                (k < 9    ? other.X[k / 3][k % 3]
                 : k < 12 ? other.image[k - 9].x
                          : other.image[k - 12].y) = value;
                EXPECT_EQ(0u, solve(*solver, other.X, other.image).size()) << value << " at " << k;
            }
    }
}

//! Small integer coordinates make right angles, equal sides, equal points and other special cases.
//! All returned poses must be valid and different.
TEST(Usac_P3P, smallIntegers)
{
    const Ptr<MinimalSolver> solver = createP3PSolver();
    RNG rng(11);
    Tally tally;
    for (int i = 0; i < 100000; ++i)
    {
        PoseSample s;
        s.size = 1;
        for (int k = 0; k < 3; ++k)
        {
            s.X[k] = integerVector(rng, -2, 3);
            s.image[k] = integerPoint(rng, -2, 3);
        }
        tally.add(s, solve(*solver, s.X, s.image), 0);
    }
    EXPECT_GT(tally.solutions, 10000);
    EXPECT_LE(tally.most, 4);
    tally.expectSound("small integers");
}

}  // namespace
}  // namespace opencv_test
