// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/lens_oracle.hpp"
#include "support/contracts.hpp"

// Tests of removeDistortion(), which removes the distortion of a lens from image points.

namespace opencv_test {
namespace {

const Matx33d LENS_CAMERA(800, 3, 410, 0, 790, 305, 0, 0, 1);

Mat lens(int coefficients)
{
    const double c[] = {-0.3,  0.1,   0.002,  -0.001, -0.01, 0.05, 0.02,
                        -0.01, 0.003, -0.001, 0.002,  0.001, 0.02, -0.03};
    return Mat(1, coefficients, CV_64F, (void*)c).clone();
}

//! `ideal` are pixels without distortion, on a grid over the image; `taken` are the same pixels
//! distorted by the lens.
void makePoints(const Mat& distortion, std::vector<Point2d>& ideal, std::vector<Point2d>& taken)
{
    std::vector<Point3d> rays;
    for (int y = 0; y <= 600; y += 60)
        for (int x = 0; x <= 800; x += 80)
        {
            const Vec3d ray = LENS_CAMERA.inv() * Vec3d(x, y, 1);
            rays.push_back(Point3d(ray[0], ray[1], 1));
            ideal.push_back(Point2d(x, y));
        }
    projectPoints(rays, Vec3d(), Vec3d(), Matx33d::eye(), distortion, taken);
    for (Point2d& p : taken)  // cv::projectPoints ignores the skew, so LENS_CAMERA is applied here
    {
        const Vec3d seen = LENS_CAMERA * Vec3d(p.x, p.y, 1);
        p = Point2d(seen[0], seen[1]);
    }
}

TEST(Usac_Lens, is_the_inverse_of_projectPoints)
{
    const int counts[] = {0, 4, 5, 8, 12, 14};
    for (int coefficients : counts)
    {
        const Mat distortion = coefficients ? lens(coefficients) : Mat();
        std::vector<Point2d> ideal, taken;
        makePoints(distortion, ideal, taken);
        const Mat found = removeDistortion(taken, LENS_CAMERA, distortion);
        ASSERT_EQ(Size(2, (int)taken.size()), found.size());
        ASSERT_EQ(CV_64F, found.type());
        EXPECT_LT(cvtest::norm(found, column(ideal).reshape(1), NORM_INF), 1e-9) << coefficients;
    }
}

//! Other tests check results for E with LensOracle. The error bounds of LensOracle must hold. They
//! must be so tight that for more than a quarter of the points, the error of cv::undistortPoints,
//! which makes five iterations, exceeds the bound.
TEST(Usac_Lens, oracle)
{
    const int counts[] = {4, 5, 8, 12, 14};
    for (int coefficients : counts)
    {
        const Mat distortion = lens(coefficients);
        const LensOracle oracle(distortion);
        std::vector<Point2d> ideal, taken, five;
        makePoints(distortion, ideal, taken);
        int off = 0;
        for (size_t i = 0; i < taken.size(); ++i)
        {
            const Vec3d seen = LENS_CAMERA.inv() * Vec3d(taken[i].x, taken[i].y, 1),
                        right = LENS_CAMERA.inv() * Vec3d(ideal[i].x, ideal[i].y, 1);
            Bounded x(seen[0], 1e-15), y(seen[1], 1e-15);
            ASSERT_EQ(LensOracle::SEEN, oracle.invert(x, y)) << coefficients << " " << i;
            EXPECT_LE(std::abs((double)x.value - right[0]), (double)x.error);
            EXPECT_LE(std::abs((double)y.value - right[1]), (double)y.error);
            EXPECT_LT((double)x.error, 1e-9);
            undistortPoints(std::vector<Point2d>(1, Point2d(seen[0], seen[1])), five,
                            Matx33d::eye(), distortion);
            off += std::abs(five[0].x - right[0]) > (double)x.error;
        }
        EXPECT_GT(off, (int)taken.size() / 4);
    }
    Bounded x(0.8), y(0);
    EXPECT_EQ(LensOracle::NOT_SEEN, LensOracle(Mat(Vec4d(-0.25, 0, 0, 0))).invert(x, y));
}

//! The distorted radius r (1 - 0.25 r^2) has its maximum, 0.77, at r^2 = 4 / 3. Points with a
//! larger distorted radius are not seen by the lens and must become NaN, as must points that are
//! not finite.
TEST(Usac_Lens, what_is_not_seen_is_not_a_number)
{
    const Matx33d camera(1000, 0, 0, 0, 1000, 0, 0, 0, 1);
    const Vec4d distortion(-0.25, 0, 0, 0);
    std::vector<Point2d> points;
    points.push_back(Point2d(769, 0));
    points.push_back(Point2d(0, -771));
    points.push_back(Point2d(5000, 5000));
    points.push_back(Point2d(NAN, 3));
    points.push_back(Point2d(3, INFINITY));
    const Mat found = removeDistortion(points, camera, distortion);
    EXPECT_GT(found.at<double>(0, 0), 1000);
    EXPECT_NEAR(0, found.at<double>(0, 1), 1e-9);
    for (int i = 1; i < found.rows; ++i)
        for (int k = 0; k < 2; ++k)
            EXPECT_TRUE(cvIsNaN(found.at<double>(i, k))) << i << " " << k;
}

TEST(Usac_Lens, mistakes_are_named)
{
    const std::vector<Point2d> points(3, Point2d(1, 2));
    expectException([&]() { removeDistortion(Mat::zeros(1, 4, CV_64F), LENS_CAMERA, lens(4)); },
                    "points");
    expectException([&]() { removeDistortion(points, Mat::zeros(3, 3, CV_64F), lens(4)); },
                    "cameraMatrix");
    expectException([&]() { removeDistortion(points, LENS_CAMERA, Vec3d(1, 2, 3)); }, "distCoeffs");
}

}  // namespace
}  // namespace opencv_test
