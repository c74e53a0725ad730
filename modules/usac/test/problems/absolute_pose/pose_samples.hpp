// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_POSE_SAMPLES_HPP
#define OPENCV_USACV20_TEST_POSE_SAMPLES_HPP

#include "opencv2/core.hpp"

namespace opencv_test {

//! Three points X, and a pose for which their images on the normalized image plane are exact.
struct PoseSample
{
    cv::Vec3d X[3];
    cv::Point2d image[3];
    cv::Matx34d pose;
    double size;  //!< largest distance of a point from the mean of the three points
};

//! Positions of the points in camera coordinates. No angle of the triangle is within one degree of
//! 0 or 180 degrees.
enum PoseSampleKind {
    CUBE,           //!< in a cube of side 2 whose center has depth 3
    FRONTAL_PLANE,  //!< on a plane parallel to the image
    NEAR_PLANE,     //!< the same, but depths vary by up to 1e-4
    FAR_AWAY,       //!< in a cube of side 2 at a depth of 100 sides
    VERY_FAR,       //!< in a cube of side 2 at a depth of 10 000 sides
    CLOSE,          //!< depths 0.01 to 1, width and height 2
    NARROW,         //!< in a field of view of 5 degrees
    WIDE,           //!< in a field of view of 120 degrees
    FLAT_TRIANGLE,  //!< the smallest angle is 1 to 2 degrees
    POSE_SAMPLE_KINDS
};
extern const char* const POSE_SAMPLE_NAMES[POSE_SAMPLE_KINDS];

PoseSample randomPoseSample(PoseSampleKind kind, cv::RNG& rng);

/** @brief A sample of the points Y, given in camera coordinates. The camera has a random pose in
the coordinates of PoseSample::X.

The image points are projected from the rounded X in long double, so that their only error is their
own rounding to double. */
PoseSample poseSampleOf(const cv::Vec3d (&Y)[3], cv::RNG& rng);

//! A triangle seen from `center`. Its corners are at `angles` (radians) on the circle of radius 1
//! around the origin in the plane z = 0.
PoseSample triangleSeenFrom(const cv::Vec3d& center, const double (&angles)[3], cv::RNG& rng);

//! Smallest difference in degrees between an angle of the triangle and 0 or 180 degrees.
double flatness(const cv::Vec3d (&Y)[3]);

//! Largest reprojection error on the normalized image plane; DBL_MAX if a point is not in front of
//! the camera.
double reprojectionError(const PoseSample& sample, const cv::Matx34d& pose);

//! Maximum of the difference of the rotations (Frobenius norm) and the difference of the
//! translations divided by PoseSample::size.
double poseDistance(const PoseSample& sample, const cv::Matx34d& a, const cv::Matx34d& b);

}  // namespace opencv_test

#endif
