// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "rigid_scenes.hpp"
#include "space_points.hpp"
#include "problems/rigid_motion/rigid_motion.hpp"

// Tests of the solver for 3-D motions from three points, with and without a scale.

namespace opencv_test {
namespace {

typedef std::vector<Vec3d> Triangle;

//! Solves for the motion. @return false if the solver gives no model
bool solve(bool scaled, const Triangle& from, const Triangle& to, Matx34d& motion)
{
    const SpacePoints own(from, to);
    Model models[MAX_MODELS];
    const int count = createTriangleSolver(scaled)->solve(own.view(), own.indices(), models);
    EXPECT_TRUE(count == 0 || count == 1);
    if (count == 1)
        motion = models[0];
    return count == 1;
}

//! Smallest height divided by the longest side: 0.87 for an equilateral triangle, 0 for collinear
//! points.
double thicknessOf(const Triangle& t)
{
    double longest = 0;
    for (int k = 0; k < 3; ++k)
        longest = std::max(longest, cv::norm(t[k] - t[(k + 1) % 3]));
    return cv::norm((t[1] - t[0]).cross(t[2] - t[0])) / (longest * longest);
}

double sizeOf(const Triangle& t)
{
    const Vec3d mean = (t[0] + t[1] + t[2]) * (1. / 3);
    return std::max(std::max(cv::norm(t[0] - mean), cv::norm(t[1] - mean)), cv::norm(t[2] - mean));
}

enum Kind { CUBE, EQUILATERAL, RIGHT_ANGLE, NEEDLE, FLAT, THIN, FAR_FROM_THE_ORIGIN, KINDS };
const char* const NAMES[] = {"cube", "equilateral", "right angle",        "needle",
                             "flat", "thin",        "far from the origin"};

//! A random triangle of this kind, with its corners in random order.
Triangle randomTriangle(Kind kind, RNG& rng)
{
    Triangle t(3);
    const Matx33d R = randomRotation(rng);
    const double at = rng.uniform(0.1, 0.9), tenth = rng.uniform(0.05, 0.15),
                 thin = std::pow(10., -rng.uniform(1., 9.));
    const Vec3d corners[][3] = {{Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0.5, std::sqrt(0.75), 0)},
                                {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, rng.uniform(0.3, 3.), 0)},
                                {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(1, 0.1 * tenth, 0)},
                                {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(at, 0.2 * tenth, 0)},
                                {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(at, thin, 0)}};
    const double far = kind == FAR_FROM_THE_ORIGIN ? 1000 : 1;
    const Vec3d offset = far * uniformVector(rng, -1., 1.);
    const int first = rng.uniform(0, 3), step = rng.uniform(1, 3);
    do
        for (int k = 0; k < 3; ++k)
        {
            const Vec3d any = uniformVector(rng, -1., 1.);
            const bool table = kind >= EQUILATERAL && kind <= THIN;
            t[(first + step * k) % 3] = (table ? R * corners[kind - EQUILATERAL][k] : any) + offset;
        }
    while (kind != THIN && thicknessOf(t) < 2e-3);
    return t;
}

//! The corners after a motion, rounded only once.
Triangle movedCorners(const Matx34d& motion, const Triangle& from)
{
    Triangle to(3);
    for (int k = 0; k < 3; ++k)
        for (int r = 0; r < 3; ++r)
        {
            long double sum = motion(r, 3);
            for (int c = 0; c < 3; ++c)
                sum += (long double)motion(r, c) * from[k][c];
            to[k][r] = (double)sum;
        }
    return to;
}

Matx34d randomMotion(bool scaled, RNG& rng)
{
    const double scale = scaled ? std::exp(rng.uniform(-3., 3.)) : 1;
    const Matx33d R = randomRotation(rng);
    return motionFrom(scale, R, scale * uniformVector(rng, -1., 1.));
}

//! Maximum of two distances, both relative to the scale of `truth`: of the linear parts (Frobenius
//! norm), and of the mapped means divided by the size of the triangle.
double motionDistance(const Matx34d& a, const Matx34d& truth, const Triangle& from)
{
    const double scale = cv::norm(truth.get_minor<3, 3>(0, 0)) / std::sqrt(3.);
    const Matx34d d = a - truth;
    const Vec3d mean = (from[0] + from[1] + from[2]) * (1. / 3);
    const double shift = cv::norm(d * Vec4d(mean[0], mean[1], mean[2], 1)) / sizeOf(from);
    return std::max(cv::norm(d.get_minor<3, 3>(0, 0)), shift) / scale;
}

