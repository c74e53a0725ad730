// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "contracts/space_contracts.hpp"
#include "support/params_fields.hpp"
#include "support/random_points.hpp"

// Difficult points and parameters of absolute poses and 3-D motions: numbers of any size, NaN,
// degenerate shapes, few points, every lens and each pair of options. Each result must satisfy all
// contracts.

namespace opencv_test {
namespace {

//! A problem and, for poses, the number of distortion coefficients.
struct SpaceCase
{
    ProblemType problem;
    int coefficients;
};
const SpaceCase SPACE_CASES[] = {
    {ABSOLUTE_POSE, 0}, {ABSOLUTE_POSE, 5}, {RIGID_3D, 0}, {SIMILARITY_3D, 0}};

std::ostream& operator<<(std::ostream& out, const SpaceCase& c)
{
    return out << nameOf(c.problem) << " " << c.coefficients;
}

//! What differs from the usual scene; a ratio below 0 stands for the usual inlier ratio.
struct SpaceOptions
{
    SpaceOptions() : shape(0), kind(0), noise(1), copies(1), ratio(-1), offset(0) {}

    int shape, kind;  //!< numbers of the shape and of the kind of outliers
    double noise;     //!< factor of the usual noise
    int copies;
    double ratio, offset;
};

//! A scene of 120 different matches of any of the problems.
struct SpaceScene
{
    explicit SpaceScene(const SpaceCase& c, const SpaceOptions& o = SpaceOptions())
    {
        const Vec3d offset = o.offset * Vec3d(1, -1. / 3, 1. / 7);
        Params params;
        params.threshold = 2;
        if (c.problem == ABSOLUTE_POSE)
        {
            PoseSceneOptions options;
            options.size = 120;
            options.coefficients = c.coefficients;
            options.shape = (PoseShape)o.shape;
            options.noise *= o.noise;
            options.copies = o.copies;
            options.inlierRatio = o.ratio < 0 ? options.inlierRatio : o.ratio;
            options.behind = o.kind == 1 ? 10 : 0;
            options.atCenter = o.kind == 1 ? 5 : 0;
            options.offset = offset;
            pose = makePoseScene(options);
            call = callOf(pose, params);
            scores = pose.scores;
            return;
        }
        RigidSceneOptions options;
        options.size = 120;
        options.modelScale = c.problem == SIMILARITY_3D ? 0.4 : 1;
        options.shape = (RigidShape)o.shape;
        options.outliers = (RigidOutliers)o.kind;
        options.noise *= o.noise;
        options.copies = o.copies;
        options.inlierRatio = o.ratio < 0 ? options.inlierRatio : o.ratio;
        options.offset1 = offset;
        options.offset2 = Vec3d(offset[2], -offset[1], offset[0]);
        rigid = makeRigidScene(options);
        params.threshold = rigid.threshold;
        call = callOf(c.problem, rigid, params);
        scores = rigid.scores;
    }

    void expectNear(const Estimate& found) const
    {
        ASSERT_FALSE(found.model.empty());
        const bool isPose = call.problem == ABSOLUTE_POSE;
        EXPECT_LT(
            isPose ? rotationError(pose, found.motion()) : rotationError(rigid, found.motion()), 1);
        EXPECT_LT(isPose ? centerError(pose, found.motion()) / 5
                         : motionError(rigid, found.motion()),
                  0.01);
    }

    int size() const { return (int)call.object.size(); }

    int coordinates() const { return call.problem == ABSOLUTE_POSE ? 5 : 6; }

    double& coordinate(int row, int k)
    {
        if (k >= 3 && call.problem == ABSOLUTE_POSE)
            return k == 3 ? call.points2[row].x : call.points2[row].y;
        Point3d& point = (k < 3 ? call.object : call.space2)[row];
        return k % 3 == 0 ? point.x : k % 3 == 1 ? point.y : point.z;
    }

    void resize(int size)
    {
        call.object.resize(size);
        if (call.problem == ABSOLUTE_POSE)
            call.points2.resize(size);
        else
            call.space2.resize(size);
    }

    //! Multiplies the coordinates of object points (`which` 0), of their counterparts (1) or of
    //! both (2), and the threshold, which is in the unit of the counterparts.
    void scale(int which, double unit)
    {
        for (Point3d& X : call.object)
            X *= which != 1 ? unit : 1;
        if (which == 0)
            return;
        for (Point3d& X : call.space2)
            X *= unit;
        for (Point2d& x : call.points2)
            x *= unit;
        if (call.problem == ABSOLUTE_POSE)
            call.K1.rowRange(0, 2) *= unit;
        call.params.threshold *= unit;
    }

