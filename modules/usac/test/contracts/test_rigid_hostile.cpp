// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "contracts/rigid_contracts.hpp"
#include "support/params_fields.hpp"

// Tests of 3-D motions with difficult points and with every option.

namespace opencv_test {
namespace {

const double FAR_AWAY = 1e300, DENORMAL = 1e-310;

RigidSceneOptions optionsOf(ProblemType type)
{
    RigidSceneOptions options;
    options.size = 120;
    options.modelScale = type == SIMILARITY_3D ? 0.4 : 1;
    return options;
}

double& coordinateOf(RigidScene& scene, int row, int which)
{
    Point3d& point = which < 3 ? scene.points1[row] : scene.points2[row];
    return which % 3 == 0 ? point.x : which % 3 == 1 ? point.y : point.z;
}

//! The scene with `rows` additional rows, in which some coordinates are `value`.
RigidScene withRigidRows(ProblemType type, double value, int rows)
{
    RigidScene scene = makeRigidScene(optionsOf(type));
    RNG rng(5);
    for (int i = 0; i < rows; ++i)
    {
        const Point3d x1 = Point3d(uniformVector(rng, -2., 2.));
        const Point3d x2 = Point3d(uniformVector(rng, -2., 2.));
        const int row = (i * 7) % scene.size();
        scene.points1.insert(scene.points1.begin() + row, x1);
        scene.points2.insert(scene.points2.begin() + row, x2);
        scene.truth.insert(scene.truth.begin() + row, (uchar)0);
        for (int k = 0; k < 6; ++k)
            if (i % 8 == k || i % 8 == 6 || (i % 8 == 7 && k > 2))
                coordinateOf(scene, row, k) = value;
    }
    return scene;
}

class Usac_RigidHostile : public UsacProblem
{};
INSTANTIATE_TEST_CASE_P(/**/, Usac_RigidHostile, testing::ValuesIn(SPACE_PROBLEMS));

TEST_P(Usac_RigidHostile, some_rows_of_any_number)
{
    const double values[] = {NAN,   INFINITY, -INFINITY, 0,    DENORMAL, 5e-324,
                             1e-30, 1e10,     -1e18,     1e30, FAR_AWAY, -DBL_MAX};
    for (double value : values)
        for (int rows : {1, 30, 60})
        {
            SCOPED_TRACE(cv::format("%d rows of %g", rows, value));
            const RigidScene scene = withRigidRows(problem(), value, rows);
            Params params;
            params.threshold = scene.threshold;
            const Estimate found = checkedMotion(problem(), scene, params);
            ASSERT_FALSE(found.model.empty());
            EXPECT_LT(rotationError(scene, found.motion()), 1);
            EXPECT_LT(motionError(scene, found.motion()), 0.01);
        }
}

TEST_P(Usac_RigidHostile, some_rows_of_any_number_with_every_preset)
{
    for (double value : {(double)NAN, (double)INFINITY, 1e18, FAR_AWAY, DENORMAL})
    {
        SCOPED_TRACE(value);
        const RigidScene scene = withRigidRows(problem(), value, 40);
        checkEveryWay(problem(), scene, scene.threshold);
    }
}

TEST_P(Usac_RigidHostile, all_rows_of_one_number)
{
    for (double value : {(double)NAN, (double)INFINITY, 0., DENORMAL, 1., 1e18, FAR_AWAY})
        for (int which = 0; which < 6; ++which)
        {
            SCOPED_TRACE(cv::format("coordinate %d is %g", which, value));
            RigidScene scene = makeRigidScene(optionsOf(problem()));
            for (int i = 0; i < scene.size(); ++i)
                coordinateOf(scene, i, which) = value;
            checkEveryWay(problem(), scene, scene.threshold, 30);
        }
}

//! The unit of space 1, of space 2 or of both spaces changes. If both units change, or the scale of
//! the motion is free, the motion must be found with the units 1e-75 to 1e75.
TEST_P(Usac_RigidHostile, any_unit)
{
    for (double unit : {1e-290, 1e-150, 1e-75, 1e-30, 1e-10, 1e10, 1e30, 1e75, 1e150, 1e290})
        for (int which = 0; which < 3; ++which)
        {
            SCOPED_TRACE(cv::format("unit %g of space %d", unit, which));
            RigidScene scene = makeRigidScene(optionsOf(problem()));
            for (int i = 0; i < scene.size(); ++i)
            {
                scene.points1[i] *= which != 1 ? unit : 1;
                scene.points2[i] *= which != 0 ? unit : 1;
            }
            const double threshold = scene.threshold * (which != 0 ? unit : 1);
            const std::vector<Mat> motions = checkEveryWay(problem(), scene, threshold, 30);
            const bool possible = unit > 1e-80 && unit < 1e80 &&
                                  (which == 2 || problem() == SIMILARITY_3D);
            for (size_t i = 0; i < motions.size() && possible; ++i)
                EXPECT_FALSE(motions[i].empty()) << i;
        }
}

//! The points are so far from the origin that coordinates lose digits. With offsets of up to 1e9,
//! the default preset must find the motion; all results must satisfy all contracts.
TEST_P(Usac_RigidHostile, far_from_the_origin)
{
    for (double offset : {1e3, 1e6, 1e9, 1e12, 1e15})
    {
        SCOPED_TRACE(offset);
        RigidSceneOptions options = optionsOf(problem());
        options.offset1 = Vec3d(offset, -offset / 3, offset / 7);
        options.offset2 = Vec3d(offset / 5, offset, -offset / 3);
        const RigidScene scene = makeRigidScene(options);
        const std::vector<Mat> motions = checkEveryWay(problem(), scene, scene.threshold, 30);
        EXPECT_TRUE(offset > 1e9 || !motions[0].empty());
    }
}

TEST_P(Usac_RigidHostile, every_shape_with_every_preset)
{
    for (int shape = RIGID_CLOUD; shape <= RIGID_CLUSTER; ++shape)
        for (double noise : {0., 0.01})
        {
            SCOPED_TRACE(cv::format("shape %d, noise %g", shape, noise));
            RigidSceneOptions options = optionsOf(problem());
            options.shape = (RigidShape)shape;
            options.noise = noise;
            options.outliers = (RigidOutliers)(shape % 3);
            options.copies = 1 + shape % 2;
            const RigidScene scene = makeRigidScene(options);
            checkEveryWay(problem(), scene, scene.threshold);
        }
}

//! Numbers of points from none to more than a minimal sample. All results must satisfy all
//! contracts.
TEST_P(Usac_RigidHostile, few_points)
{
    for (int size = 0; size <= 8; ++size)
        for (double ratio : {0., 0.6, 1.})
        {
            SCOPED_TRACE(cv::format("%d points, %g right", size, ratio));
            RigidSceneOptions options = optionsOf(problem());
            options.inlierRatio = ratio;
            RigidScene scene = makeRigidScene(options);
            scene.points1.resize(size);
            scene.points2.resize(size);
            checkEveryWay(problem(), scene, scene.threshold);
        }
}

//! Thresholds from far below the noise to far above the size of the scene. All results must satisfy
//! all contracts.
TEST_P(Usac_RigidHostile, any_threshold)
{
    const RigidScene scene = makeRigidScene(optionsOf(problem()));
    for (double threshold : {1e-300, 1e-100, 1e-30, 1e-9, 1e-3, 1e3, 1e30, 1e150, 1e300})
    {
        SCOPED_TRACE(threshold);
        checkEveryWay(problem(), scene, threshold, 30);
    }
}

//! All pairs of values of two of the listed options, with the defaults of the other listed options.
//! Each accepted combination must find a motion that satisfies all contracts. Combinations that
//! Params::check() refuses are skipped.
TEST_P(Usac_RigidHostile, every_option)
{
    const struct
    {
        const char* field;
        int values;
        bool bits;
    } options[] = {{"sampler", 5, false},           {"quality", 6, false},
                   {"localOptimization", 7, false}, {"polishing", 4, false},
                   {"verification", 3, false},      {"termination", 5, true},
                   {"ordering", 4, false},          {"neighborhood", 3, false}};
    const int fields = sizeof(options) / sizeof(options[0]);
    int tried = 0;
    const RigidScene scene = makeRigidScene(optionsOf(problem()));
    for (int a = 0; a < fields; ++a)
        for (int b = a + 1; b < fields; ++b)
            for (int k = 0; k < options[a].values * options[b].values; ++k)
            {
                const int x = k % options[a].values, y = k / options[a].values;
                SCOPED_TRACE(cv::format("option %d: %d, option %d: %d", a, x, b, y));
                Params params;
                params.threshold = scene.threshold;
                Assignment(params, options[a].field, options[a].bits ? 1 << x : x);
                Assignment(params, options[b].field, options[b].bits ? 1 << y : y);
                params.maxIterations = 50;
                params.neighborRadius = 0.5;
                if (k % 2 || params.sampler == SAMPLER_IMPORTANCE)
                    for (float score : scene.scores)
                        params.scores.push_back(1 - score);
                params.scoreOrder = SCORES_HIGHER_IS_BETTER;
                try
                {
                    params.check(scene.size());
                }
                catch (const cv::Exception&)
                {
                    continue;
                }
                ++tried;
                EXPECT_FALSE(checkedMotion(problem(), scene, params).model.empty());
            }
    EXPECT_GT(tried, 400);
}

//! The oracle brokenResult() must detect a wrong row of the mask and a wrong motion, because the
//! tests that use this oracle would otherwise be worthless.
TEST_P(Usac_RigidHostile, oracle_sees_what_is_wrong)
{
    const RigidScene scene = makeRigidScene(optionsOf(problem()));
    Params params;
    params.threshold = scene.threshold;
    Estimate found = checkedMotion(problem(), scene, params);
    const EstimatorCall call = callOf(problem(), scene, params);
    ASSERT_EQ("", brokenResult(call, found.model, found.mask, found.report));
    for (int row = 0; row < found.mask.rows; ++row)
    {
        Mat wrong = found.mask.clone();
        wrong.at<uchar>(row) ^= 1;
        Report report = found.report;
        report.inliers = countNonZero(wrong);
        EXPECT_NE("", brokenResult(call, found.model, wrong, report)) << "row " << row;
    }
    Mat other = found.model.clone();
    other.at<double>(0, 0) *= 1 + 1e-8;
    EXPECT_NE("", brokenResult(call, other, found.mask, found.report)) << "no rotation";
    other = found.model * 1.05;
    EXPECT_NE("", brokenResult(call, other, found.mask, found.report)) << "another motion";
    other = -found.model;
    EXPECT_NE("", brokenResult(call, other, found.mask, found.report)) << "a mirror image";
    other = found.model.clone();
    other.at<double>(1, 3) = NAN;
    EXPECT_NE("", brokenResult(call, other, found.mask, found.report));
    EstimatorCall rigid = call;
    rigid.problem = RIGID_3D;
    EXPECT_EQ(problem() == RIGID_3D,
              brokenResult(rigid, found.model, found.mask, found.report).empty());
}

}  // namespace
}  // namespace opencv_test
