// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/linear_map.hpp"
#include "support/own_points.hpp"
#include "support/contracts.hpp"
#include "problems/affinity/affinity.hpp"
#include "problems/registry.hpp"
#include "problems/similarity/similarity.hpp"

#include "opencv2/usac/geometry.hpp"

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

struct MapScene
{
    MapScene(ProblemType type_, int inliers_, int outliers, double noise, uint64 seed = 1)
        : type(type_), inliers(inliers_)
    {
        RNG rng(seed);
        truth = randomMap(type, rng);
        for (int i = 0; i < inliers + outliers; ++i)
        {
            const Point2d p = uniformPoint(rng, 0., 640., 0., 480.);
            const Vec2d q = truth * Vec3d(p.x, p.y, 1);
            points1.push_back(p);
            points2.push_back(i < inliers ? Point2d(q[0], q[1]) + gaussianPoint(rng, noise)
                                          : uniformPoint(rng, -640., 640.));
        }
    }

    Mat estimate(const Params& params, OutputArray mask, Report& report) const
    {
        return type == AFFINITY ? estimateAffinity2D(points1, points2, params, mask, report)
                                : estimateSimilarity2D(points1, points2, params, mask, report);
    }

    //! Root mean square distance in pixels, over the true matches, between the points to which
    //! `map` and the true map move the same point.
    double error(const Mat& map) const
    {
        double sum = 0;
        for (int i = 0; i < inliers; ++i)
        {
            const Vec3d x(points1[i].x, points1[i].y, 1);
            sum += normL2Sqr((Matx23d(map.ptr<double>()) - truth) * x);
        }
        return std::sqrt(sum / inliers);
    }

    static double normL2Sqr(const Vec2d& v) { return v.dot(v); }

    const ProblemType type;
    const int inliers;
    Matx23d truth;
    std::vector<Point2d> points1, points2;
};

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

template <class Parameters>
void checkParameters(ProblemType type)
{
    RNG rng(3);
    const Matx23d map = randomMap(type, rng);
    const Model model = Matx33d(map(0, 0), map(0, 1), map(0, 2), map(1, 0), map(1, 1), map(1, 2), 0,
                                0, 1);
    const Parameters here(model);
    const Model same = here.model();
    for (int k = 0; k < 9; ++k)
        EXPECT_NEAR(model.val[k], same.val[k], 1e-12);
    NormalEquations sums;
    sums.JtJ.setRandom();
    sums.JtJ = (sums.JtJ * sums.JtJ.transpose()).eval();
    sums.Jtr.setRandom();
    typename Parameters::Matrix A;
    typename Parameters::Step b, step;
    here.project(sums, A, b);
    const typename Parameters::Basis basis = here.tangent();
    EXPECT_LE((A - basis.transpose() * sums.JtJ * basis).norm(), 1e-12 * A.norm());
    EXPECT_LE((b - basis.transpose() * sums.Jtr).norm(), 1e-12 * b.norm());
    for (int k = 0; k < Parameters::DIMENSION; ++k)
    {
        step.setZero();
        step[k] = 0.25;
        const Model moved = here.plus(step).model();
        for (int i = 0; i < 9; ++i)
            EXPECT_NEAR(basis(i, k) * 0.25, moved.val[i] - same.val[i], 1e-12);
    }
    EXPECT_TRUE(here.hasFullRank());
    EXPECT_FALSE(Parameters(Matx33d(0, 0, 1, 0, 0, 2, 0, 0, 1)).hasFullRank());
}

TEST(Usac_PlaneMaps, parameters)
{
    checkParameters<AffinityParameterization>(AFFINITY);
    checkParameters<SimilarityParameterization>(SIMILARITY);
}

//! A fit must agree with the least-squares solution of the linear equations, because both minimize
//! the same sum for these maps.
TEST(Usac_PlaneMaps, leastSquares)
{
    for (int t = 0; t < 2; ++t)
    {
        MapScene scene(TYPES[t], 50, 0, 1);
        RNG rng(4);
        std::vector<double> weights;
        std::vector<int> all;
        for (int i = 0; i < 50; ++i)
        {
            scene.points1[i] = (scene.points1[i] - Point2d(320, 240)) *
                               0.005;  // coordinates of about 1, as in a search
            scene.points2[i] *= 0.005;
            weights.push_back(rng.uniform(0.1, 1.));
            all.push_back(i);
        }
        const Matx23d expected = linearMap(TYPES[t], scene.points1, scene.points2, weights);
        const OwnPoints own(HOMOGRAPHY, scene.points1, scene.points2);
        const Ptr<Problem> problem = problemOf(TYPES[t]);
        Model model = Matx33d(1, 0.1, 3, -0.1, 1, 4, 0, 0, 1);
        const Ptr<NonMinimalSolver> fit = problem->createNonMinimalSolver(
            problem->createResidual(RESIDUAL_STANDARD));
        ASSERT_TRUE(fit->fit(own.view(), all.data(), 50, weights.data(), model));
        for (int k = 0; k < 6; ++k)
            EXPECT_NEAR(expected.val[k], model.val[k], 1e-10) << t << " " << k;
    }
}