double largestNumber(const Triangle& t)
{
    double largest = 0;
    for (int k = 0; k < 3; ++k)
        largest = std::max(largest, cv::norm(t[k], NORM_INF));
    return largest;
}

/** The angle in radians by which rounding of the corners can rotate a triangle about its longest
side. No solver can be more accurate. */
double indeterminacyOf(const Triangle& from, const Triangle& to)
{
    double result = 0;
    for (const Triangle* t : {&from, &to})
        result += DBL_EPSILON * largestNumber(*t) / (sizeOf(*t) * thicknessOf(*t));
    return result;
}

/** The true motion must be found within 1e-6, except for triangles so thin that rounding hides the
rotation: indeterminacyOf() is above 3e-8, or the smallest height is less than 2e-8 of the longest
side. (The solver treats triangles with a height below about 1.5e-8 of their longest side as
collinear.) */
void expectTruth(int samples)
{
    for (int scaled = 0; scaled < 2; ++scaled)
        for (int kind = 0; kind < KINDS; ++kind)
        {
            RNG rng(1 + kind);
            int missed = 0, hidden = 0, none = 0, notRotations = 0;
            double worst = 0;
            for (int i = 0; i < samples; ++i)
            {
                const Triangle from = randomTriangle((Kind)kind, rng);
                const Matx34d truth = randomMotion(scaled != 0, rng);
                const Triangle to = movedCorners(truth, from);
                const double unavoidable = indeterminacyOf(from, to);
                Matx34d found;
                if (unavoidable > 3e-8 || thicknessOf(from) < 2e-8)
                {
                    ++hidden;
                    continue;
                }
                if (!solve(scaled != 0, from, to, found))
                {
                    ++none;
                    continue;
                }
                const double error = motionDistance(found, truth, from);
                missed += !(error < 1e-6);
                worst = std::max(worst, error / unavoidable);
                const Matx33d A = found.get_minor<3, 3>(0, 0),
                              R = A * (std::sqrt(3.) / cv::norm(A));
                notRotations += !(cv::norm(R * R.t() - Matx33d::eye()) < 1e-12 &&
                                  determinant(R) > 0);
                notRotations += !scaled && !(std::abs(cv::norm(A) - std::sqrt(3.)) < 1e-12);
            }
            SCOPED_TRACE(
                cv::format("%s, %s", NAMES[kind], scaled ? "with a scale" : "without a scale"));
            EXPECT_EQ(0, missed);
            EXPECT_EQ(0, none);
            EXPECT_EQ(0, notRotations);
            EXPECT_LE(worst, 30) << "times the error that rounding explains";
            EXPECT_LE(hidden, kind == THIN ? 3 * samples / 10 : 0);
            if (cvtest::debugLevel > 0)
                printf("%s, scaled %d: error at most %.1f times the rounding, %d hidden\n",
                       NAMES[kind], scaled, worst, hidden);
        }
}

TEST(Usac_TriangleSolver, exact) { expectTruth(20000); }

double costOf(const Matx34d& motion, const Triangle& from, const Triangle& to)
{
    double sum = 0;
    for (int k = 0; k < 3; ++k)
    {
        const Vec3d off = moved(motion, Point3d(from[k])) - to[k];
        sum += off.dot(off);
    }
    return sum;
}

//! For triangles that do not correspond to each other, the solver must return the least-squares
//! motion.
TEST(Usac_TriangleSolver, leastSquaresOfAnyTriangles)
{
    for (int scaled = 0; scaled < 2; ++scaled)
    {
        const Ptr<NonMinimalSolver> fit = createRigidLeastSquares(scaled != 0);
        RNG rng(20);
        for (int i = 0; i < 20000; ++i)
        {
            const Kind kinds[] = {CUBE, EQUILATERAL, RIGHT_ANGLE, NEEDLE, FLAT};
            const Triangle from = randomTriangle(kinds[i % 5], rng),
                           to = randomTriangle(kinds[i / 5 % 5], rng);
            const SpacePoints own(from, to);
            Matx34d found;
            Model model;
            ASSERT_TRUE(solve(scaled != 0, from, to, found));
            ASSERT_TRUE(fit->fit(own.view(), own.indices(), 3, 0, model, 1));
            const Matx34d best = model;
            const double thin = thicknessOf(from) * thicknessOf(to), cost = costOf(best, from, to);
            EXPECT_NEAR(cost, costOf(found, from, to), 1e-13 * (1 + cost)) << i;
            EXPECT_LE(motionDistance(found, best, from), 1e-13 / thin) << i;
            EXPECT_GT(determinant(found.get_minor<3, 3>(0, 0)), 0) << i;
        }
    }
}

