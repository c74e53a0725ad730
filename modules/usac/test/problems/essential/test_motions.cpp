// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/random_rotation.hpp"
#include "problems/essential/motions.hpp"

// Tests of motionsOfPlane(), which computes the two camera motions that explain the homography of a
// plane.

namespace opencv_test {
namespace {

//! The class with R and t; opencv_test::Motion is an enumeration of the motions in test scenes.
typedef cv::usacv20::Motion CameraMotion;

//! A camera motion, and a plane n^T X = 1 with n of unit length. If the translation is shorter than
//! 1, the two camera centers are on the same side of the plane.
struct Plane
{
    explicit Plane(RNG& rng)
        : R(randomRotation(rng)), t(uniformVector(rng, -1., 1.)), n(uniformVector(rng, -1., 1.))
    {
        t *= 1 / cv::norm(t);
        n *= 1 / cv::norm(n);
    }

    //! Homography of the plane from image 1 to image 2, for the motion X2 = R X1 + `length` t.
    Matx33d homography(double length) const { return R + Matx33d(Mat(t * length * n.t())); }

    Matx33d R;
    Vec3d t, n;
};

//! Distance of the closer one of two motions from the true rotation and direction of translation.
double distanceOf(const CameraMotion motions[2], const Plane& plane)
{
    double least = INFINITY;
    for (int k = 0; k < 2; ++k)
        least = std::min(least, cvtest::norm(motions[k].R - plane.R, NORM_INF) +
                                    cvtest::norm(motions[k].t - plane.t, NORM_INF));
    return least;
}

TEST(Usac_Motions, ofAPlane)
{
    RNG rng(1);
    for (int i = 0; i < 1000; ++i)
    {
        const Plane plane(rng);
        const double scale = rng.uniform(-3., 3.);
        CameraMotion motions[2];
        ASSERT_TRUE(motionsOfPlane(plane.homography(0.5) * scale, plane.n, motions));
        EXPECT_LE(distanceOf(motions, plane), 1e-10) << i;
    }
}

//! The homography of a pure rotation does not depend on the plane, and a singular matrix maps the
//! plane to a line or a point. motionsOfPlane() must then find no motions. A translation of 1e-10
//! (the distance of the plane is 1) must count as none, one of 1e-6 must not. The scale of H must
//! not matter.
TEST(Usac_Motions, areUndeterminedByARotationOrASingularMatrix)
{
    RNG rng(2);
    CameraMotion motions[2];
    for (int i = 0; i < 1000; ++i)
    {
        const Plane plane(rng);
        const double scale = rng.uniform(-3., 3.);
        EXPECT_FALSE(motionsOfPlane(plane.R * scale, plane.n, motions)) << i;
        EXPECT_FALSE(motionsOfPlane(plane.homography(1e-10) * scale, plane.n, motions)) << i;
        EXPECT_TRUE(motionsOfPlane(plane.homography(1e-6) * scale, plane.n, motions)) << i;
    }
    EXPECT_FALSE(motionsOfPlane(Matx33d(1, 0, 0, 0, 1, 0, 0, 0, 0), Vec3d(0, 0, 1), motions));
    EXPECT_FALSE(motionsOfPlane(Matx33d(1, 0, 0, 0, 0, 0, 0, 0, 0), Vec3d(0, 0, 1), motions));
    EXPECT_FALSE(motionsOfPlane(Matx33d::zeros(), Vec3d(0, 0, 1), motions));
}

}  // namespace
}  // namespace opencv_test
