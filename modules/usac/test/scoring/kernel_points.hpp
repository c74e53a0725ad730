// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_KERNEL_POINTS_HPP
#define OPENCV_USACV20_TEST_KERNEL_POINTS_HPP

#include "test_precomp.hpp"
#include "support/problem_objects.hpp"
#include "problems/absolute_pose/pose_scenes.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"
#include "support/run_context.hpp"
#include "problems/kernels.hpp"
#include "scoring/scores.hpp"

// Points, models and direct formulas for the tests of the kernels, that is, of the vectorized loops
// over the points; a single test file includes this header.

namespace opencv_test {
namespace {

const int COUNT = 600;

struct NamedKernels
{
    const char* name;
    Kernels kernels;
};

//! Kernels of all instruction sets that this processor has.
std::vector<NamedKernels> availableKernels()
{
    std::vector<NamedKernels> result;
    const NamedKernels baseline = {"baseline", baselineKernels()};
    result.push_back(baseline);
#ifdef USACV20_HAVE_AVX2
    if (checkHardwareSupport(CV_CPU_AVX2))
    {
        const NamedKernels avx2 = {"AVX2", avx2Kernels()};
        result.push_back(avx2);
    }
#endif
#ifdef USACV20_HAVE_AVX512
    if (checkHardwareSupport(CV_CPU_AVX_512F) && checkHardwareSupport(CV_CPU_AVX_512BW) &&
        checkHardwareSupport(CV_CPU_AVX_512DQ) && checkHardwareSupport(CV_CPU_AVX_512VL))
    {
        const NamedKernels avx512 = {"AVX-512", avx512Kernels()};
        result.push_back(avx512);
    }
#endif
    const NamedKernels best = {"best", kernels()};
    result.push_back(best);
    return result;
}

//! Random covariances of image points, three numbers xx, xy, yy each. The standard deviations along
//! the two axes of the ellipse of a covariance are from 0.1 to 10.
std::vector<float> randomCovariances(int count, RNG& rng)
{
    std::vector<float> covariances;
    for (int i = 0; i < count; ++i)
    {
        const double angle = rng.uniform(0., CV_PI), c = std::cos(angle), s = std::sin(angle),
                     a = std::pow(10, rng.uniform(-2., 2.)), b = std::pow(10, rng.uniform(-2., 2.));
        covariances.push_back((float)(a * c * c + b * s * s));
        covariances.push_back((float)((a - b) * c * s));
        covariances.push_back((float)(a * s * s + b * c * c));
    }
    return covariances;
}

//! Points, and 20 models with increasing deviations from the true one.
struct Fixture
{
    explicit Fixture(Formula::Kind kind_, uint64 seed = 1) : kind(kind_)
    {
        if (kind >= Formula::WHITENED_TRANSFER)
        {
            RNG rng(seed + 100);
            const bool pose = kind == Formula::WHITENED_REPROJECTION;
            params.sigmas = randomCovariances(pose ? COUNT : 2 * COUNT, rng);
        }
        if (kind == Formula::REPROJECTION || kind == Formula::WHITENED_REPROJECTION)
        {
            createPoses(seed);
            return;
        }
        if (kind == Formula::SPACE_TRANSFER)
        {
            createMotions(seed);
            return;
        }
        SceneOptions options;
        options.inliers = COUNT / 2;
        options.outliers = COUNT - COUNT / 2;
        options.seed = seed;
        const bool homography = kind == Formula::TRANSFER || kind == Formula::SYMMETRIC_TRANSFER ||
                                kind == Formula::WHITENED_TRANSFER;
        params.residual = kind == Formula::SYMMETRIC_TRANSFER || kind == Formula::SYMMETRIC_EPIPOLAR
                              ? RESIDUAL_SYMMETRIC
                              : RESIDUAL_STANDARD;
        scene = makeScene(homography ? HOMOGRAPHY : FUNDAMENTAL, options);
        usac = createUsac(scene, params);
        const Model truth = toInternal(usac->points(), scene.model);
        RNG rng(seed);
        for (int i = 0; i < 20; ++i)
        {
            Model model = truth;
            for (int k = 0; k < 9; ++k)
                model.val[k] += rng.gaussian(0.001 * i * i);
            models.push_back(Matx33d(model) * (i % 2 ? 1 : -1e3));
        }
    }

    void createPoses(uint64 seed)
    {
        PoseSceneOptions options;
        options.size = COUNT;
        options.inlierRatio = 0.5;
        options.seed = seed;
        const PoseScene poses = makePoseScene(options);
        usac = Usac::create(ABSOLUTE_POSE, poses.object, poses.image, params, poses.K);
        Model truth;
        const std::vector<double> pose(poses.pose.val, poses.pose.val + 12);
        ASSERT_TRUE(points().problem->fromOutput(pose, points(), truth));
        RNG rng(seed);
        for (int i = 0; i < 20; ++i)
        {
            Model model = truth;
            for (int k = 0; k < 12; ++k)
                model.val[k] = (truth.val[k] + rng.gaussian(0.0005 * i * i)) * (i % 2 ? 1 : 1e3);
            models.push_back(model);
        }
    }

    //! Points and models of 3-D motions with a scale, which is part of the models.
    void createMotions(uint64 seed)
    {
        RigidSceneOptions options;
        options.size = COUNT;
        options.inlierRatio = 0.5;
        options.seed = seed;
        options.modelScale = 3;
        const RigidScene motions = makeRigidScene(options);
        params.threshold = motions.threshold;
        usac = Usac::create(SIMILARITY_3D, motions.points1, motions.points2, params);
        Model truth;
        const std::vector<double> motion(motions.motion.val, motions.motion.val + 12);
        ASSERT_TRUE(points().problem->fromOutput(motion, points(), truth));
        RNG rng(seed);
        for (int i = 0; i < 20; ++i)
        {
            Model model = truth;
            for (int k = 0; k < 12; ++k)
                model.val[k] += rng.gaussian(0.0005 * i * i);
            models.push_back(model);
        }
    }

