// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"

// Tests of equivalent forms of cameras, distortion, homogeneous points and masks, and of forms that
// look equivalent but have a different meaning.

namespace opencv_test {
namespace {

//! Estimates the essential matrix of the scene, with the same camera matrix and distortion for both
//! images.
Mat essentialOf(const Scene& scene, InputArray K, InputArray distortion, Mat& mask)
{
    Report report;
    return estimateEssential(scene.points1, scene.points2, K, noArray(), distortion, distortion,
                             Params(), mask, report);
}

TEST(Usac_Cameras, a_multiple_is_the_same_camera)
{
    const Scene scene = makeScene(ESSENTIAL);
    const double factors[] = {2, 0.25, -1, 1024};  // multiplication by these factors is exact
    Mat mask, other;
    const Mat E = essentialOf(scene, scene.K, noArray(), mask);
    ASSERT_FALSE(E.empty());
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_TRUE(sameBits(E, essentialOf(scene, scene.K * factors[i], noArray(), other)))
            << factors[i];
        EXPECT_TRUE(sameBits(mask, other)) << factors[i];
    }
}

//! The scene is projected by a camera with skew. E is estimated once without distortion and once
//! with a distortion so weak that both results must nearly agree.
TEST(Usac_Cameras, skew_and_distortion)
{
    const Scene scene = makeScene(ESSENTIAL);
    Matx33d skewed = scene.K;
    skewed(0, 1) = 60;
    const Matx33d change = skewed * scene.K.inv();
    Scene moved = scene;
    for (int i = 0; i < scene.size(); ++i)
    {
        const Vec3d a = change * Vec3d(scene.points1[i].x, scene.points1[i].y, 1);
        const Vec3d b = change * Vec3d(scene.points2[i].x, scene.points2[i].y, 1);
        moved.points1[i] = Point2d(a[0], a[1]);
        moved.points2[i] = Point2d(b[0], b[1]);
    }
    Mat mask, plain;
    const Mat E = essentialOf(moved, skewed, noArray(), plain);
    const Mat distorted = essentialOf(moved, skewed, Vec4d(1e-9, 0, 0, 0), mask);
    EXPECT_LT(modelError(scene, E), 0.3);
    EXPECT_LT(modelError(scene, distorted), 0.3);
    EXPECT_NEAR(countNonZero(plain), countNonZero(mask), 2);
}

TEST(Usac_Cameras, every_form_of_distortion)
{
    const Scene scene = makeScene(ESSENTIAL);
    const float values[] = {-0.125f, 0.0625f, 0.f, 0.f, 0.5f};
    const Mat plain = Mat_<double>({1, 5}, {values[0], values[1], values[2], values[3], values[4]});
    Mat mask, other;
    const Mat E = essentialOf(scene, scene.K, plain, mask);
    ASSERT_FALSE(E.empty());
    Mat single, wide(5, 3, CV_64F, Scalar(9)), column = wide.col(1);
    plain.convertTo(single, CV_32F);
    Mat(plain.t()).copyTo(column);
    EXPECT_TRUE(sameBits(E, essentialOf(scene, scene.K, single, other)));
    EXPECT_TRUE(sameBits(E, essentialOf(scene, scene.K, plain.t(), other)));
    EXPECT_TRUE(sameBits(E, essentialOf(scene, scene.K, column, other)));
    EXPECT_TRUE(
        sameBits(E, essentialOf(scene, scene.K, std::vector<float>(values, values + 5), other)));
    EXPECT_TRUE(
        sameBits(E, essentialOf(scene, scene.K, std::vector<double>(values, values + 5), other)));
    EXPECT_TRUE(sameBits(E, essentialOf(scene, scene.K, plain.getUMat(ACCESS_READ), other)));
    EXPECT_TRUE(sameBits(mask, other));
    const Mat channels = plain.colRange(0, 4).clone().reshape(2);
    expectException([&]() { essentialOf(scene, scene.K, channels, other); }, "distCoeffs1");
}

//! The image points after distortion by a lens with these coefficients.
std::vector<Point2d> taken(const std::vector<Point2d>& points, const Matx33d& K,
                           const Mat& distortion)
{
    std::vector<Point3d> rays;
    for (const Point2d& p : points)
    {
        const Vec3d ray = K.inv() * Vec3d(p.x, p.y, 1);
        rays.push_back(Point3d(ray[0], ray[1], 1));
    }
    std::vector<Point2d> result;
    projectPoints(rays, Vec3d(), Vec3d(), K, distortion, result);
    return result;
}

//! In normalized coordinates, the distorted radius r (1 - 0.25 r^2) is at most 0.77: no ray is
//! imaged at a larger radius. A match with an image point at a larger radius must never be an
//! inlier.
TEST(Usac_Cameras, what_the_lens_does_not_show_is_no_inlier)
{
    Scene scene = makeScene(ESSENTIAL);
    const Mat distortion = Mat_<double>({1, 4}, {-0.25, 0, 0, 0});
    scene.points1 = taken(scene.points1, scene.K, distortion);
    scene.points2 = taken(scene.points2, scene.K, distortion);
    const double f = scene.K(0, 0);
    RNG rng(4);
    for (int i = 0; i < scene.size(); i += 3)
    {
        const double angle = rng.uniform(0., 2 * CV_PI), radius = f * rng.uniform(0.8, 4.);
        std::vector<Point2d>& points = i % 2 ? scene.points1 : scene.points2;
        points[i] = Point2d(scene.K(0, 2) + radius * std::cos(angle),
                            scene.K(1, 2) + radius * std::sin(angle));
    }
    for (int wide = 0; wide < 2; ++wide)
    {
        Params params;
        params.threshold = wide ? 100 : 1.5;
        params.significance = 1;
        Mat mask;
        Report report;
        const Mat E = estimateEssential(scene.points1, scene.points2, scene.K, noArray(),
                                        distortion, distortion, params, mask, report);
        ASSERT_FALSE(E.empty());
        for (int i = 0; i < scene.size(); i += 3)
            EXPECT_EQ(0, mask.at<uchar>(i)) << "row " << i;
        if (!wide)
        {
            EXPECT_LT(modelError(scene, E), 0.8);
        }
    }
}

//! Distortion coefficients in half precision (CV_16F) must have the same effect as the same numbers
//! in single precision. If all of them are 0, there must be no effect.
TEST(Usac_Cameras, lens_of_half_precision)
{
    const Scene scene = makeScene(ESSENTIAL);
    const Mat coefficients(Matx<float, 1, 5>(-0.25f, 0.125f, 0.f, 0.0078125f, 0.f));
    Mat half, halfOfNoLens;
    coefficients.convertTo(half, CV_16F);
    Mat(1, 5, CV_32F, Scalar(0)).convertTo(halfOfNoLens, CV_16F);
    const Mat expected = removeDistortion(scene.points1, scene.K, coefficients);
    EXPECT_TRUE(sameBits(expected, removeDistortion(scene.points1, scene.K, half)));
    EXPECT_TRUE(sameBits(removeDistortion(scene.points1, scene.K, noArray()),
                         removeDistortion(scene.points1, scene.K, halfOfNoLens)));
}

typedef UsacProblem UsacForms;
INSTANTIATE_TEST_CASE_P(/**/, UsacForms, testing::ValuesIn(TWO_VIEW_PROBLEMS));

//! (x, y, 0) is a point at infinity and must not be read as the point (x, y).
TEST_P(UsacForms, points_at_infinity_are_never_inliers)
{
    const Scene scene = makeScene(problem());
    std::vector<Point3d> points1, points2;
    for (int i = 0; i < scene.size(); ++i)
    {
        points1.push_back(Point3d(scene.points1[i].x, scene.points1[i].y, i % 6 != 3));
        points2.push_back(
            Point3d(scene.points2[i].x, scene.points2[i].y, i % 3 != 0 || i % 6 == 3));
    }
    Mat mask;
    Report report;
    const Mat model = estimatePoints(problem(), points1, points2, Params(), mask, report);
    EXPECT_LT(modelError(scene, model), 0.8);
    for (int i = 0; i < scene.size(); i += 3)
        EXPECT_EQ(0, mask.at<uchar>(i)) << "row " << i;
}

TEST_P(UsacForms, masks_of_no_points)
{
    const std::vector<Point2d> none;
    Mat mat(7, 2, CV_32F, Scalar(1));
    UMat umat(7, 1, CV_8U, Scalar(1));
    std::vector<uchar> bytes(7, 1);
    std::vector<char> chars(7, 1);
    Report report;
    estimatePoints(problem(), none, none, Params(), mat, report);
    EXPECT_EQ((int)STOP_TOO_FEW_POINTS, report.stop);
    estimatePoints(problem(), Mat(), Mat(0, 5, CV_32S), Params(), umat, report);
    estimatePoints(problem(), noArray(), none, Params(), bytes, report);
    estimatePoints(problem(), none, none, Params(), chars, report);
    EXPECT_TRUE(mat.empty() && umat.empty() && bytes.empty() && chars.empty());
}

//! If the mask is part of a matrix, its elements must be written in place and the rest of the
//! matrix must not change.
TEST_P(UsacForms, mask_in_a_part_of_a_matrix)
{
    const Scene scene = makeScene(problem());
    Mat whole(scene.size(), 3, CV_8U, Scalar(9)), part = whole.col(1), expected;
    Report report;
    estimatePoints(problem(), scene.points1, scene.points2, Params(), expected, report);
    estimatePoints(problem(), scene.points1, scene.points2, Params(), part, report);
    EXPECT_TRUE(sameBits(expected, whole.col(1)));
    EXPECT_EQ(2 * scene.size(), countNonZero(whole.col(0) == 9) + countNonZero(whole.col(2) == 9));
}

}  // namespace
}  // namespace opencv_test
