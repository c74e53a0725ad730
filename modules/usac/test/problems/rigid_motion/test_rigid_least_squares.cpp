// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "rigid_scenes.hpp"
#include "space_points.hpp"
#include "optimization/closest_rotation.hpp"
#include "optimization/least_squares.hpp"
#include "problems/rigid_motion/rigid_motion.hpp"
#include "problems/rigid_motion/rigid_parameterization.hpp"

// Tests of least squares in closed form for rigid motions and 3-D similarities, and of the
// parameterization of these motions.

namespace opencv_test {
namespace {

struct Fit
{
    Fit(bool scaled, const RigidScene& scene,
        const std::vector<double>& weights = std::vector<double>(), int count = -1)
    {
        const SpacePoints own(scene.points1, scene.points2);
        Model model;
        found = createRigidLeastSquares(scaled)->fit(
            own.view(), own.indices(), count < 0 ? scene.size() : count,
            weights.empty() ? 0 : weights.data(), model, 1);
        if (found)
            motion = model;
    }

    bool found;
    Matx34d motion;
};

RigidScene sceneOf(RigidShape shape, double noise, uint64 seed, double modelScale = 1)
{
    RigidSceneOptions options;
    options.size = 50;
    options.inlierRatio = 0.8;
    options.shape = shape;
    options.noise = noise;
    options.seed = seed;
    options.modelScale = modelScale;
    return makeRigidScene(options);
}

std::vector<double> randomWeights(int count, RNG& rng)
{
    std::vector<double> weights;
    for (int i = 0; i < count; ++i)
        weights.push_back(i % 7 == 3 ? 0 : rng.uniform(0.01, 1.));
    return weights;
}

double costOf(const RigidScene& scene, const std::vector<double>& weights, const Matx34d& motion)
{
    double sum = 0;
    for (int i = 0; i < scene.size(); ++i)
    {
        const Vec3d off = moved(motion, scene.points1[i]) - Vec3d(scene.points2[i]);
        sum += (weights.empty() ? 1 : weights[i]) * off.dot(off);
    }
    return sum;
}

const RigidShape SHAPES[] = {RIGID_CLOUD, RIGID_PLANE, RIGID_NEAR_PLANE, RIGID_NEAR_LINE,
                             RIGID_CLUSTER};

/** The derivatives of the cost with respect to the parameters, from finite differences, must be
zero, and random other motions must have a higher cost. */
template <bool SCALED>
void expectMinimum(const RigidScene& scene, const std::vector<double>& weights)
{
    typedef RigidParameterization<SCALED> Parameters;
    const Fit fit(SCALED, scene, weights);
    ASSERT_TRUE(fit.found);
    const double cost = costOf(scene, weights, fit.motion), h = 1e-4;
    const Parameters here((Model(fit.motion)));
    for (int k = 0; k < Parameters::DIMENSION; ++k)
    {
        double costs[2];
        for (int side = 0; side < 2; ++side)
        {
            typename Parameters::Step step = Parameters::Step::Zero();
            step[k] = side ? h : -h;
            costs[side] = costOf(scene, weights, Matx34d(here.plus(step).model()));
            EXPECT_GT(costs[side], cost) << "parameter " << k;
        }
        const double gradient = (costs[1] - costs[0]) / (2 * h),
                     curvature = (costs[1] + costs[0] - 2 * cost) / (h * h);
        EXPECT_LE(std::abs(gradient), 1e-6 * curvature) << "parameter " << k;
    }
    RNG rng(3);
    for (int trial = 0; trial < 20; ++trial)
    {
        const Matx33d R = randomRotation(rng);
        const double scale = SCALED ? std::exp(rng.uniform(-1., 1.)) : 1;
        const Vec3d t = uniformVector(rng, -2., 2.);
        EXPECT_GT(costOf(scene, weights, motionFrom(scale, R, t)), cost) << "a random motion";
    }
}

TEST(Usac_RigidLeastSquares, isTheMinimum)
{
    RNG rng(1);
    for (RigidShape shape : SHAPES)
        for (int seed = 1; seed <= 10; ++seed)
            for (double scale : {1., 0.3})
            {
                SCOPED_TRACE(cv::format("shape %d, seed %d, scale %g", shape, seed, scale));
                const RigidScene scene = sceneOf(shape, 0.01, seed, scale);
                const std::vector<double> weights = randomWeights(scene.size(), rng), none;
                expectMinimum<false>(scene, weights);
                expectMinimum<true>(scene, weights);
                expectMinimum<false>(scene, none);
                expectMinimum<true>(scene, none);
            }
}

//! The error of the problem in three components, as a residual that a caller might write. With such
//! a residual, fits use Gauss-Newton steps and not the closed form.
class OwnError : public Residual
{
public:
    void squaredErrors(const Correspondences& p, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        for (int i = begin; i < end; ++i)
        {
            const double datum[] = {p.exact[0][i], p.exact[1][i], p.exact[2][i],
                                    p.exact[3][i], p.exact[4][i], p.exact[5][i]};
            double e[3];
            error(model, datum, e);
            errors[i - begin] = (float)(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
        }
    }

    void squaredErrors(const Model& model, const double* const* c, int count,
                       double* errors) const CV_OVERRIDE
    {
        for (int i = 0; i < count; ++i)
        {
            const double datum[] = {c[0][i], c[1][i], c[2][i], c[3][i], c[4][i], c[5][i]};
            double e[3];
            error(model, datum, e);
            errors[i] = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
        }
    }

    int error(const Model& model, const double* d, double* e) const CV_OVERRIDE
    {
        const Vec3d x = moved(Matx34d(model), Point3d(d[0], d[1], d[2])) - Vec3d(d[3], d[4], d[5]);
        std::copy(x.val, x.val + 3, e);
        return 3;
    }
};

//! With a residual of the caller, Gauss-Newton steps must reach the minimum that the closed form
//! finds.
TEST(Usac_RigidLeastSquares, sameAsBySteps)
{
    RNG rng(2);
    for (int scaled = 0; scaled < 2; ++scaled)
    {
        const Ptr<NonMinimalSolver> steps = createRigidFit(makePtr<OwnError>(), scaled != 0);
        for (RigidShape shape : SHAPES)
            for (int seed = 1; seed <= 5; ++seed)
            {
                SCOPED_TRACE(cv::format("shape %d, seed %d, scaled %d", shape, seed, scaled));
                RigidScene scene = sceneOf(shape, 0.01, seed);
                for (int i = 0; i < scene.size();
                     ++i)  // outliers are moderate, so that the start is near the minimum
                    if (!scene.truth[i])
                        scene.points2[i] = Point3d(moved(scene.motion, scene.points1[i]) * 1.02);
                const std::vector<double> weights = randomWeights(scene.size(), rng);
                const SpacePoints own(scene.points1, scene.points2);
                Model model(scene.motion);
                for (int repeat = 0; repeat < 5; ++repeat)
                    ASSERT_TRUE(steps->fit(own.view(), own.indices(), scene.size(), weights.data(),
                                           model, 10));
                const Fit fit(scaled != 0, scene, weights);
                ASSERT_TRUE(fit.found);
                EXPECT_LE(motionError(scene, Matx34d(model) - fit.motion + scene.motion), 1e-6);
                const double best = costOf(scene, weights, fit.motion);
                EXPECT_NEAR(best, costOf(scene, weights, Matx34d(model)), 1e-8 * best);
            }
    }
}

//! The distance of the points from the origin is a million times their extent, so that six of
//! sixteen digits are lost. The fit must be as accurate as the other digits allow.
TEST(Usac_RigidLeastSquares, farFromTheOrigin)
{
    for (int scaled = 0; scaled < 2; ++scaled)
        for (RigidShape shape : SHAPES)
        {
            RigidSceneOptions options;
            options.noise = 0;
            options.shape = shape;
            options.inlierRatio = 1;
            options.offset1 = Vec3d(2e6, -1e6, 5e5);
            options.offset2 = Vec3d(-3e6, 1e6, 1e6);
            options.modelScale = scaled ? 2 : 1;
            const RigidScene scene = makeRigidScene(options);
            const Fit fit(scaled != 0, scene);
            ASSERT_TRUE(fit.found) << (int)shape;
            EXPECT_LE(motionError(scene, fit.motion), 5e-9) << (int)shape;
            EXPECT_LE(rotationError(scene, fit.motion), 1e-5) << (int)shape;
        }
}

//! Collinear points, points all at one place, points that are not finite, and fewer than three
//! points or nonzero weights must give no motion.
TEST(Usac_RigidLeastSquares, refused)
{
    for (int scaled = 0; scaled < 2; ++scaled)
        for (int seed = 1; seed <= 50; ++seed)
        {
            RigidScene scene = sceneOf(RIGID_LINE, 0, seed);
            EXPECT_FALSE(Fit(scaled != 0, scene).found)
                << seed << ": space 2 has outliers, space 1 is a line";
            RigidSceneOptions options;
            options.shape = RIGID_LINE;
            options.inlierRatio = 1;
            options.noise = 0;
            options.seed = seed;
            options.offset1 = seed % 2 ? Vec3d(1e6, 0, -1e5) : Vec3d();
            EXPECT_FALSE(Fit(scaled != 0, makeRigidScene(options)).found) << seed;
            scene = sceneOf(RIGID_CLOUD, 0.01, seed);
            EXPECT_FALSE(Fit(scaled != 0, scene, std::vector<double>(), 2).found);
            EXPECT_FALSE(Fit(scaled != 0, scene, std::vector<double>(scene.size(), 0.)).found);
            std::vector<double> two(scene.size(), 0.);
            two[5] = two[9] = 1;
            EXPECT_FALSE(Fit(scaled != 0, scene, two).found);
            const double y = scene.points2[7].y;
            scene.points2[7].y = NAN;
            EXPECT_FALSE(Fit(scaled != 0, scene).found);
            scene.points2[7].y = y;
            EXPECT_TRUE(Fit(scaled != 0, scene).found);
            std::fill(scene.points2.begin(), scene.points2.end(), Point3d(1, 2, 3));
            EXPECT_FALSE(Fit(scaled != 0, scene).found) << "all at one place";
        }
}

//! A reflection is not a rigid motion. The determinant of the best rotation must be 1, and all
//! other tested motions must be worse.
TEST(Usac_RigidLeastSquares, mirrored)
{
    for (int seed = 1; seed <= 20; ++seed)
    {
        RigidSceneOptions options;
        options.inlierRatio = 1;
        options.seed = seed;
        options.shape = seed % 2 ? RIGID_CLOUD : RIGID_NEAR_PLANE;
        RigidScene scene = makeRigidScene(options);
        for (Point3d& p : scene.points2)
            p.x = -p.x;
        const Fit rigid(false, scene), scaled(true, scene);
        ASSERT_TRUE(rigid.found && scaled.found);
        EXPECT_NEAR(1, determinant(rigid.motion.get_minor<3, 3>(0, 0)), 1e-12);
        EXPECT_GT(determinant(scaled.motion.get_minor<3, 3>(0, 0)), 0);
        expectMinimum<false>(scene, std::vector<double>());
        expectMinimum<true>(scene, std::vector<double>());
    }
}

}  // namespace
}  // namespace opencv_test
