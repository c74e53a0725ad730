// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "rigid_scenes.hpp"

// Synthetic scenes of two spaces must have the properties that their options specify, because other
// tests rely on these properties.

namespace opencv_test {
namespace {

const RigidShape ALL_SHAPES[] = {RIGID_CLOUD, RIGID_PLANE,     RIGID_NEAR_PLANE,
                                 RIGID_LINE,  RIGID_NEAR_LINE, RIGID_CLUSTER};
const RigidOutliers OUTLIERS[] = {RIGID_OUTLIERS_UNIFORM, RIGID_OUTLIERS_CLUSTERED,
                                  RIGID_OUTLIERS_SECOND_MOTION};

int countTrue(const RigidScene& scene)
{
    return (int)std::count(scene.truth.begin(), scene.truth.end(), (uchar)1);
}

//! Returns the points of the true matches if `right`, otherwise those of the wrong matches.
std::vector<Point3d> select(const RigidScene& scene, const std::vector<Point3d>& points, bool right)
{
    std::vector<Point3d> result;
    for (int i = 0; i < scene.size(); ++i)
        if ((scene.truth[i] != 0) == right)
            result.push_back(points[i]);
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

TEST(Usac_RigidScenes, sizeAndInlierRatio)
{
    for (int size : {4, 20, 117, 1000})
        for (int percent = 5; percent <= 100; percent += 19)
        {
            RigidSceneOptions options;
            options.size = size;
            options.inlierRatio = 0.01 * percent;
            const RigidScene scene = makeRigidScene(options);
            EXPECT_EQ(size, scene.size());
            EXPECT_EQ(std::max(3, cvRound(0.01 * percent * size)), countTrue(scene));
            EXPECT_EQ((size_t)size, scene.points2.size());
            EXPECT_EQ((size_t)size, scene.clean2.size());
            EXPECT_EQ((size_t)size, scene.scores.size());
        }
}

TEST(Usac_RigidScenes, motionIsExactForPointsWithoutNoise)
{
    for (RigidShape shape : ALL_SHAPES)
        for (RigidOutliers outliers : OUTLIERS)
            for (double scale : {1., 0.2, 30.})
            {
                RigidSceneOptions options;
                options.shape = shape;
                options.outliers = outliers;
                options.modelScale = scale;
                options.seed = 10 * shape + outliers;
                RigidScene scene = makeRigidScene(options);
                const Matx33d R = scene.motion.get_minor<3, 3>(0, 0) * (1 / scale);
                EXPECT_NEAR(1, determinant(R), 1e-12);
                EXPECT_LE(cv::norm(R * R.t() - Matx33d::eye()), 1e-12);
                const std::vector<double> noisy = distancesOf(scene, scene.motion);
                scene.points2 = scene.clean2;
                const std::vector<double> clean = distancesOf(scene, scene.motion);
                double squares = 0;
                int within = 0;
                for (int i = 0; i < scene.size(); ++i)
                {
                    EXPECT_EQ(clean[i] < 1e-12 * scale, scene.truth[i] != 0);
                    EXPECT_TRUE(scene.truth[i] || noisy[i] == clean[i]);
                    squares += scene.truth[i] ? noisy[i] * noisy[i] : 0;
                    within += scene.truth[i] && noisy[i] <= scene.threshold;
                }
                const double sigma = std::sqrt(squares / 3 / countTrue(scene));
                EXPECT_NEAR(options.noise * scale, sigma,
                            0.0019 * scale);              // five standard deviations
                EXPECT_GE(within, countTrue(scene) - 5);  // 0.7 % are above the threshold
                EXPECT_LE(rotationError(scene, scene.motion), 1e-5);
                EXPECT_LE(motionError(scene, scene.motion), 1e-12);
            }
}

TEST(Usac_RigidScenes, shapes)
{
    for (RigidShape shape : ALL_SHAPES)
        for (int seed = 1; seed <= 20; ++seed)
        {
            SCOPED_TRACE(cv::format("shape %d, seed %d", shape, seed));
            RigidSceneOptions options;
            options.shape = shape;
            options.seed = seed;
            const RigidScene scene = makeRigidScene(options);
            const Vec3d extent = extents(select(scene, scene.points1, true));
            const bool line = shape == RIGID_LINE || shape == RIGID_NEAR_LINE;
            const bool plane = shape == RIGID_PLANE || shape == RIGID_NEAR_PLANE;
            if (shape == RIGID_CLUSTER)
            {
                EXPECT_LE(extent[0], 0.07);
                EXPECT_GE(extent[2], 0.03);
                continue;
            }
            EXPECT_GE(extent[0], 0.5);
            if (shape == RIGID_LINE)
            {
                EXPECT_LE(extent[1], 1e-7);
            }
            if (shape == RIGID_NEAR_LINE)
            {
                EXPECT_NEAR(0.02, extent[1], 0.006);
            }
            if (!line)
            {
                EXPECT_GE(extent[1], 0.4);
            }
            if (shape == RIGID_PLANE)
            {
                EXPECT_LE(extent[2], 1e-7);
            }
            if (shape == RIGID_NEAR_PLANE)
            {
                EXPECT_NEAR(0.02, extent[2], 0.006);
            }
            if (!line && !plane)
            {
                EXPECT_GE(extent[2], 0.4);
            }
        }
}

TEST(Usac_RigidScenes, outliers)
{
    RigidSceneOptions options;
    options.noise = 0;
    for (int seed = 1; seed <= 20; ++seed)
    {
        options.seed = seed;
        options.outliers = RIGID_OUTLIERS_SECOND_MOTION;
        const RigidScene second = makeRigidScene(options);
        const std::vector<double> errors = distancesOf(second, second.secondMotion);
        for (int i = 0; i < second.size(); ++i)
            EXPECT_TRUE(second.truth[i] || errors[i] < 1e-12) << errors[i];
        EXPECT_GE(rotationError(second, second.secondMotion), 17);
        options.outliers = RIGID_OUTLIERS_CLUSTERED;
        const RigidScene clustered = makeRigidScene(options);
        EXPECT_LE(extents(select(clustered, clustered.points1, false))[0], 0.2);
        EXPECT_LE(extents(select(clustered, clustered.points2, false))[0], 0.2);
        options.outliers = RIGID_OUTLIERS_UNIFORM;
        const RigidScene uniform = makeRigidScene(options);
        EXPECT_GE(extents(select(uniform, uniform.points1, false))[2], 0.4);
        EXPECT_GE(extents(select(uniform, uniform.points2, false))[2], 0.9);
    }
}

TEST(Usac_RigidScenes, copiesUnitAndOffsets)
{
    RigidSceneOptions options;
    options.size = 50;
    const RigidScene plain = makeRigidScene(options);
    options.unit = 1000;
    options.offset1 = Vec3d(4e5, -5e6, 300);
    options.offset2 = Vec3d(-7e6, 2e3, 1e5);
    options.copies = 3;
    const RigidScene scene = makeRigidScene(options);
    ASSERT_EQ(150, scene.size());
    EXPECT_EQ(3 * countTrue(plain), countTrue(scene));
    EXPECT_NEAR(1000, extents(scene.points1)[0] / extents(plain.points1)[0], 1e-3);
    EXPECT_NEAR(1000, scene.threshold / plain.threshold, 1e-9);
    EXPECT_GT(cv::norm(scene.points1[0]), 4e6);
    EXPECT_GT(cv::norm(scene.points2[0]), 6e6);
    const std::vector<double> errors = distancesOf(scene, scene.motion);
    for (int i = 0; i < scene.size(); ++i)
    {
        EXPECT_EQ(3, (int)std::count(scene.points1.begin(), scene.points1.end(), scene.points1[i]));
        EXPECT_EQ(3, (int)std::count(scene.points2.begin(), scene.points2.end(), scene.points2[i]));
        EXPECT_TRUE(!scene.truth[i] || errors[i] < 60);
    }
}

TEST(Usac_RigidScenes, deterministicAndAsLargeAsAskedFor)
{
    RigidSceneOptions options;
    options.size = 100000;
    options.inlierRatio = 0.3;
    const RigidScene first = makeRigidScene(options), again = makeRigidScene(options);
    EXPECT_EQ(100000, first.size());
    EXPECT_EQ(first.points1, again.points1);
    EXPECT_EQ(first.points2, again.points2);
    EXPECT_EQ(first.scores, again.scores);
    EXPECT_EQ(first.truth, again.truth);
    EXPECT_EQ(first.motion, again.motion);
    ++options.seed;
    const RigidScene other = makeRigidScene(options);
    EXPECT_FALSE(first.points1 == other.points1);
    EXPECT_FALSE(first.scores == other.scores);
}

TEST(Usac_RigidScenes, scoresAreAsInformativeAsAskedFor)
{
    for (double information : {0.3, 0.5, 0.7, 0.9, 1.})
    {
        RigidSceneOptions options;
        options.size = 2000;
        options.inlierRatio = 0.4;
        options.scoreInformation = information;
        const RigidScene scene = makeRigidScene(options);
        double right = 0;
        for (int i = 0; i < scene.size(); ++i)
            for (int j = 0; j < scene.size(); ++j)
                right += scene.truth[i] && !scene.truth[j] && scene.scores[i] < scene.scores[j];
        // about four standard deviations for an information of 0.5
        EXPECT_NEAR(information, right / (800. * 1200.), 0.05);
    }
}

TEST(Usac_RigidScenes, optionsThatMakeNoSense)
{
    RigidSceneOptions options[6];
    options[0].size = 3;
    options[1].unit = 0;
    options[2].scoreInformation = 0;
    options[3].modelScale = -1;
    options[4].copies = 0;
    options[5].noise = -1;
    for (const RigidSceneOptions& wrong : options)
        EXPECT_THROW(makeRigidScene(wrong), cv::Exception);
}

}  // namespace
}  // namespace opencv_test
