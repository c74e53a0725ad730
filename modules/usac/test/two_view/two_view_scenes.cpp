// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

#include "two_view_scenes.hpp"

namespace opencv_test {

Params twoPixels()
{
    Params params;
    params.threshold = 2;
    params.confidence = 0.999;
    params.maxIterations = 10000;
    return params;
}

Scene twoViewScene(uint64 seed, double planeFraction, int outliers)
{
    SceneOptions options;
    options.seed = seed;
    options.planeFraction = planeFraction;
    options.outliers = outliers;
    return makeScene(ESSENTIAL, options);
}

Scene planeAlone(uint64 seed)
{
    SceneOptions options;
    options.seed = seed;
    options.inliers = 18;
    options.outliers = 200;
    options.planeFraction = 1;
    options.baseline = 0.3;
    return makeScene(ESSENTIAL, options);
}

TwoViewPair pairOf(const Scene& scene, bool known)
{
    const Mat K = known ? Mat(scene.K) : Mat();
    return TwoViewPair(column(scene.points1).clone(), column(scene.points2).clone(), K.clone(),
                       K.clone());
}

void checkFields(const TwoViewGeometry& found, const TwoViewPair& pair)
{
    EXPECT_EQ(pair.points1.rows, found.mask.rows);
    EXPECT_EQ(countNonZero(found.mask), found.inliers);
    EXPECT_GE(found.inliers, 15);
    EXPECT_EQ("", found.reason);
    EXPECT_EQ("", found.error);
    EXPECT_GT(found.iterations, 0);
    EXPECT_LE(found.report.chance, 1e-4);
    EXPECT_TRUE(found.F.empty() || std::abs(cv::norm(found.F) - 1) < 1e-12);
    EXPECT_EQ(found.R.empty(), found.t.empty());
    EXPECT_TRUE(found.R.empty() || std::abs(determinant(found.R) - 1) < 1e-12);
}

Scene turnedScene(uint64 seed)
{
    Scene scene = twoViewScene(seed, 0, 60);
    RNG rng(seed);
    for (int i = 0; i < scene.size(); ++i)
    {
        if (!scene.truth[i])
            continue;
        const Vec3d x = scene.K * scene.R * scene.K.inv() *
                        Vec3d(scene.clean1[i].x, scene.clean1[i].y, 1);
        scene.clean2[i] = Point2d(x[0] / x[2], x[1] / x[2]);
        scene.points2[i] = scene.clean2[i] + gaussianPoint(rng, 0.5);
    }
    return scene;
}

}  // namespace opencv_test
