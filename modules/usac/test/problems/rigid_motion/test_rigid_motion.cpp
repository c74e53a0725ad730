// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "contracts/space_contracts.hpp"
#include "support/run_context.hpp"

// Tests of 3-D motions on synthetic scenes of every shape, with every preset.

namespace opencv_test {
namespace {

Estimate estimate(ProblemType type, const RigidScene& scene, const Params& params)
{
    return estimate(callOf(type, scene, params));
}

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

//! With 90 % outliers, a single sample finds no motion, so that the correct motion must come from
//! the initial model. With many samples, a wrong initial model must do no harm.
TEST_P(Usac_RigidMotion, initial_model)
{
    RigidSceneOptions options = optionsOf(problem());
    options.inlierRatio = 0.1;
    options.size = 1000;
    const RigidScene scene = makeRigidScene(options);
    for (double widestReach : {1., 8.})
    {
        Params params;
        params.threshold = scene.threshold;
        params.maxIterations = 200000;
        params.widestReach = widestReach;
        const Estimate first = estimate(problem(), scene, params);
        ASSERT_FALSE(first.model.empty());
        Params tracking = params;
        tracking.maxIterations = 1;
        // the motion of the previous frame differs slightly
        const Matx33d turn(1, -0.004, 0, 0.004, 1, 0, 0, 0, 1);
        Matx34d before = motionFrom(1, turn * first.motion().get_minor<3, 3>(0, 0),
                                    moved(first.motion(), Point3d()));
        before(0, 3) += 0.005 * scene.unit;
        for (const Matx34d& given : {first.motion(), before})
        {
            tracking.setInitialModel(given);
            const Estimate tracked = checkedEstimate(callOf(problem(), scene, tracking));
            ASSERT_FALSE(tracked.model.empty());
            EXPECT_LE(tracked.report.iterations, 1);
            EXPECT_GE(tracked.report.inliers, 0.98 * first.report.inliers);
        }
        RNG rng(3);
        for (int trial = 0; trial < 10; ++trial)  // wrong initial models
        {
            Mat wrong(3, 4, CV_64F);
            rng.fill(wrong, RNG::NORMAL, 0, 1);
            params.setInitialModel(trial ? wrong : Mat::zeros(3, 4, CV_64F));
            const Estimate other = checkedEstimate(callOf(problem(), scene, params));
            EXPECT_GE(other.report.inliers, 0.95 * first.report.inliers);
        }
    }
}

//! The neighbors must be those with the smallest distances, found by exhaustive search. For rigid
//! motions, distances are measured in both spaces; for similarities only in space 2, because space
//! 1 can have a different unit.
TEST_P(Usac_RigidMotion, nearest_neighbors)
{
    const RigidScene scene = makeRigidScene(optionsOf(problem()));
    Params params;
    params.threshold = scene.threshold;
    params.neighborhood = NEIGHBORHOOD_KNN;
    params.neighbors = 6;
    const Ptr<Usac> usac = Usac::create(problem(), scene.points1, scene.points2, params);
    const Correspondences& p = usac->points();
    const RunContext run(p, usac->components(), params);
    for (int i = 0; i < p.size; ++i)
    {
        std::vector<std::pair<double, int>> all;
        for (int k = 0; k < p.size; ++k)
        {
            const int a = p.inputIndex[i], b = p.inputIndex[k];
            const Point3d off1 = scene.points1[a] - scene.points1[b],
                          off2 = scene.points2[a] - scene.points2[b];
            all.push_back(
                std::make_pair((problem() == RIGID_3D ? off1.dot(off1) : 0) + off2.dot(off2), k));
        }
        std::sort(all.begin(), all.end());
        const int* members = 0;
        ASSERT_EQ(7, usac->components().neighborhood->members(run, 0, i, members));
        for (int k = 0; k < 7; ++k)
            EXPECT_EQ(all[k].second, members[k]) << i;
    }
}

}  // namespace
}  // namespace opencv_test
