// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_MOTIONS_HPP
#define OPENCV_USACV20_MOTIONS_HPP

#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

//! From camera 1 to camera 2: X2 = R X1 + t; the length of t is unknown.
struct Motion
{
    Matx33d R;
    Vec3d t;

    //! [t]x R with singular values (1, 1, 0) / sqrt(2).
    Matx33d essential() const;
};

//! The four motions of an essential matrix: two rotations, each with t and with -t.
void motionsOf(const Matx33d& E, Motion motions[4]);

/** @brief The two camera motions that explain the homography of a plane whose points are in front
of both cameras @cite ma2004invitation.
@param H homography of the plane from image plane 1 to image plane 2
@param x a point of the plane in image plane 1, homogeneous, in front of both cameras
@param motions output
@return false if H is singular or the camera has only rotated, so that the plane is undetermined */
bool motionsOfPlane(const Matx33d& H, const Vec3d& x, Motion motions[2]);

/** @brief True if the point of a match is in front of both cameras.
@param motion of the cameras
@param x1, x2 the match on the image planes, homogeneous
@param threshold if x2 is within this distance, on image plane 2, of the image of the point at
infinity on the ray of x1, the match counts as in front, because noise may put its point behind a
camera */
bool inFront(const Motion& motion, const Vec3d& x1, const Vec3d& x2, double threshold);

}  // namespace usacv20
}  // namespace cv

#endif
