// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "pose_scenes.hpp"
#include "support/contracts.hpp"

// Tests of absolute poses on synthetic scenes of every shape, with every lens model and every
// preset.

namespace opencv_test {
namespace {

const int COEFFICIENTS[] = {0, 4, 5, 8, 12, 14};

struct Estimate
{
    Mat model, mask;
    Report report;

    Matx34d pose() const { return Matx34d(model); }
};

Estimate estimate(const PoseScene& scene, const Params& params = Params())
{
    Estimate result;
    result.model = estimateAbsolutePose(scene.object, scene.image, scene.K, scene.distortion,
                                        params, result.mask, result.report);
    return result;
}

//! Checks the documented properties of the result, and that the pose is correct within `degrees` of
//! rotation and within `part` of the depth in position.
void expectRight(const PoseScene& scene, const Estimate& found, const Params& params,
                 double degrees, double part)
{
    ASSERT_EQ(Size(4, 3), found.model.size());
    ASSERT_EQ(CV_64F, found.model.type());
    const Matx33d R(found.model.colRange(0, 3));
    EXPECT_LE(cvtest::norm(R * R.t() - Matx33d::eye(), NORM_INF), 1e-12);
    EXPECT_GT(determinant(R), 0);
    EXPECT_LE(rotationError(scene, found.pose()), degrees);
    EXPECT_LE(centerError(scene, found.pose()), part);
    ASSERT_EQ(scene.size(), found.mask.rows);
    ASSERT_EQ(CV_8U, found.mask.type());
    const std::vector<double> errors = pixelErrors(scene, found.pose());
    int inliers = 0;
    for (int i = 0; i < scene.size(); ++i)
    {
        inliers += found.mask.at<uchar>(i);
        if (std::abs(errors[i] - params.threshold) > 1e-6 * params.threshold)
        {
            EXPECT_EQ(errors[i] <= params.threshold ? 1 : 0, found.mask.at<uchar>(i))
                << i << ": " << errors[i];
        }
    }
    EXPECT_EQ(inliers, found.report.inliers);
}

TEST(Usac_AbsolutePose, every_shape_lens_and_kind_of_outliers)
{
    for (PoseShape shape : {POSE_CLOUD, POSE_PLANE, POSE_NEAR_PLANE, POSE_TWO_PLANES})
        for (int coefficients : COEFFICIENTS)
            for (PoseOutliers outliers :
                 {POSE_OUTLIERS_UNIFORM, POSE_OUTLIERS_CLUSTERED, POSE_OUTLIERS_SECOND_POSE})
            {
                SCOPED_TRACE(cv::format("shape %d, %d coefficients, outliers %d", shape,
                                        coefficients, outliers));
                PoseSceneOptions options;
                options.shape = shape;
                options.coefficients = coefficients;
                options.outliers = outliers;
                options.inlierRatio = 0.6;
                options.seed = 10 + shape;
                const PoseScene scene = makePoseScene(options);
                expectRight(scene, estimate(scene), Params(), 0.5, 0.02);
            }
}

TEST(Usac_AbsolutePose, every_preset)
{
    PoseSceneOptions options;
    options.coefficients = 5;
    options.inlierRatio = 0.7;
    options.scoreInformation = 0.9;
    const PoseScene scene = makePoseScene(options);
    for (const NamedPreset& preset : allPresets(ABSOLUTE_POSE))
    {
        SCOPED_TRACE(preset.name);
        Params params = preset.params;
        params.scores = scene.scores;
        if (params.sampler == SAMPLER_IMPORTANCE || params.ordering == ORDERING_INPUT_ORDER)
            params.scores.clear();
        Estimate found = estimate(scene, params);
        params.threshold = found.report.threshold;  // some presets estimate it
        expectRight(scene, found, params, 0.6, 0.03);
    }
}

TEST(Usac_AbsolutePose, inlier_ratios_and_sizes)
{
    for (int percent : {5, 10, 20, 50, 90, 100})
        for (int size : {20, 100, 1000})
        {
            if (percent * size < 1000)
                continue;  // fewer than ten inliers
            SCOPED_TRACE(cv::format("%d %% of %d", percent, size));
            PoseSceneOptions options;
            options.size = size;
            options.inlierRatio = 0.01 * percent;
            const PoseScene scene = makePoseScene(options);
            Params params;
            params.maxIterations = 100000;
            expectRight(scene, estimate(scene, params), params, 1, 0.05);
        }
}

//! The mean rotation error must be at most 1.1 times that of least squares over the true matches.
TEST(Usac_AbsolutePose, as_accurate_as_least_squares)
{
    double own = 0, best = 0;
    for (int seed = 1; seed <= 40; ++seed)
    {
        PoseSceneOptions options;
        options.seed = seed;
        options.coefficients = COEFFICIENTS[seed % 6];
        const PoseScene scene = makePoseScene(options);
        std::vector<Point3d> object;
        std::vector<Point2d> image;
        for (int i = 0; i < scene.size(); ++i)
            if (scene.truth[i])
            {
                object.push_back(scene.object[i]);
                image.push_back(scene.image[i]);
            }
        Mat r, t(scene.pose.col(3));
        Rodrigues(scene.pose.get_minor<3, 3>(0, 0), r);
        solvePnPRefineLM(object, image, scene.K, scene.distortion, r, t);
        Matx33d R;
        Rodrigues(r, R);
        Mat pose;
        hconcat(R, t, pose);
        best += rotationError(scene, Matx34d(pose));
        own += rotationError(scene, estimate(scene).pose());
    }
    EXPECT_LE(own, 1.1 * best);
}

//! A board of 11 x 8 points, 3 cm apart, at a distance of 4 m, tilted by up to 60 degrees; 30 % of
//! the matches are wrong.
PoseScene boardScene(int seed)
{
    const int columns = 11, rows = 8;
    const double step = 0.03, noise = 0.3;
    PoseScene scene;
    RNG rng(seed);
    const double tilt = rng.uniform(0., CV_PI / 3), axis = rng.uniform(0., 2 * CV_PI);
    Matx33d R, turned;
    Rodrigues(Vec3d(std::cos(axis), std::sin(axis), 0) * tilt, R);
    Rodrigues(Vec3d(0, 0, rng.uniform(0., 2 * CV_PI)), turned);
    R = R * turned;
    const Vec3d t(rng.uniform(-1., 1.), rng.uniform(-0.8, 0.8), 4);
    scene.K = Matx33d(800, 0, 320, 0, 800, 240, 0, 0, 1);
    hconcat(R, t, scene.pose);
    for (int i = 0; i < columns * rows; ++i)
        scene.object.push_back(
            Point3d(i % columns - (columns - 1) / 2., i / columns - (rows - 1) / 2., 0) * step);
    scene.image = project(scene, scene.pose, scene.object);
    for (Point2d& point : scene.image)
    {
        scene.truth.push_back(rng.uniform(0., 1.) < 0.7);
        if (scene.truth.back())
            point += gaussianPoint(rng, noise);
        else
            point = Point2d(rng.uniform(0., 640.), rng.uniform(0., 480.));
    }
    return scene;
}

//! Sum of squared errors of the true matches, in squared pixels.
double sumOfSquares(const PoseScene& scene, const Matx34d& pose)
{
    const std::vector<double> errors = pixelErrors(scene, pose);
    double sum = 0;
    for (int i = 0; i < scene.size(); ++i)
        sum += scene.truth[i] ? errors[i] * errors[i] : 0;
    return sum;
}

//! The sum of squared errors of a small plane has two minima. The better one must be found: the
//! sum must exceed that of the true pose by at most four times the variance of the noise.
TEST(Usac_AbsolutePose, second_pose_of_a_plane)
{
    for (Params params : {Params(), Params::fast(), Params::accurate()})
    {
        params.threshold = 8;
        params.maxIterations = 100;
        int missed = 0;
        for (int seed = 1; seed <= 100; ++seed)
        {
            const PoseScene scene = boardScene(seed);
            const Estimate found = estimate(scene, params);
            ASSERT_FALSE(found.model.empty()) << seed;
            missed += sumOfSquares(scene, found.pose()) >
                      sumOfSquares(scene, scene.pose) + 4 * 0.3 * 0.3;
        }
        EXPECT_LE(missed, 1);  // 6, 10 and 2 without the second pose
    }
}

//! The camera matrix has two different focal lengths, skew or a negative focal length, or it is the
//! identity. The pose must be found, and the mask must be right.
TEST(Usac_AbsolutePose, any_camera_matrix)
{
    PoseScene scene = makePoseScene();
    std::vector<Point2d> normalized;
    for (const Point2d& p : scene.image)
        normalized.push_back(
            Point2d((p.x - scene.K(0, 2)) / scene.K(0, 0), (p.y - scene.K(1, 2)) / scene.K(1, 1)));
    const Matx33d cameras[] = {Matx33d(500, 0, 320, 0, 900, 240, 0, 0, 1),
                               Matx33d(700, 30, 0, 0, 720, 0, 0, 0, 1), Matx33d::eye(),
                               Matx33d(-600, 0, 320, 0, 600, 240, 0, 0, 1)};
    for (const Matx33d& K : cameras)
    {
        SCOPED_TRACE(Mat(K));
        Params params;
        params.threshold = 2 * (std::abs(K(0, 0)) + std::abs(K(1, 1))) / 2 / scene.K(0, 0);
        std::vector<Point2d> image;
        for (const Point2d& p : normalized)
        {
            const Vec3d q = K * Vec3d(p.x, p.y, 1);
            image.push_back(Point2d(q[0], q[1]));
        }
        Mat mask;
        const Mat pose = estimateAbsolutePose(scene.object, image, K, noArray(), params, mask);
        ASSERT_FALSE(pose.empty());
        EXPECT_LE(rotationError(scene, Matx34d(pose)), 0.5);
        const Mat P = Mat(K) * pose;
        for (int i = 0; i < scene.size(); ++i)
        {
            const Vec3d q = Matx34d(P) *
                            Vec4d(scene.object[i].x, scene.object[i].y, scene.object[i].z, 1);
            const double error = cv::norm(Point2d(q[0] / q[2], q[1] / q[2]) - image[i]);
            EXPECT_EQ(q[2] > 0 && error <= params.threshold ? 1 : 0, mask.at<uchar>(i)) << error;
        }
    }
}

//! A residual that a caller might write. It has the errors that the search uses, which do not
//! include the lens distortion.
class PlainResidual : public Residual
{
public:
    void squaredErrors(const Correspondences& points, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        builtIn->squaredErrors(points, model, begin, end, errors);
    }
    void squaredErrors(const Model& model, const double* const* columns, int count,
                       double* errors) const CV_OVERRIDE
    {
        builtIn->squaredErrors(model, columns, count, errors);
    }

