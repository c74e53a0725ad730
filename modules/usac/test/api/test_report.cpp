// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"

// Tests of what a report says about a call whose result is meaningless.

namespace opencv_test {
namespace {

bool ends(const Report& report, const std::string& words)
{
    const std::string text = report.describe();
    return text.size() >= words.size() &&
           text.compare(text.size() - words.size(), words.size(), words) == 0;
}

bool says(const Report& report, const std::string& words)
{
    return std::string(report.describe()).find(words) != std::string::npos;
}

const char* const WIDE = "the threshold is as large as the extent of all points";
const char* const CHANCE = "no better than chance";

typedef UsacProblem UsacReport;
INSTANTIATE_TEST_CASE_P(/**/, UsacReport, testing::ValuesIn(TWO_VIEW_PROBLEMS));

//! The points are on the normalized image plane, but the threshold is in pixels, so that almost
//! every model has all points as inliers. The report must say that the threshold is too wide. With
//! a threshold in the unit of the points, the report must not say so.
TEST_P(UsacReport, threshold_in_another_unit)
{
    // focal lengths in pixels, for horizontal fields of view of 85 to 18 degrees
    const double focals[] = {350, 800, 2000};
    for (double f : focals)
    {
        SceneOptions options;
        options.inliers = 150;
        options.outliers = 150;
        const Scene scene = makeScene(problem(), options);
        std::vector<Point2d> points1, points2;
        for (int i = 0; i < scene.size(); ++i)
        {
            points1.push_back((scene.points1[i] - Point2d(320, 240)) * (1 / f));
            points2.push_back((scene.points2[i] - Point2d(320, 240)) * (1 / f));
        }
        Mat mask;
        for (int right = 0; right < 2; ++right)
        {
            Params params;
            params.threshold = right ? 1.5 / f : 1.5;
            Report report;
            const Mat model = estimatePoints(problem(), points1, points2, params, mask, report,
                                             Matx33d::eye());
            EXPECT_EQ(right == 0, report.wideThreshold) << f;
            EXPECT_EQ(right == 0, says(report, WIDE)) << report.describe();
            EXPECT_EQ(right == 0 && !model.empty(), ends(report, CHANCE)) << report.describe();
            EXPECT_EQ(right == 0 && !model.empty(), report.chance > 0.01) << report.chance;
        }
    }
}

//! The same test for poses, whose threshold must be in the unit of the image points, and for 3-D
//! motions, whose threshold must be in the unit of space.
TEST(UsacReport_Space, threshold_in_another_unit)
{
    RNG rng(3);
    std::vector<Point3d> space, moved;
    std::vector<Point2d> image;
    for (int i = 0; i < 100; ++i)
    {
        const Point3d X = Point3d(uniformVector(rng, Vec3d(-1., -1., 3.), Vec3d(1., 1., 5.)));
        space.push_back(X);
        moved.push_back(Point3d(X.y, -X.x, X.z + 1));
        image.push_back(Point2d(X.x / X.z, X.y / X.z));
    }
    for (int right = 0; right < 2; ++right)
    {
        Params params;
        params.threshold = right ? 1e-3 : 1.5;
        Mat mask;
        Report report;
        estimateAbsolutePose(space, image, Matx33d::eye(), noArray(), params, mask, report);
        EXPECT_EQ(right == 0, report.wideThreshold) << report.describe();
        estimateRigid3D(space, moved, params, mask, report);
        EXPECT_EQ(right == 0, report.wideThreshold) << report.describe();
        estimateSimilarity3D(space, moved, params, mask, report);
        EXPECT_EQ(right == 0, report.wideThreshold) << report.describe();
    }
}

//! A threshold is wide if it is at least half of the longest side of the points' extent. One point
//! far away must not enlarge the extent.
TEST(UsacReport_Wide, half_of_the_longest_side)
{
    std::vector<Point2d> points;
    for (int y = 0; y <= 100; y += 10)
        for (int x = 0; x <= 200; x += 10)
            points.push_back(Point2d(x, y));
    Params params;
    params.significance = 1;
    Mat mask;
    Report report;
    params.threshold = 98;
    estimateAffinity2D(points, points, params, mask, report);
    EXPECT_FALSE(report.wideThreshold);
    params.threshold = 102;
    estimateAffinity2D(points, points, params, mask, report);
    EXPECT_TRUE(report.wideThreshold);
    points.push_back(Point2d(1e6, 1e6));
    params.threshold = 1e5;
    estimateAffinity2D(points, points, params, mask, report);
    EXPECT_TRUE(report.wideThreshold);
    estimateAffinity2D(std::vector<Point2d>(), std::vector<Point2d>(), params, mask, report);
    EXPECT_FALSE(report.wideThreshold);
}

//! If no point is finite, there is no extent with which the threshold could be compared.
TEST(UsacReport_Wide, no_finite_points)
{
    const std::vector<Point2d> points(20, Point2d(NAN, NAN));
    Mat mask;
    Report report;
    refineModel(HOMOGRAPHY, Matx33d::eye(), points, points, Params(), mask, report);
    EXPECT_EQ(0, report.inliers);
    EXPECT_FALSE(report.wideThreshold) << report.describe();
}

//! Matches of random points. With significance 1, a model must be returned, and the report must say
//! that the model is no better than chance. With the default, the result must be empty.
TEST(UsacReport_Chance, random_points)
{
    RNG rng(1);
    std::vector<Point2d> points1, points2;
    for (int i = 0; i < 200; ++i)
    {
        points1.push_back(uniformPoint(rng, 0., 640., 0., 480.));
        points2.push_back(uniformPoint(rng, 0., 640., 0., 480.));
    }
    for (int refuse = 0; refuse < 2; ++refuse)
    {
        Params params;
        params.significance = refuse ? 0 : 1;
        Mat mask;
        Report report;
        const Mat F = estimateFundamental(points1, points2, params, mask, report);
        EXPECT_EQ(refuse != 0, F.empty());
        EXPECT_EQ(refuse == 0, ends(report, CHANCE)) << report.describe();
        EXPECT_FALSE(report.wideThreshold);
    }
}

}  // namespace
}  // namespace opencv_test