//! Points that are collinear or equal up to rounding, in either space, must give no model.
TEST(Usac_TriangleSolver, degenerate)
{
    RNG rng(23);
    for (int i = 0; i < 3000; ++i)
    {
        const bool scaled = i % 2 != 0;
        const Triangle right = randomTriangle(i % 3 ? CUBE : FAR_FROM_THE_ORIGIN, rng);
        const int k = i % 3, a = (k + 1) % 3, b = (k + 2) % 3;
        const double at = i % 5 == 0 ? 0.5 : rng.uniform(-2., 3.);
        Triangle line = right, pair = right, close = right, one = right;
        line[k] = right[a] + at * (right[b] - right[a]);
        pair[k] = right[a];
        for (int c = 0; c < 3; ++c)
            close[k][c] = right[a][c] * (1 + (c - 1) * DBL_EPSILON);
        one[a] = one[b] = one[k];
        for (const Triangle& wrong : {line, pair, close, one})
        {
            Matx34d motion;
            EXPECT_FALSE(solve(scaled, wrong, right, motion));
            EXPECT_FALSE(solve(scaled, right, wrong, motion));
            EXPECT_FALSE(solve(scaled, wrong, wrong, motion));
        }
    }
}

//! For the larger triangle, with two sides of 1e78 and one of 1e75, the squared area is finite, but
//! the fourth power of the longest side is not. The least-squares rotation and scale cannot be
//! computed, and the solver must return no model instead of NaN. For the smaller triangle, it must
//! return the identity.
TEST(Usac_TriangleSolver, tooLargeForDouble)
{
    for (double size : {1e70, 1e78})
        for (bool scaled : {false, true})
        {
            const Triangle needle = {Vec3d(0, 0, 0), Vec3d(size, 0, 0),
                                     Vec3d(size, 1e-3 * size, 0)};
            Matx34d motion;
            const bool found = solve(scaled, needle, needle, motion);
            EXPECT_EQ(size < 1e75, found) << size;
            EXPECT_TRUE(!found || cvtest::norm(motion - Matx34d::eye(), NORM_INF) < 1e-9 * size);
        }
}

//! With small integers as coordinates, three points are often collinear. There must be no model if
//! the points are collinear in at least one of the two spaces, and one model otherwise.
TEST(Usac_TriangleSolver, smallIntegers)
{
    RNG rng(24);
    int found = 0, none = 0;
    for (int i = 0; i < 30000; ++i)
    {
        Triangle t[2] = {Triangle(3), Triangle(3)};
        bool expected = true;
        for (int side = 0; side < 2; ++side)
        {
            for (int k = 0; k < 3; ++k)
            {
                const int z = rng.uniform(0, 2);
                const Point2d p = integerPoint(rng, -1, 2);
                t[side][k] = Vec3d(p.x, p.y, z);
            }
            // a thickness of 0 is exact here; it is NaN if all three points are equal
            expected = expected && thicknessOf(t[side]) > 0;
        }
        Matx34d motion;
        const bool solved = solve(i % 2 != 0, t[0], t[1], motion);
        EXPECT_EQ(expected, solved);
        (solved ? found : none) += 1;
        EXPECT_TRUE(!solved || checkRange(Mat(motion)));
    }
    EXPECT_GT(found, 10000);
    EXPECT_GT(none, 3000);
}

//! Input that is not finite, or whose squares are not finite, must give no model.
TEST(Usac_TriangleSolver, notFinite)
{
    const double wrong[] = {NAN, INFINITY, -INFINITY, DBL_MAX, -DBL_MAX, 1e160};
    RNG rng(25);
    for (int i = 0; i < 100; ++i)
    {
        const Triangle right = randomTriangle(CUBE, rng);
        for (double value : wrong)
            for (int k = 0; k < 9; ++k)
            {
                Triangle other = right;
                other[k / 3][k % 3] = value;
                Matx34d motion;
                EXPECT_FALSE(solve(i % 2 != 0, other, right, motion)) << value << " at " << k;
                EXPECT_FALSE(solve(i % 2 != 0, right, other, motion)) << value << " at " << k;
            }
    }
}

}  // namespace
}  // namespace opencv_test
