// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_MOTIONS_HPP
#define OPENCV_USACV20_MOTIONS_HPP

#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

//! Motion from camera 1 to camera 2: X2 = R X1 + t, where the length of t is undetermined.
struct Motion
{
    Matx33d R;
    Vec3d t;

    //! The essential matrix [t]x R, scaled to the singular values (1, 1, 0) / sqrt(2).
    Matx33d essential() const;
};

//! Computes the four motions of an essential matrix: two rotations, each with t and with -t.
void motionsOf(const Matx33d& E, Motion motions[4]);

/** @brief Computes the two camera motions that explain the homography of a plane whose points are
in front of both cameras @cite ma2004invitation.
@param H homography of the plane from image plane 1 to image plane 2
@param x image of a point of the plane on image plane 1, homogeneous; the point is in front of both
cameras
@param motions output
@return false if H is singular or the camera has only rotated, so that the plane is undetermined */
bool motionsOfPlane(const Matx33d& H, const Vec3d& x, Motion motions[2]);

/** @brief True if the triangulated point of a match is in front of both cameras.

A match also counts as in front if its point can be at infinity up to noise, because noise can then
move the point behind a camera.
@param motion motion from camera 1 to camera 2
@param x1, x2 the points of the match on the normalized image planes, homogeneous
@param threshold the point can be at infinity if the distance, on image plane 2, between x2 and the
image of the point at infinity on the ray of x1 is at most this value */
bool inFront(const Motion& motion, const Vec3d& x1, const Vec3d& x2, double threshold);

}  // namespace usacv20
}  // namespace cv

#endif
