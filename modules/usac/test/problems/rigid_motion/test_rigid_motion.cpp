// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "contracts/rigid_contracts.hpp"

// Tests of 3-D motions on synthetic scenes of every shape, with every preset.

namespace opencv_test {
namespace {

Estimate estimate(ProblemType type, const RigidScene& scene)
{
    Params params;
    params.threshold = scene.threshold;
    return estimate(type, scene, params);
}

//! Options of a scene whose motion has a scale if the problem allows it.
RigidSceneOptions optionsOf(ProblemType type)
{
    RigidSceneOptions options;
    options.modelScale = type == SIMILARITY_3D ? 2.5 : 1;
    return options;
}

//! Checks the documented properties of the result, and that the motion is correct within `degrees`
//! of rotation and `error` units of the scene.
void expectRight(ProblemType type, const RigidScene& scene, const Estimate& found, double threshold,
                 double degrees, double error)
{
    ASSERT_EQ(Size(4, 3), found.model.size());
    ASSERT_EQ(CV_64F, found.model.type());
    const Matx33d A(found.model.colRange(0, 3)),
        R = type == RIGID_3D ? A : A * (std::sqrt(3.) / cv::norm(A));
    EXPECT_LE(cvtest::norm(R * R.t() - Matx33d::eye(), NORM_INF), 1e-12);
    EXPECT_GT(determinant(R), 0);
    EXPECT_LE(rotationError(scene, found.motion()), degrees);
    EXPECT_LE(motionError(scene, found.motion()), error);
    ASSERT_EQ(scene.size(), found.mask.rows);
    ASSERT_EQ(CV_8U, found.mask.type());
    const std::vector<double> errors = distancesOf(scene, found.motion());
    int inliers = 0;
    for (int i = 0; i < scene.size(); ++i)
    {
        inliers += found.mask.at<uchar>(i);
        if (std::abs(errors[i] - threshold) > 1e-9 * threshold)
        {
            EXPECT_EQ(errors[i] <= threshold ? 1 : 0, found.mask.at<uchar>(i))
                << i << ": " << errors[i];
        }
    }
    EXPECT_EQ(inliers, found.report.inliers);
    EXPECT_EQ(threshold, found.report.threshold);
}

class Usac_RigidMotion : public UsacProblem
{};
INSTANTIATE_TEST_CASE_P(/**/, Usac_RigidMotion, testing::ValuesIn(SPACE_PROBLEMS));

TEST_P(Usac_RigidMotion, every_shape_and_kind_of_outliers)
{
    for (RigidShape shape : {RIGID_CLOUD, RIGID_PLANE, RIGID_NEAR_PLANE, RIGID_NEAR_LINE})
        for (RigidOutliers outliers :
             {RIGID_OUTLIERS_UNIFORM, RIGID_OUTLIERS_CLUSTERED, RIGID_OUTLIERS_SECOND_MOTION})
            for (int copies : {1, 3})
            {
                SCOPED_TRACE(
                    cv::format("shape %d, outliers %d, %d copies", shape, outliers, copies));
                RigidSceneOptions options = optionsOf(problem());
                options.shape = shape;
                options.outliers = outliers;
                options.copies = copies;
                options.seed = 10 + shape;
                const RigidScene scene = makeRigidScene(options);
                // points near a line hardly determine the rotation about this line
                const double degrees = shape == RIGID_NEAR_LINE ? 10 : 0.4;
                expectRight(problem(), scene, estimate(problem(), scene), scene.threshold, degrees,
                            0.005);
            }
}

//! The rotation of a small ball is less accurate, because the noise is larger relative to its size.
TEST_P(Usac_RigidMotion, clusters)
{
    RigidSceneOptions options = optionsOf(problem());
    options.shape = RIGID_CLUSTER;
    const RigidScene scene = makeRigidScene(options);
    expectRight(problem(), scene, estimate(problem(), scene), scene.threshold, 5, 0.005);
}

TEST_P(Usac_RigidMotion, every_preset)
{
    RigidSceneOptions options = optionsOf(problem());
    options.inlierRatio = 0.7;
    options.scoreInformation = 0.9;
    const RigidScene scene = makeRigidScene(options);
    for (const NamedPreset& preset : allPresets(problem()))
    {
        SCOPED_TRACE(preset.name);
        Params params = preset.params;
        params.threshold = scene.threshold;
        params.scores = scene.scores;
        if (params.sampler == SAMPLER_IMPORTANCE || params.ordering == ORDERING_INPUT_ORDER)
            params.scores.clear();
        const Estimate found = estimate(problem(), scene, params);
        expectRight(problem(), scene, found,
                    findsThreshold(params) ? found.report.threshold : scene.threshold, 0.4, 0.005);
        EXPECT_LE(found.report.chance, 1e-6);
    }
}

TEST_P(Usac_RigidMotion, inlier_ratios_and_sizes)
{
    for (int percent : {5, 10, 20, 50, 90, 100})
        for (int size : {20, 100, 1000, 20000})
        {
            if (percent * size < 1000)
                continue;  // fewer than ten inliers
            SCOPED_TRACE(cv::format("%d %% of %d", percent, size));
            RigidSceneOptions options = optionsOf(problem());
            options.size = size;
            options.inlierRatio = 0.01 * percent;
            const RigidScene scene = makeRigidScene(options);
            Params params;
            params.threshold = scene.threshold;
            params.maxIterations = 100000;
            expectRight(problem(), scene, estimate(problem(), scene, params), scene.threshold, 1,
                        0.012);
        }
}

TEST_P(Usac_RigidMotion, a_hundred_thousand_points)
{
    RigidSceneOptions options = optionsOf(problem());
    options.size = 100000;
    options.inlierRatio = 0.3;
    const RigidScene scene = makeRigidScene(options);
    expectRight(problem(), scene, estimate(problem(), scene), scene.threshold, 0.02, 0.001);
}

//! There are only true matches, from three (as many as in a sample) to 20. The motion must be
//! found. With fewer than three points there must be no model.
TEST_P(Usac_RigidMotion, few_points)
{
    for (int size : {3, 4, 5, 20})
        for (int seed = 1; seed <= 10; ++seed)
        {
            SCOPED_TRACE(cv::format("%d points, seed %d", size, seed));
            RigidSceneOptions options = optionsOf(problem());
            options.size = std::max(size, 4);
            options.inlierRatio = 1;
            options.noise = 1e-4;
            options.seed = seed;
            RigidScene scene = makeRigidScene(options);
            scene.points1.resize(size);
            scene.points2.resize(size);
            scene.truth.resize(size);
            scene.threshold *= 2;
            expectRight(problem(), scene, estimate(problem(), scene), scene.threshold, 1, 0.005);
        }
    for (int size = 0; size < 3; ++size)
    {
        const std::vector<Point3d> points(size, Point3d(1, 2, 3));
        RigidScene scene;
        scene.points1 = scene.points2 = points;
        scene.threshold = 1;
        const Estimate found = estimate(problem(), scene);
        EXPECT_TRUE(found.model.empty());
        EXPECT_EQ((int)STOP_TOO_FEW_POINTS, found.report.stop);
        EXPECT_EQ(size, found.mask.rows);
    }
}

//! The mean error must be at most 1.05 times that of least squares over the true matches.
TEST_P(Usac_RigidMotion, as_accurate_as_least_squares)
{
    double own = 0, best = 0;
    for (int seed = 1; seed <= 60; ++seed)
    {
        RigidSceneOptions options = optionsOf(problem());
        options.seed = seed;
        options.outliers = (RigidOutliers)(seed % 3);
        const RigidScene scene = makeRigidScene(options);
        std::vector<Point3d> points1, points2;
        for (int i = 0; i < scene.size(); ++i)
            if (scene.truth[i])
            {
                points1.push_back(scene.points1[i]);
                points2.push_back(scene.points2[i]);
            }
        double scale = 1;
        const Matx34d fit(cv::estimateAffine3D(points1, points2,
                                               problem() == RIGID_3D ? (double*)0 : &scale, true));
        best += motionError(
            scene, motionFrom(scale, fit.get_minor<3, 3>(0, 0), moved(fit, Point3d(0, 0, 0))));
        own += motionError(scene, estimate(problem(), scene).motion());
    }
    EXPECT_LE(own, 1.05 * best);
}

TEST_P(Usac_RigidMotion, exact_points)
{
    for (double unit : {1e-4, 1., 1e5})
        for (double offset : {0., 1e3})
        {
            SCOPED_TRACE(cv::format("unit %g, offset %g", unit, offset));
            RigidSceneOptions options = optionsOf(problem());
            options.noise = 0;
            options.unit = unit;
            options.offset1 = Vec3d(2, -3, 5) * (offset * unit);
            options.offset2 = Vec3d(-7, 3, 1) * (offset * unit);
            const RigidScene scene = makeRigidScene(options);
            expectRight(problem(), scene, estimate(problem(), scene), scene.threshold, 1e-5,
                        1e-9 * (1 + offset));
        }
}

/** The unit and the origin of the points change, and the threshold changes with the unit. The mask
must be the same. A unit that is a power of two changes no bit of the search; other units and the
offsets could change the mask only where the error equals the threshold up to rounding. */
TEST_P(Usac_RigidMotion, units_and_origins)
{
    for (int seed = 1; seed <= 5; ++seed)
    {
        RigidSceneOptions options = optionsOf(problem());
        options.seed = seed;
        options.inlierRatio = 0.4;
        const Estimate first = estimate(problem(), makeRigidScene(options));
        for (double unit : {std::ldexp(1., -20), std::ldexp(1., 20), 1e-6, 1e-3, 1e3, 1e6})
            for (double offset : {0., 1., 1e4})
            {
                SCOPED_TRACE(cv::format("seed %d, unit %g, offset %g", seed, unit, offset));
                options.unit = unit;
                options.offset1 = Vec3d(-1, 3, 2) * (unit * offset);
                options.offset2 = Vec3d(2, 5, -1) * (unit * offset);
                const RigidScene scene = makeRigidScene(options);
                const Estimate other = estimate(problem(), scene);
                ASSERT_FALSE(other.model.empty());
                EXPECT_EQ(0, cvtest::norm(first.mask, other.mask, NORM_L1));
                options.unit = 1;
                options.offset1 = options.offset2 = Vec3d();
            }
    }
}

TEST_P(Usac_RigidMotion, threads_give_the_same_bits)
{
    RigidSceneOptions options = optionsOf(problem());
    options.size = 1000;
    options.inlierRatio = 0.2;
    const RigidScene scene = makeRigidScene(options);
    for (const NamedPreset& preset : allPresets(problem()))
    {
        SCOPED_TRACE(preset.name);
        Params params = preset.params;
        params.threshold = scene.threshold;
        params.threads = 1;
        const Estimate first = estimate(problem(), scene, params);
        for (params.threads = 2; params.threads <= 4; ++params.threads)
        {
            const Estimate other = estimate(problem(), scene, params);
            EXPECT_TRUE(sameBits(first.model, other.model)) << params.threads;
            EXPECT_TRUE(sameBits(first.mask, other.mask)) << params.threads;
        }
    }
}

//! Some rows are not finite, as happens where a depth camera measures no depth. These rows must not
//! be inliers.
TEST_P(Usac_RigidMotion, rows_of_no_numbers)
{
    RigidScene scene = makeRigidScene(optionsOf(problem()));
    const Estimate whole = estimate(problem(), scene);
    for (int i = 0; i < scene.size(); i += 3)
    {
        double* const numbers[] = {&scene.points1[i].x, &scene.points1[i].z, &scene.points2[i].y,
                                   &scene.points2[i].z};
        *numbers[i % 4] = i % 2 ? NAN : i % 5 ? INFINITY : -INFINITY;
        scene.truth[i] = 0;
    }
    const Estimate found = estimate(problem(), scene);
    expectRight(problem(), scene, found, scene.threshold, 0.5, 0.006);
    EXPECT_LT(found.report.inliers, whole.report.inliers);
    for (int i = 0; i < scene.size(); i += 3)
        EXPECT_EQ(0, found.mask.at<uchar>(i));
}

//! For equal, collinear or random points there must be no model (except for random points with
//! LMedS), and a reason must be reported.
TEST_P(Usac_RigidMotion, impossible_points)
{
    std::vector<Point3d> same(100, Point3d(3, 4, 5)), line, random1, random2;
    RNG rng(6);
    for (int i = 0; i < 100; ++i)
    {
        line.push_back(Point3d(i, 2 * i, -i));
        random1.push_back(Point3d(uniformVector(rng, 0., 600.)));
        random2.push_back(Point3d(uniformVector(rng, 0., 600.)));
    }
    const std::vector<Point3d>* const firsts[] = {&same,    &same,    &line,   &line,
                                                  &random1, &random1, &random1};
    const std::vector<Point3d>* const seconds[] = {&same, &random2, &line,   &random1,
                                                   &same, &line,    &random2};
    int notSignificant = 0;
    for (int i = 0; i < 7; ++i)
        for (NamedPreset preset : allPresets(problem()))
        {
            SCOPED_TRACE(cv::format("case %d, %s", i, preset.name));
            preset.params.maxIterations = 500;
            const bool random = i == 6;
            preset.params.threshold = random ? 60 : 1;
            RigidScene scene;
            scene.points1 = *firsts[i];
            scene.points2 = *seconds[i];
            const Estimate found = estimate(problem(), scene, preset.params);
            if (random &&
                (preset.params.quality == QUALITY_LMEDS || preset.params.significance == 1))
                continue;  // LMedS can choose a large threshold
            EXPECT_TRUE(found.model.empty());
            EXPECT_EQ(0, countNonZero(found.mask));
            EXPECT_EQ(100, found.mask.rows);
            EXPECT_EQ(0, found.report.inliers);
            EXPECT_TRUE(found.report.stop == STOP_NO_MODEL ||
                        (i == 0 && found.report.stop == STOP_TOO_FEW_POINTS) ||
                        (random && found.report.stop == STOP_NOT_SIGNIFICANT));
            notSignificant += found.report.stop == STOP_NOT_SIGNIFICANT;
            EXPECT_NE("", found.report.describe());
        }
    EXPECT_GE(notSignificant, 10);
}

}  // namespace
}  // namespace opencv_test
