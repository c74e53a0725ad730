// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

// Tests of few points, a threshold far above their noise, and strong perspective. Sums of squared
// errors then have local minima, and even the first model of a search has all points as inliers.

namespace opencv_test {
namespace {

//! All flags. The last two polish otherwise, or with an estimated threshold.
const UsacV20Method ALL_FLAGS[] = {USACV20,        USACV20_FAST,     USACV20_ACCURATE,
                                   USACV20_PROSAC, USACV20_PARALLEL, USACV20_MAGSAC,
                                   USACV20_AUTO};
enum { FLAG_COUNT = 7 };

//! Points without outliers, and the true model.
struct FewPoints
{
    ProblemType problem;
    Mat points1, points2;
    std::vector<double> truth;
    double threshold;  //!< in pixels: the default of OpenCV's function for the problem

    Ptr<Usac> create(UsacV20Method flag) const
    {
        Params params = Params::fromMethod(flag);
        params.threshold = threshold;
        params.maxIterations = 1000;
        const Mat K = problem == ESSENTIAL || problem == ABSOLUTE_POSE ? Mat(Matx33d::eye())
                                                                       : Mat();
        return Usac::create(problem, points1, points2, params, K);
    }
};

Vec3d direction(RNG& rng)
{
    const Vec3d v = gaussianVector(rng, 1);
    return v * (1 / cv::norm(v));
}

//! Points for H in a circle of radius 100. The horizon, the line that H maps to infinity, is at the
//! distance `horizon` from the center.
FewPoints planePoints(int count, double horizon, double noise, RNG& rng)
{
    const double towards = rng.uniform(0., 2 * CV_PI), angle = rng.uniform(0., 2 * CV_PI);
    const Point2d shift = uniformPoint(rng, -50., 50.);
    const Matx33d A(std::cos(angle), -std::sin(angle), shift.x, std::sin(angle), std::cos(angle),
                    shift.y, 0, 0, 100);
    const Matx33d H = A * Matx33d(1, 0, 0, 0, 1, 0, std::cos(towards) / horizon,
                                  std::sin(towards) / horizon, 1);
    std::vector<Point2d> points1, points2;
    while ((int)points1.size() < count)
    {
        const double radius = 100 * std::sqrt(rng.uniform(0., 1.)), at = rng.uniform(0., 2 * CV_PI);
        const Point2d p(radius * std::cos(at), radius * std::sin(at));
        const Vec3d q = H * Vec3d(p.x, p.y, 1);
        // too close to the horizon: the denominator is below 1/20 of that at the center
        if (std::abs(q[2]) < 5)
            continue;
        points1.push_back(p);
        points2.push_back(Point2d(q[0] / q[2], q[1] / q[2]) + gaussianPoint(rng, noise));
    }
    const FewPoints points = {HOMOGRAPHY, Mat(points1, true), Mat(points2, true),
                              std::vector<double>(H.val, H.val + 9), 3};
    return points;
}

//! Points for F, E or a pose with focal length 1. The epipole is among the points, and some points
//! can be near camera 2.
FewPoints spacePoints(ProblemType problem, int count, double noise, RNG& rng)
{
    Matx33d R;
    Rodrigues(direction(rng) * rng.uniform(0.1, 0.5), R);
    const Point2d side = uniformPoint(rng, -0.3, 0.3);
    Vec3d t(side.x, side.y, 1);
    t *= (problem == ABSOLUTE_POSE ? -0.3 : 1) / cv::norm(t);
    std::vector<Point2d> points1, points2;
    std::vector<Point3d> space;
    while ((int)points2.size() < count)
    {
        const double depth = rng.uniform(0.5, 3.);
        const Point2d ray = uniformPoint(rng, -0.6, 0.6);
        const Vec3d X(ray.x * depth, ray.y * depth, depth), Y = R * X + t;
        if (Y[2] < 0.15)
            continue;
        space.push_back(Point3d(X[0], X[1], X[2]));
        points1.push_back(Point2d(X[0] / X[2], X[1] / X[2]) + gaussianPoint(rng, noise));
        points2.push_back(Point2d(Y[0] / Y[2], Y[1] / Y[2]) + gaussianPoint(rng, noise));
    }
    const Matx33d E = Matx33d(0, -t[2], t[1], t[2], 0, -t[0], -t[1], t[0], 0) * R;
    const Matx34d P(R(0, 0), R(0, 1), R(0, 2), t[0], R(1, 0), R(1, 1), R(1, 2), t[1], R(2, 0),
                    R(2, 1), R(2, 2), t[2]);
    const bool pose = problem == ABSOLUTE_POSE;
    const FewPoints points = {
        problem, pose ? Mat(space, true) : Mat(points1, true), Mat(points2, true),
        pose ? std::vector<double>(P.val, P.val + 12) : std::vector<double>(E.val, E.val + 9),
        pose                   ? 8.
        : problem == ESSENTIAL ? 1.
                               : 3.};
    return points;
}

//! Root mean square error of all points in the internal coordinates of the search.
double errorOf(const Usac& usac_, const Model& model)
{
    Usac& usac = const_cast<Usac&>(usac_);
    const Correspondences& points = usac.points();
    std::vector<double> errors(points.size);
    usac.components().residual->squaredErrors(model, points.exact, points.size, errors.data());
    return std::sqrt(cv::sum(errors)[0] / points.size);
}

//! Least squares over all points, started at a model.
Model leastSquares(Usac& usac, Model model)
{
    const Correspondences& points = usac.points();
    std::vector<int> all(points.size);
    for (int i = 0; i < points.size; ++i)
        all[i] = i;
    for (int i = 0; i < 5; ++i)
        usac.components().nonMinimalSolver->fit(points, all.data(), points.size, 0, model, 20);
    return model;
}

Model modelOf(const Usac& usac, const std::vector<double>& output)
{
    const Correspondences& points = const_cast<Usac&>(usac).points();
    Model model;
    EXPECT_TRUE(points.problem->fromOutput(output, points, model));
    return model;
}

//! With each of the first `flags` of ALL_FLAGS, the error must be at most 1.1 times that of least
//! squares started at the true model.
void expectLeastSquares(const FewPoints& points, const String& name, int flags = FLAG_COUNT)
{
    for (int k = 0; k < flags; ++k)
    {
        const Ptr<Usac> usac = points.create(ALL_FLAGS[k]);
        Mat model = usac->run();
        ASSERT_FALSE(model.empty()) << name << ", flag " << (int)ALL_FLAGS[k];
        const std::vector<double> output(model.ptr<double>(), model.ptr<double>() + model.total());
        const double best = errorOf(*usac, leastSquares(*usac, modelOf(*usac, points.truth)));
        EXPECT_LE(errorOf(*usac, modelOf(*usac, output)), 1.1 * best + 1e-9)
            << name << ", flag " << (int)ALL_FLAGS[k];
    }
}

/** The horizon is near the points or between them. A homography allows points on both sides of the
horizon, although no camera sees both sides. If the horizon is between the points, most samples have
points on both sides, so that the orientation check rejects them. (If it rejects all samples,
because three of six points are on each side, there is no model.) */
TEST(Usac_FewPoints, horizonNearOrBetweenThePoints)
{
    const int counts[] = {8, 10, 14, 20};
    for (int k = 0; k < 4; ++k)
        for (int seed = 1; seed <= 20; ++seed)
        {
            RNG rng(1000 * k + seed);
            const double horizon = seed % 4 ? rng.uniform(20., 80.) : rng.uniform(105., 150.);
            expectLeastSquares(
                planePoints(counts[k], horizon, 1e-3, rng),
                format("%d points, horizon at %.0f, seed %d", counts[k], horizon, seed),
                horizon < 100 ? FLAG_COUNT - 2 : FLAG_COUNT);
        }
}

TEST(Usac_FewPoints, epipoleBetweenThePoints)
{
    const ProblemType problems[] = {FUNDAMENTAL, ESSENTIAL, ABSOLUTE_POSE};
    for (int k = 0; k < 3; ++k)
        for (int count = k == 0 ? 8 : 6; count <= 20; count += 4)
            for (int seed = 1; seed <= (count == 6 ? 40 : 10); ++seed)
            {
                RNG rng(100 * count + seed);
                expectLeastSquares(
                    spacePoints(problems[k], count, 1e-3, rng),
                    format("problem %d, %d points, seed %d", (int)problems[k], count, seed));
            }
}

//! Exact points, `behind` of which are behind the second camera and the others in front of it, so
//! that the orientation checks reject the true model in most samples. A search must nevertheless
//! return a model that has all points as inliers.
void bothSides(int count, int behind, RNG& rng, std::vector<Point2d>& points1,
               std::vector<Point2d>& points2)
{
    Matx33d R;
    Rodrigues(direction(rng) * rng.uniform(1.5, 2.), R);
    points1.clear();
    points2.clear();
    while ((int)points1.size() < count)
    {
        const Vec3d X = uniformVector(rng, Vec3d(0., 0., 10.), Vec3d(10., 10., 20.));
        const bool back = (int)points1.size() < behind;
        const Vec3d Y = R * (X - Vec3d(5, 5, 15)) + Vec3d(2, 1, 1);
        if ((Y[2] < 0) != back)
            continue;
        points1.push_back(Point2d(X[0] / X[2], X[1] / X[2]));
        points2.push_back(Point2d(Y[0] / Y[2], Y[1] / Y[2]));
    }
}

TEST(Usac_FewPoints, onBothSidesOfACamera)
{
    for (UsacV20Method flag : ALL_FLAGS)
        for (int seed = 1; seed <= 20; ++seed)
        {
            RNG rng(seed);
            std::vector<Point2d> points1, points2;
            bothSides(16, 4, rng, points1, points2);
            Params params = Params::fromMethod(flag);
            params.threshold = 1e-4;
            params.maxIterations = 1000;
            Mat mask;
            Usac::create(ESSENTIAL, points1, points2, params, Matx33d::eye())->run(mask);
            EXPECT_EQ(16, countNonZero(mask)) << "flag " << (int)flag << ", seed " << seed;
        }
}

}
}  // namespace