    const Correspondences& points() const { return usac->points(); }
    bool homogeneous() const { return usac->components().residual->homogeneous(); }
    float limit() const { return (float)(points().threshold * points().threshold); }

    Formula::Kind kind;
    Params params;
    Scene scene;
    Ptr<Usac> usac;
    std::vector<Model> models;
};

//! The covariance L L^T of a point of match i. The entries p, q and s of its root L = [p 0; q s]
//! are in the columns `column`, `column` + 1 and `column` + 2.
Matx22d covarianceAt(const Correspondences& points, int column, int i)
{
    const Matx22d root(points.column[column][i], 0, points.column[column + 1][i],
                       points.column[column + 2][i]);
    return root * root.t();
}

//! Squared reprojection error of match i under the pose P. If there are covariances, the squared
//! Mahalanobis length of the reprojection error. Infinite for a point behind the camera.
double directReprojection(const Correspondences& p, const Matx34d& P, int i)
{
    const Vec3d x = P * Vec4d(p.column[0][i], p.column[1][i], p.column[2][i], 1);
    const Vec2d error(x[0] / x[2] - p.column[3][i], x[1] / x[2] - p.column[4][i]);
    const Matx22d covariance = p.noise ? covarianceAt(p, 5, i) : Matx22d::eye();
    return x[2] > 0 ? error.dot(covariance.inv() * error) : INFINITY;
}

//! Squared error of match i, weighted by the covariances of its two points. If M is H, it is the
//! squared Mahalanobis length of the transfer error in image 2. If M is F, it is (x2^T F x1)^2
//! divided by the variance of x2^T F x1. The covariance of the transfer error and this variance
//! follow from the covariances of the points to first order.
double directWhitened(const Correspondences& p, Formula::Kind kind, const Matx33d& M, int i)
{
    const Matx22d second = covarianceAt(p, 4, i), first = covarianceAt(p, 7, i);
    const Vec3d x1(p.column[X1][i], p.column[Y1][i], 1), x2(p.column[X2][i], p.column[Y2][i], 1),
        y = M * x1, z = M.t() * x2;
    if (kind == Formula::WHITENED_SAMPSON)
    {
        const Vec2d a(y[0], y[1]), b(z[0], z[1]);
        return x2.dot(y) * x2.dot(y) / (a.dot(second * a) + b.dot(first * b));
    }
    Matx22d A;
    for (int row = 0; row < 2; ++row)
        for (int col = 0; col < 2; ++col)
            A(row, col) = (M(row, col) - y[row] / y[2] * M(2, col)) / y[2];
    const Vec2d error(y[0] / y[2] - x2[0], y[1] / y[2] - x2[1]);
    return error.dot((second + A * first * A.t()).inv() * error);
}

double directSpaceTransfer(const Correspondences& p, const Matx34d& motion, int i)
{
    const Vec3d x2(p.column[3][i], p.column[4][i], p.column[5][i]);
    const Vec3d off = motion * Vec4d(p.column[0][i], p.column[1][i], p.column[2][i], 1) - x2;
    return off.dot(off);
}

//! Squared error of match i in double precision, in the normalized coordinates of the kernels.
double directError(const Correspondences& p, Formula::Kind kind, const Model& model, int i)
{
    if (kind == Formula::REPROJECTION || kind == Formula::WHITENED_REPROJECTION)
        return directReprojection(p, model, i);
    if (kind == Formula::WHITENED_TRANSFER || kind == Formula::WHITENED_SAMPSON)
        return directWhitened(p, kind, model, i);
    if (kind == Formula::SPACE_TRANSFER)
        return directSpaceTransfer(p, model, i);
    const Matx33d M = model;
    const Vec3d x1(p.column[X1][i], p.column[Y1][i], 1), x2(p.column[X2][i], p.column[Y2][i], 1),
        y = M * x1;
    const Vec3d z = M.t() * x2, back = M.inv() * x2;
    const double first = y[0] * y[0] + y[1] * y[1], second = z[0] * z[0] + z[1] * z[1],
                 n = x2.dot(y) * x2.dot(y);
    const Vec2d forward(y[0] / y[2] - x2[0], y[1] / y[2] - x2[1]),
        backward(back[0] / back[2] - x1[0], back[1] / back[2] - x1[1]);
    switch (kind)
    {
    case Formula::TRANSFER: return forward.dot(forward);
    case Formula::SAMPSON: return n / (first + second);
    case Formula::SYMMETRIC_TRANSFER: return forward.dot(forward) + backward.dot(backward);
    default: return n / first + n / second;
    }
}

struct Direct
{
    Direct() : msac(0), inliers(0), doubtful(0) {}
    double msac;
    int inliers, doubtful;  //!< numbers of points within the threshold, and of points so close to
                            //!< it that rounding to float can decide
};

Direct directScore(const Fixture& f, const Model& model, int begin, int end)
{
    Direct sum;
    const double limit = f.points().threshold * f.points().threshold;
    for (int i = begin; i < end; ++i)
    {
        const double e = directError(f.points(), f.kind, model, i) / limit;
        sum.msac += e < 1 ? e : 1;
        sum.inliers += e <= 1;
        sum.doubtful += std::abs(e - 1) < 1e-2;
    }
    return sum;
}

}  // namespace
}  // namespace opencv_test

#endif