    PoseScene pose;
    RigidScene rigid;
    EstimatorCall call;
    std::vector<float> scores;
};

//! The usual scene, to which `rows` random matches are added. Some of their coordinates are
//! `value`.
SpaceScene withOddRows(const SpaceCase& c, double value, int rows)
{
    SpaceScene scene(c);
    RNG rng(5);
    for (int i = 0; i < rows; ++i)
    {
        const int row = (i * 7) % scene.size();
        const Point3d x1(uniformVector(rng, -2., 2.)), x2(uniformVector(rng, -2., 2.));
        scene.call.object.insert(scene.call.object.begin() + row, x1);
        if (c.problem == ABSOLUTE_POSE)
            scene.call.points2.insert(scene.call.points2.begin() + row,
                                      uniformPoint(rng, 0., 640., 0., 480.));
        else
            scene.call.space2.insert(scene.call.space2.begin() + row, x2);
        for (int k = 0; k < scene.coordinates(); ++k)
            if (i % 8 == k || i % 8 == 6 || (i % 8 == 7 && k > 2))
                scene.coordinate(row, k) = value;
    }
    return scene;
}

typedef testing::TestWithParam<SpaceCase> Usac_SpaceHostile;
INSTANTIATE_TEST_CASE_P(/**/, Usac_SpaceHostile, testing::ValuesIn(SPACE_CASES));

TEST_P(Usac_SpaceHostile, some_rows_of_any_number)
{
    const double values[] = {NAN,   INFINITY, -INFINITY, 0,    1e-310, 5e-324,
                             1e-30, 1e10,     -1e18,     1e30, 1e300,  -DBL_MAX};
    for (double value : values)
        for (int rows : {1, 30, 60})
        {
            SCOPED_TRACE(cv::format("%d rows of %g", rows, value));
            const SpaceScene scene = withOddRows(GetParam(), value, rows);
            scene.expectNear(checkedEstimate(scene.call));
        }
}

TEST_P(Usac_SpaceHostile, some_rows_of_any_number_with_every_preset)
{
    for (double value : {(double)NAN, (double)INFINITY, 1e18, 1e300, 1e-310})
    {
        SCOPED_TRACE(value);
        checkEveryWay(withOddRows(GetParam(), value, 40).call);
    }
}

TEST_P(Usac_SpaceHostile, all_rows_of_one_number)
{
    for (double value : {(double)NAN, (double)INFINITY, 0., 1e-310, 1., 1e18, 1e300})
        for (int which = 0; which < SpaceScene(GetParam()).coordinates(); ++which)
        {
            SCOPED_TRACE(cv::format("coordinate %d is %g", which, value));
            SpaceScene scene(GetParam());
            for (int i = 0; i < scene.size(); ++i)
                scene.coordinate(i, which) = value;
            checkEveryWay(scene.call, 30);
        }
}

//! The units of both kinds of points can be of any size. If they are not extreme, and if the
//! problem allows for another scale, a model must be found.
TEST_P(Usac_SpaceHostile, any_unit)
{
    const bool isPose = GetParam().problem == ABSOLUTE_POSE;
    for (double unit : {1e-290, 1e-150, 1e-75, 1e-30, 1e-10, 1e10, 1e30, 1e75, 1e150, 1e290})
        for (int which = 0; which < 3; ++which)
        {
            if (isPose && which > 0 && std::abs(std::log10(unit)) > 31)
                continue;
            SCOPED_TRACE(cv::format("unit %g of points %d", unit, which));
            SpaceScene scene(GetParam());
            scene.scale(which, unit);
            const bool possible = unit > 1e-80 && unit < 1e80 &&
                                  (which == 2 || GetParam().problem != RIGID_3D);
            for (const Mat& model : checkEveryWay(scene.call, 30))
                EXPECT_TRUE(!possible || !model.empty());
        }
}

TEST_P(Usac_SpaceHostile, far_from_the_origin)
{
    for (double offset : {1e3, 1e6, 1e9, 1e12, 1e15})
    {
        SCOPED_TRACE(offset);
        SpaceOptions options;
        options.offset = offset;
        const std::vector<Mat> models = checkEveryWay(SpaceScene(GetParam(), options).call, 30);
        EXPECT_TRUE(offset > 1e9 || !models[0].empty());
    }
}

TEST_P(Usac_SpaceHostile, every_shape_with_every_preset)
{
    const int last = GetParam().problem == ABSOLUTE_POSE ? (int)POSE_CLUSTER : (int)RIGID_CLUSTER;
    for (int shape = 0; shape <= last; ++shape)
        for (double noise : {0., 1.})
        {
            SCOPED_TRACE(cv::format("shape %d, noise %g", shape, noise));
            SpaceOptions options;
            options.shape = shape;
            options.kind = GetParam().problem == ABSOLUTE_POSE ? 1 : shape % 3;
            options.noise = noise;
            options.copies = 1 + shape % 2;
            checkEveryWay(SpaceScene(GetParam(), options).call);
        }
}

TEST_P(Usac_SpaceHostile, few_points)
{
    for (int size = 0; size <= 8; ++size)
        for (double ratio : {0., 0.6, 1.})
        {
            SCOPED_TRACE(cv::format("%d points, %g right", size, ratio));
            SpaceOptions options;
            options.ratio = ratio;
            SpaceScene scene(GetParam(), options);
            scene.resize(size);
            checkEveryWay(scene.call);
        }
}

TEST_P(Usac_SpaceHostile, any_threshold)
{
    SpaceScene scene(GetParam());
    const double usual = scene.call.params.threshold;
    for (double factor : {1e-30, 1e-9, 1e-3, 1e3, 1e30})
    {
        SCOPED_TRACE(factor);
        scene.call.params.threshold = (float)(usual * factor);
        checkEveryWay(scene.call, 30);
    }
}

//! Arbitrary distortion coefficients, mostly with image points that such a lens gives.
TEST(Usac_SpaceHostile_Pose, wild_lenses)
{
    const int lengths[] = {4, 5, 8, 12, 14};
    RNG rng(3);
    int found = 0;
    for (int i = 0; i < 200; ++i)
    {
        SCOPED_TRACE(i);
        SpaceScene scene(SPACE_CASES[0]);
        scene.pose.distortion.resize(lengths[i % 5]);
        for (double& d : scene.pose.distortion)
            d = rng.uniform(-1., 1.) * std::pow(10., rng.uniform(-3., i % 10 == 0 ? 20. : 1.));
        for (int row = 0; row < scene.size() / 2; ++row)
            scene.pose.image[row] = uniformPoint(rng, -3000., 3000.);
        if (i % 2 == 0)
            scene.pose.image = project(scene.pose, scene.pose.pose, scene.pose.object);
        Params params;
        params.maxIterations = 50;
        found += !checkedEstimate(callOf(scene.pose, params)).model.empty();
    }
    EXPECT_GT(found, 50);
}

//! Each pair of option values that Params::check() accepts, with and without scores.
TEST_P(Usac_SpaceHostile, every_option)
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
    const SpaceScene scene(GetParam());
    EstimatorCall call = scene.call;
    for (int a = 0; a < fields; ++a)
        for (int b = a + 1; b < fields; ++b)
            for (int k = 0; k < options[a].values * options[b].values; ++k)
            {
                const int x = k % options[a].values, y = k / options[a].values;
                SCOPED_TRACE(cv::format("option %d: %d, option %d: %d", a, x, b, y));
                Params params;
                params.threshold = scene.call.params.threshold;
                Assignment(params, options[a].field, options[a].bits ? 1 << x : x);
                Assignment(params, options[b].field, options[b].bits ? 1 << y : y);
                params.maxIterations = 50;
                if (call.problem != ABSOLUTE_POSE)
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
                call.params = params;
                EXPECT_FALSE(checkedEstimate(call).model.empty());
            }
    EXPECT_GT(tried, 400);
}

//! The oracle must detect each wrong row of the mask and each kind of wrong model, because the
//! other tests would otherwise be worthless.
TEST_P(Usac_SpaceHostile, oracle_sees_what_is_wrong)
{
    const SpaceScene scene(GetParam());
    const Estimate found = checkedEstimate(scene.call);
    for (int row = 0; row < found.mask.rows; ++row)
    {
        Mat wrong = found.mask.clone();
        wrong.at<uchar>(row) ^= 1;
        Report report = found.report;
        report.inliers = countNonZero(wrong);
        EXPECT_NE("", brokenResult(scene.call, found.model, wrong, report)) << "row " << row;
    }
    Mat bent = found.model.clone(), undefined = found.model.clone();
    bent.at<double>(0, 0) *= 1 + 1e-7;
    undefined.at<double>(1, 3) = NAN;
    const Mat wrong[] = {bent, undefined, -found.model};
    for (const Mat& model : wrong)
        EXPECT_NE("", brokenResult(scene.call, model, found.mask, found.report)) << model;
    EstimatorCall rigid = scene.call;
    rigid.problem = RIGID_3D;
    if (scene.call.problem == SIMILARITY_3D)
    {
        EXPECT_NE("", brokenResult(rigid, found.model, found.mask, found.report));
    }
}

}  // namespace
}  // namespace opencv_test
