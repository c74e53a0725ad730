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
    EXPECT_TRUE(says(report, report.warning));
    cv::estimateAffine2D(points, points, mask, USACV20, 1e5);
    EXPECT_EQ(report.warning, lastWarning());
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

//! The camera matrix K, and what a wrong one of these kinds looks like.
struct CameraCase
{
    Matx33d right, given;
    const char* warning;  //!< part of the warning; empty: there is none
};

std::vector<CameraCase> cameraCases(const Matx33d& K)
{
    const Matx33d twice(2, 0, 0, 0, 2, 0, 0, 0, 1), one = Matx33d::eye();
    Matx33d focal = K, corner = K, wide = K, cropped = K;
    focal(0, 0) = focal(1, 1) = 1;
    corner(0, 2) = corner(1, 2) = 0;
    wide(0, 0) = wide(1, 1) = 0.25 * K(0, 0);
    cropped(0, 2) = -700;
    const char *aside = "80 degrees off the axis", *size = "the principal point is at a corner";
    return {{K, K, ""},        {K, K.inv(), aside},    {K, one, aside},
            {K, focal, aside}, {K, twice * K, size},   {K, corner, size},
            {wide, wide, ""},  {cropped, cropped, ""}, {twice * K, twice * K, ""}};
}

//! Images of the same points by the camera matrix `right` in place of `K`.
std::vector<Point2d> seenBy(const Matx33d& right, const Matx33d& K,
                            const std::vector<Point2d>& points)
{
    std::vector<Point2d> result;
    perspectiveTransform(points, result, right * K.inv());
    return result;
}

//! A camera matrix that is probably wrong must be mentioned in the report, and by lastWarning()
//! after a call with a flag. A right one must not, whatever the field of view and the principal
//! point are.
TEST(UsacReport_Camera, is_probably_wrong)
{
    const Scene scene = makeScene(ESSENTIAL, 150, 50);
    for (const CameraCase& each : cameraCases(scene.K))
    {
        SCOPED_TRACE(cv::format("%g %g: %s", each.given(0, 0), each.given(0, 2), each.warning));
        const std::vector<Point2d> points1 = seenBy(each.right, scene.K, scene.points1),
                                   points2 = seenBy(each.right, scene.K, scene.points2);
        Mat mask, R, t;
        Report report;
        estimateEssential(points1, points2, each.given, Params(), mask, report);
        EXPECT_EQ(*each.warning == 0, report.warning.empty()) << report.warning;
        EXPECT_TRUE(says(report, each.warning)) << report.describe();
        RelativePose pose;
        estimateRelativePose(points1, points2, each.given, noArray(), noArray(), noArray(),
                             Params(), R, t, mask, pose);
        EXPECT_EQ(report.warning, pose.report.warning);
        cv::findHomography(points1, points2, USACV20);
        EXPECT_EQ("", lastWarning());
        cv::findEssentialMat(points1, points2, each.given, USACV20, 0.999, 1.0);
        EXPECT_EQ(report.warning, lastWarning());
    }
}

//! The same for poses, for which only the field of view can be implausible: the image points of a
//! small object are often on one side of the principal point.
TEST(UsacReport_Camera, of_a_pose_is_probably_wrong)
{
    RNG rng(3);
    const Matx33d K(800, 0, 320, 0, 800, 240, 0, 0, 1);
    std::vector<Point3d> space;
    std::vector<Point2d> image;
    for (int i = 0; i < 100; ++i)
    {
        const Point3d X = Point3d(uniformVector(rng, Vec3d(-1., -1., 3.), Vec3d(1., 1., 5.)));
        space.push_back(X);
        image.push_back(Point2d(X.x / X.z, X.y / X.z));
    }
    for (const CameraCase& each : cameraCases(K))
    {
        SCOPED_TRACE(cv::format("%g %g: %s", each.given(0, 0), each.given(0, 2), each.warning));
        const std::vector<Point2d> points = seenBy(each.right, Matx33d::eye(), image);
        const bool aside = std::string(each.warning).find("80") != std::string::npos;
        Mat mask;
        Report report;
        estimateAbsolutePose(space, points, each.given, noArray(), Params(), mask, report);
        EXPECT_EQ(aside, says(report, each.warning) && !report.warning.empty())
            << report.describe();
    }
}

}  // namespace
}  // namespace opencv_test