    Ptr<Residual> builtIn;
};

//! If the residual is replaced by one that ignores the lens distortion, the mask must ignore the
//! distortion, too. When the built-in residual is restored, the mask must include the distortion
//! again.
TEST(Usac_AbsolutePose, replaced_residual_makes_the_mask)
{
    PoseSceneOptions options;
    options.coefficients = 5;
    const PoseScene s = makePoseScene(options);
    const Ptr<Usac> usac = Usac::create(ABSOLUTE_POSE, s.object, s.image, Params(), s.K, noArray(),
                                        s.distortion);
    Mat lens, plain, again;
    ASSERT_FALSE(usac->run(lens).empty());
    const Ptr<Residual> builtIn = usac->components().residual;
    const Ptr<NonMinimalSolver> solver = usac->components().nonMinimalSolver;
    const Ptr<PlainResidual> own = makePtr<PlainResidual>();
    own->builtIn = builtIn;
    usac->components().residual = own;
    usac->components().nonMinimalSolver = usac->points().problem->createNonMinimalSolver(builtIn);
    const Mat pose = usac->run(plain);
    ASSERT_FALSE(pose.empty());
    std::vector<Point2d> flat;
    undistortPoints(s.image, flat, s.K, s.distortion, noArray(), s.K);
    const Matx34d P(Mat(Mat(s.K) * pose));
    int inliers = 0;
    for (int i = 0; i < s.size(); ++i)
    {
        const Vec3d x = P * Vec4d(s.object[i].x, s.object[i].y, s.object[i].z, 1);
        const double error = cv::norm(Point2d(x[0] / x[2], x[1] / x[2]) - flat[i]);
        inliers += plain.at<uchar>(i);
        if (std::abs(error - 1.5) > 0.01)  // undistortPoints is not exact
        {
            EXPECT_EQ(x[2] > 0 && error <= 1.5 ? 1 : 0, plain.at<uchar>(i)) << error;
        }
    }
    EXPECT_GT(inliers, 100);
    usac->setPoints(s.object, s.image);
    usac->components().residual = builtIn;
    usac->components().nonMinimalSolver = solver;
    ASSERT_FALSE(usac->run(again).empty());
    EXPECT_EQ(0, cvtest::norm(lens, again, NORM_INF));
}

}  // namespace
}  // namespace opencv_test
