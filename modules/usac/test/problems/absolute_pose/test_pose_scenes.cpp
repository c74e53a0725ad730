// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "pose_scenes.hpp"
#include "opencv2/imgproc.hpp"

// Synthetic scenes of absolute poses must have the properties that their options specify, because
// other tests rely on these properties.

namespace opencv_test {
namespace {

const PoseShape SHAPES[] = {POSE_CLOUD, POSE_PLANE,     POSE_NEAR_PLANE, POSE_TWO_PLANES,
                            POSE_LINE,  POSE_NEAR_LINE, POSE_CLUSTER};
const PoseOutliers OUTLIERS[] = {POSE_OUTLIERS_UNIFORM, POSE_OUTLIERS_CLUSTERED,
                                 POSE_OUTLIERS_SECOND_POSE};
const int SCENE_COEFFICIENTS[] = {0, 4, 5, 8, 12, 14};

int countTrue(const PoseScene& scene)
{
    return (int)std::count(scene.truth.begin(), scene.truth.end(), (uchar)1);
}

std::vector<Point3d> trueObject(const PoseScene& scene)
{
    std::vector<Point3d> result;
    for (int i = 0; i < scene.size(); ++i)
        if (scene.truth[i])
            result.push_back(scene.object[i]);
    return result;
}

//! Standard deviations of points along their principal axes, the largest first.
Vec3d extents(const std::vector<Point3d>& points)
{
    const PCA pca(Mat((int)points.size(), 3, CV_64F, (void*)points.data()), Mat(),
                  PCA::DATA_AS_ROW);
    Vec3d result;
    for (int k = 0; k < 3; ++k)
        result[k] = std::sqrt(std::max(0., pca.eigenvalues.at<double>(k)));
    return result;
}

TEST(Usac_PoseScenes, sizeAndInlierRatio)
{
    for (int size : {4, 20, 117, 1000})
        for (int percent = 5; percent <= 100; percent += 19)
        {
            PoseSceneOptions options;
            options.size = size;
            options.inlierRatio = 0.01 * percent;
            const PoseScene scene = makePoseScene(options);
            EXPECT_EQ(size, scene.size());
            EXPECT_EQ(std::max(3, cvRound(0.01 * percent * size)), countTrue(scene));
            EXPECT_EQ((size_t)size, scene.image.size());
            EXPECT_EQ((size_t)size, scene.clean.size());
            EXPECT_EQ((size_t)size, scene.scores.size());
        }
}

TEST(Usac_PoseScenes, poseIsExactForPointsWithoutNoise)
{
    for (PoseShape shape : SHAPES)
        for (int coefficients : SCENE_COEFFICIENTS)
            for (PoseOutliers outliers : OUTLIERS)
            {
                PoseSceneOptions options;
                options.shape = shape;
                options.coefficients = coefficients;
                options.outliers = outliers;
                options.seed = 10 * shape + coefficients;
                PoseScene scene = makePoseScene(options);
                EXPECT_EQ((size_t)coefficients, scene.distortion.size());
                const Matx33d R = scene.pose.get_minor<3, 3>(0, 0);
                EXPECT_NEAR(1, determinant(R), 1e-12);
                EXPECT_LE(cv::norm(R * R.t() - Matx33d::eye()), 1e-12);
                const std::vector<double> noisy = pixelErrors(scene, scene.pose);
                scene.image = scene.clean;
                const std::vector<double> clean = pixelErrors(scene, scene.pose);
                double squares = 0;
                for (int i = 0; i < scene.size(); ++i)
                {
                    EXPECT_EQ(clean[i] < 1e-9, scene.truth[i] != 0);
                    EXPECT_TRUE(scene.truth[i] || noisy[i] == clean[i]);
                    squares += scene.truth[i] ? noisy[i] * noisy[i] : 0;
                }
                EXPECT_NEAR(options.noise, std::sqrt(squares / 2 / countTrue(scene)),
                            0.11);  // five standard deviations
                EXPECT_LE(rotationError(scene, scene.pose), 1e-5);
                EXPECT_LE(centerError(scene, scene.pose), 1e-12);
            }
}

//! If there are coefficients, the distortion must move some points by at least 5 pixels, and
//! cv::undistortPoints must invert the distortion.
TEST(Usac_PoseScenes, distortion)
{
    for (int coefficients : SCENE_COEFFICIENTS)
    {
        PoseSceneOptions options;
        options.coefficients = coefficients;
        PoseScene scene = makePoseScene(options);
        std::vector<Point2d> flat;
        undistortPoints(scene.clean, flat, scene.K, scene.distortion, noArray(), scene.K,
                        TermCriteria(TermCriteria::COUNT | TermCriteria::EPS, 100, 1e-12));
        const std::vector<Point2d> distorted = scene.clean;
        scene.distortion.clear();
        const std::vector<Point2d> without = project(scene, scene.pose, scene.object);
        double farthest = 0;
        for (int i = 0; i < scene.size(); ++i)
            if (scene.truth[i])
            {
                EXPECT_LE(cv::norm(without[i] - flat[i]), 1e-4);
                farthest = std::max(farthest, cv::norm(without[i] - distorted[i]));
            }
        if (coefficients == 0)
            EXPECT_LE(farthest, 1e-9);
        else
            EXPECT_GE(farthest, 5);
    }
}

TEST(Usac_PoseScenes, shapes)
{
    for (PoseShape shape : SHAPES)
        for (int seed = 1; seed <= 20; ++seed)
        {
            PoseSceneOptions options;
            options.shape = shape;
            options.seed = seed;
            const PoseScene scene = makePoseScene(options);
            const Vec3d extent = extents(trueObject(scene));
            const bool line = shape == POSE_LINE || shape == POSE_NEAR_LINE;
            const bool plane = shape == POSE_PLANE || shape == POSE_NEAR_PLANE;
            if (shape == POSE_CLUSTER)
            {
                EXPECT_LE(extent[0], 0.1);
            }
            else
            {
                EXPECT_GE(extent[0], 0.5);
            }
            if (shape == POSE_LINE)
            {
                EXPECT_LE(extent[1], 1e-7);
            }
            if (shape == POSE_NEAR_LINE)
            {
                EXPECT_NEAR(0.02, extent[1], 0.006);
            }
            if (!line && shape != POSE_CLUSTER)
            {
                EXPECT_GE(extent[1], 0.5);
            }
            if (shape == POSE_PLANE)
            {
                EXPECT_LE(extent[2], 1e-7);
            }
            if (shape == POSE_NEAR_PLANE)
            {
                EXPECT_NEAR(0.02, extent[2], 0.006);
            }
            if (!line && !plane && shape != POSE_CLUSTER)
            {
                EXPECT_GE(extent[2], 0.08);
            }
        }
}

TEST(Usac_PoseScenes, secondPose)
{
    PoseSceneOptions options;
    options.outliers = POSE_OUTLIERS_SECOND_POSE;
    options.coefficients = 5;
    options.noise = 0;
    for (PoseShape shape : SHAPES)
        for (int seed = 1; seed <= 5; ++seed)
        {
            options.shape = shape;
            options.seed = seed;
            const PoseScene scene = makePoseScene(options);
            const std::vector<double> errors = pixelErrors(scene, scene.secondPose);
            for (int i = 0; i < scene.size(); ++i)
                EXPECT_TRUE(scene.truth[i] || errors[i] < 1e-9) << errors[i];
            EXPECT_GE(rotationError(scene, scene.secondPose), 17);
            EXPECT_GE(centerError(scene, scene.secondPose), 0.05);
        }
}

TEST(Usac_PoseScenes, clusteredOutliers)
{
    PoseSceneOptions options;
    options.outliers = POSE_OUTLIERS_CLUSTERED;
    const PoseScene scene = makePoseScene(options);
    std::vector<Point2f> image;
    std::vector<Point3d> object;
    for (int i = 0; i < scene.size(); ++i)
        if (!scene.truth[i])
        {
            image.push_back(scene.image[i]);
            object.push_back(scene.object[i]);
        }
    EXPECT_LE(std::max(boundingRect(image).width, boundingRect(image).height), 82);
    EXPECT_LE(extents(object)[0], 0.5);
}

//! The option `behind` must make object points behind the camera, on the line through the camera
//! center and their image point. The option `atCenter` must make object points at the camera
//! center. The matches of all these points must be wrong.
TEST(Usac_PoseScenes, pointsThatNoCameraSees)
{
    PoseSceneOptions options;
    options.behind = 20;
    options.atCenter = 10;
    options.noise = 0;
    options.coefficients = 8;
    const PoseScene scene = makePoseScene(options);
    const std::vector<Point2d> seen = project(scene, scene.pose, scene.object);
    const std::vector<double> errors = pixelErrors(scene, scene.pose);
    int behind = 0, atCenter = 0;
    for (int i = 0; i < scene.size(); ++i)
    {
        const Vec3d Y = scene.pose *
                        Vec4d(scene.object[i].x, scene.object[i].y, scene.object[i].z, 1);
        const bool center = cv::norm(Y) < 1e-12;
        atCenter += center;
        EXPECT_FALSE(center && scene.truth[i]);
        if (!center && Y[2] < 0)
        {
            ++behind;
            EXPECT_FALSE(scene.truth[i]);
            EXPECT_LE(cv::norm(seen[i] - scene.image[i]), 1e-9);
            EXPECT_GT(errors[i], DBL_MAX);
        }
    }
    EXPECT_EQ(20, behind);
    EXPECT_EQ(10, atCenter);
}

TEST(Usac_PoseScenes, copiesScaleAndOffset)
{
    PoseSceneOptions options;
    options.size = 50;
    options.coefficients = 5;
    const PoseScene plain = makePoseScene(options);
    options.scale = 1000;
    options.offset = Vec3d(4e5, -5e6, 300);
    options.copies = 3;
    const PoseScene scene = makePoseScene(options);
    ASSERT_EQ(150, scene.size());
    EXPECT_EQ(3 * countTrue(plain), countTrue(scene));
    EXPECT_NEAR(1000, extents(trueObject(scene))[0] / extents(trueObject(plain))[0], 1e-3);
    EXPECT_GT(cv::norm(scene.object[0]), 4e6);
    const std::vector<double> errors = pixelErrors(scene, scene.pose);
    for (int i = 0; i < scene.size(); ++i)
    {
        EXPECT_EQ(3, (int)std::count(scene.image.begin(), scene.image.end(), scene.image[i]));
        EXPECT_EQ(3, (int)std::count(scene.object.begin(), scene.object.end(), scene.object[i]));
        EXPECT_TRUE(!scene.truth[i] || errors[i] < 3);
    }
}

TEST(Usac_PoseScenes, deterministicAndAsLargeAsAskedFor)
{
    PoseSceneOptions options;
    options.size = 100000;
    options.inlierRatio = 0.3;
    options.coefficients = 14;
    const PoseScene first = makePoseScene(options), again = makePoseScene(options);
    EXPECT_EQ(100000, first.size());
    EXPECT_EQ(first.object, again.object);
    EXPECT_EQ(first.image, again.image);
    EXPECT_EQ(first.scores, again.scores);
    EXPECT_EQ(first.truth, again.truth);
    EXPECT_EQ(first.pose, again.pose);
    ++options.seed;
    const PoseScene other = makePoseScene(options);
    EXPECT_FALSE(first.object == other.object);
    EXPECT_FALSE(first.scores == other.scores);
}

TEST(Usac_PoseScenes, scoresAreAsInformativeAsAskedFor)
{
    for (double information : {0.3, 0.5, 0.7, 0.9, 1.})
    {
        PoseSceneOptions options;
        options.size = 2000;
        options.inlierRatio = 0.4;
        options.scoreInformation = information;
        const PoseScene scene = makePoseScene(options);
        double right = 0;
        for (int i = 0; i < scene.size(); ++i)
            for (int j = 0; j < scene.size(); ++j)
                right += scene.truth[i] && !scene.truth[j] && scene.scores[i] < scene.scores[j];
        // about four standard deviations for an information of 0.5
        EXPECT_NEAR(information, right / (800. * 1200.), 0.05);
    }
}

TEST(Usac_PoseScenes, optionsThatMakeNoSense)
{
    PoseSceneOptions options[6];
    options[0].size = 3;
    options[1].coefficients = 6;
    options[2].scoreInformation = 0;
    options[3].behind = 61;
    options[4].copies = 0;
    options[5].noise = -1;
    for (const PoseSceneOptions& wrong : options)
        EXPECT_THROW(makePoseScene(wrong), cv::Exception);
}

}  // namespace
}  // namespace opencv_test
