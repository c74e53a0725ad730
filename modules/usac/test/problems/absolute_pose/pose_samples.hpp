// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_POSE_SAMPLES_HPP
#define OPENCV_USACV20_TEST_POSE_SAMPLES_HPP

#include "opencv2/core.hpp"

namespace opencv_test {

//! Three points and a pose that the images are exact for.
struct PoseSample
{
    cv::Vec3d X[3];
    cv::Point2d image[3];
    cv::Matx34d pose;
    double size;  //!< distance of the farthest point from their mean
};

//! What the points are like. No angle of a triangle is less than one degree from a line.
enum PoseSampleKind {
    CUBE,           //!< of side 2, at depth 3
    FRONTAL_PLANE,  //!< parallel to the image
    NEAR_PLANE,     //!< the same, but for 1e-4 in depth
    FAR_AWAY,       //!< the depth is 100 times the size
    VERY_FAR,       //!< 10 000 times
    CLOSE,          //!< depths 0.01 to 1 of a cube of side 2
    NARROW,         //!< a field of view of 5 degrees
    WIDE,           //!< 120 degrees
    FLAT_TRIANGLE,  //!< the least angle is one of 1 to 2 degrees
    POSE_SAMPLE_KINDS
};
extern const char* const POSE_SAMPLE_NAMES[POSE_SAMPLE_KINDS];

PoseSample randomPoseSample(PoseSampleKind kind, cv::RNG& rng);

/** @brief Object coordinates, in a random pose, of points in camera coordinates.

The image points are projected from the rounded object coordinates in long double, so that only
their own rounding to double is left.
*/
PoseSample poseSampleOf(const cv::Vec3d (&Y)[3], cv::RNG& rng);

//! A triangle of the circle of radius 1 around the axis of z, its corners at the angles (radians),
//! seen from a point.
PoseSample triangleSeenFrom(const cv::Vec3d& center, const double (&angles)[3], cv::RNG& rng);

//! Of all angles of a triangle, the least that is missing to 0 or 180 degrees.
double flatness(const cv::Vec3d (&Y)[3]);

//! Largest distance on the image plane; DBL_MAX if a point is not in front of the camera.
double reprojectionError(const PoseSample& sample, const cv::Matx34d& pose);

//! The larger one of the difference of the rotations (Frobenius norm) and that of the translations
//! over the size.
double poseDistance(const PoseSample& sample, const cv::Matx34d& a, const cv::Matx34d& b);

}  // namespace opencv_test

#endif
