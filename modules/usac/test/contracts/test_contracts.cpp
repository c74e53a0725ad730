// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"

namespace opencv_test {
namespace {

typedef UsacProblem UsacContracts;
INSTANTIATE_TEST_CASE_P(/**/, UsacContracts, testing::ValuesIn(TWO_VIEW_PROBLEMS));

TEST_P(UsacContracts, mask_and_normalization_of_every_preset)
{
    const double thresholds[] = {0.5, 1.5, 4};
    for (uint64 seed = 1; seed <= 3; ++seed)
    {
        SCOPED_TRACE(cv::format("seed %d", (int)seed));
        SceneOptions options;
        options.seed = seed;
        options.outliers = (int)seed * 100 - 100;
        const Scene scene = makeScene(problem(), options);
        const std::vector<Mat> models = checkEveryWay(problem(), scene.points1, scene.points2,
                                                      thresholds[seed % 3], 400);
        for (size_t i = 0; i < models.size(); ++i)
            EXPECT_FALSE(models[i].empty()) << allPresets()[i].name;
    }
}

TEST(Usac_Contracts, homography_with_h33_zero)
{
    // the point (0, 0) of image 1 is mapped to infinity: a valid homography whose h33 is 0
    const Matx33d H(200, 30, 1e5, -20, 250, 8e4, 1, 0.2, 0);
    RNG rng(3);
    std::vector<Point2d> points1, points2;
    for (int i = 0; i < 100; ++i)
    {
        const Point2d p = uniformPoint(rng, 100., 600., 0., 480.);
        const Vec3d y = H * Vec3d(p.x, p.y, 1);
        points1.push_back(p);
        points2.push_back(Point2d(y[0] / y[2], y[1] / y[2]));
    }
    Mat mask;
    Report report;
    const Mat model = estimateHomography(points1, points2, Params(), mask, report);
    ASSERT_FALSE(model.empty());
    EXPECT_EQ(100, countNonZero(mask));
    const std::vector<Mat> models = checkEveryWay(HOMOGRAPHY, points1, points2);
    for (size_t i = 0; i < models.size(); ++i)
        EXPECT_FALSE(models[i].empty()) << allPresets()[i].name;
}

TEST(Usac_Contracts, essential_of_two_cameras_with_distortion)
{
    const Scene scene = makeScene(ESSENTIAL);
    const Matx33d K2(700, 0, 300, 0, 720, 250, 0, 0, 1);
    const Vec<double, 5> d1(-0.1, 0.02, 0.001, 0, 0), d2(0.05, -0.01, 0, 0.001, 0);
    std::vector<Point2d> points1(scene.points1.size()), points2(points1.size()), plane1, plane2;
    undistortPoints(scene.points1, plane1, scene.K, noArray());
    undistortPoints(scene.points2, plane2, scene.K, noArray());
    std::vector<Point3d> rays1, rays2;
    convertPointsToHomogeneous(plane1, rays1);
    convertPointsToHomogeneous(plane2, rays2);
    projectPoints(rays1, Vec3d(), Vec3d(), scene.K, d1, points1);
    projectPoints(rays2, Vec3d(), Vec3d(), K2, d2, points2);
    Mat mask;
    Report report;
    const Mat E = estimateEssential(points1, points2, scene.K, K2, d1, d2, Params(), mask, report);
    EXPECT_LT(modelError(scene, E), 0.6);
    EstimatorCall call = callOf(scene, Params());
    call.points1 = points1;
    call.points2 = points2;
    call.K2 = Mat(K2);
    call.d1 = Mat(d1, true).reshape(1, 1);
    call.d2 = Mat(d2, true).reshape(1, 1);
    EXPECT_EQ("", brokenResult(call, E, mask, report));
    EXPECT_GT(countNonZero(mask), 150);
}

TEST(Usac_Contracts, report_with_an_unknown_reason)
{
    Report report;
    const int stops[] = {-2, 100};
    for (int i = 0; i < 2; ++i)
    {
        report.stop = stops[i];
        EXPECT_NE(std::string::npos, std::string(report.describe()).find("unknown reason"))
            << stops[i];
    }
}

}  // namespace
}  // namespace opencv_test