TEST(Usac_PlaneMaps, everyPreset)
{
    for (int t = 0; t < 2; ++t)
    {
        const std::vector<NamedPreset> presets = allPresets(TYPES[t]);
        for (size_t k = 0; k < presets.size(); ++k)
            for (uint64 seed = 1; seed <= 3; ++seed)
            {
                const MapScene scene(TYPES[t], 200, 150, 0.5, seed);
                Params params = presets[k].params;
                params.threshold = 2;
                params.maxIterations = 5000;
                params.confidence = 0.9999;
                Mat mask;
                Report report;
                const Mat map = scene.estimate(params, mask, report);
                ASSERT_EQ(Size(3, 2), map.size()) << t << " " << presets[k].name;
                // the true matches come first: where all samples follow this order (orderedEvery is
                // 1), PROSAC's criterion can end the search early, and a larger error is allowed
                EXPECT_LE(scene.error(map), params.orderedEvery == 1 ? 0.6 : 0.45)
                    << t << " " << presets[k].name;
                EXPECT_EQ(report.inliers, countNonZero(mask));
                EXPECT_LE(report.chance, 1e-6);
                if (t == 1)
                {
                    EXPECT_EQ(map.at<double>(0, 0), map.at<double>(1, 1));
                    EXPECT_EQ(map.at<double>(0, 1), -map.at<double>(1, 0));
                }
            }
    }
}

//! The mask must be 1 exactly where the error under the returned map is at most the threshold.
TEST(Usac_PlaneMaps, mask)
{
    for (int t = 0; t < 2; ++t)
        for (uint64 seed = 1; seed <= 20; ++seed)
        {
            MapScene scene(TYPES[t], 60, 200, 1, seed);
            scene.points1[5].x = scene.points2[70].y = std::numeric_limits<double>::quiet_NaN();
            Mat mask;
            Report report;
            const Mat map = scene.estimate(Params(), mask, report);
            ASSERT_FALSE(map.empty());
            for (size_t i = 0; i < scene.points1.size(); ++i)
            {
                const Vec2d q = Matx23d(map.ptr<double>()) *
                                Vec3d(scene.points1[i].x, scene.points1[i].y, 1);
                const double error = std::hypot(q[0] - scene.points2[i].x,
                                                q[1] - scene.points2[i].y);
                if (!(std::abs(error - report.threshold) < 1e-9))
                {
                    ASSERT_EQ(error <= report.threshold, mask.at<uchar>((int)i) != 0)
                        << t << " " << seed << " " << i;
                }
            }
        }
}

//! The sum of the errors over the scenes must be at most 1.02 times that of OpenCV's RANSAC.
TEST(Usac_PlaneMaps, besideOpenCV)
{
    for (int t = 0; t < 2; ++t)
        for (int hard = 0; hard < 2; ++hard)
        {
            double ours = 0, theirs = 0;
            for (uint64 seed = 1; seed <= 30; ++seed)
            {
                const MapScene scene(TYPES[t], hard ? 40 : 100, hard ? 160 : 100, 1, seed);
                Params params;
                Report report;
                const Mat map = scene.estimate(params, noArray(), report);
                const Mat other = t == 0 ? cv::estimateAffine2D(scene.points1, scene.points2,
                                                                noArray(), RANSAC, 3)
                                         : cv::estimateAffinePartial2D(scene.points1, scene.points2,
                                                                       noArray(), RANSAC, 3);
                ASSERT_FALSE(map.empty()) << t << " " << seed;
                ours += scene.error(map);
                theirs += other.empty() ? 10 : scene.error(other);
            }
            EXPECT_LE(ours, 1.02 * theirs) << t << " " << hard;
        }
}

TEST(Usac_PlaneMaps, anyNumberOfThreads)
{
    for (int t = 0; t < 2; ++t)
    {
        const MapScene scene(TYPES[t], 40, 400, 1);
        Params params;
        Report report;
        const Mat one = scene.estimate(params, noArray(), report);
        for (params.threads = 2; params.threads <= 4; ++params.threads)
            EXPECT_EQ(0, cv::norm(one, scene.estimate(params, noArray(), report), NORM_INF));
    }
}

TEST(Usac_PlaneMaps, impossiblePoints)
{
    std::vector<Point2d> same(50, Point2d(3, 4)), line, random1, random2;
    RNG rng(6);
    for (int i = 0; i < 50; ++i)
    {
        line.push_back(Point2d(i, 2 * i));
        random1.push_back(uniformPoint(rng, 0., 600.));
        random2.push_back(uniformPoint(rng, 0., 600.));
    }
    for (int t = 0; t < 2; ++t)
    {
        const std::vector<Point2d>* const firsts[] = {&same, &same, t == 0 ? &line : &same,
                                                      &random1};
        const std::vector<Point2d>* const seconds[] = {&same, &random2, &line, &same};
        for (int i = 0; i < 4; ++i)
        {
            Params params;
            params.maxIterations = 500;
            Mat mask;
            Report report;
            const Mat map = t == 0
                                ? estimateAffinity2D(*firsts[i], *seconds[i], params, mask, report)
                                : estimateSimilarity2D(*firsts[i], *seconds[i], params, mask,
                                                       report);
            EXPECT_TRUE(map.empty()) << t << " " << i;
            EXPECT_EQ(0, countNonZero(mask));
        }
        Report report;
        const std::vector<Point2d> one(1, Point2d(0, 0));
        EXPECT_TRUE(estimateSimilarity2D(one, one, Params(), noArray(), report).empty());
        EXPECT_EQ((int)STOP_TOO_FEW_POINTS, report.stop);
    }
}

}  // namespace
}  // namespace opencv_test
