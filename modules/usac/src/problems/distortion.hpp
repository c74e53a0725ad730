// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_DISTORTION_HPP
#define OPENCV_USACV20_DISTORTION_HPP

#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

/** @brief OpenCV's model of lens distortion, on the normalized image plane.

The coefficients are k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 tau_x tau_y, in this order (see
cv::projectPoints): rational radial terms k, tangential terms p, thin prism terms s, and the tilt of
the sensor tau. Many such models are valid near the center of the image only: beyond a certain
radius, the first fold, the radius that the radial terms alone give no longer grows with the
undistorted radius, or becomes infinite. Points beyond the first fold are treated as not seen by the
camera. */
class Distortion
{
public:
    //! @param coefficients a matrix (of any depth) with the first coefficients of the list above,
    //! as returned by readDistortion(); an empty matrix means that there is no distortion
    explicit Distortion(const Mat& coefficients);

    bool none() const { return identity; }
    /** @brief Distorts a point.
    @param p the point
    @param d output, distorted point
    @param derivative output, derivative of `d` with respect to `p`; can be null
    @return false if the camera does not see `p`, or if `p` is NaN */
    bool distort(const Vec2d& p, Vec2d& d, Matx22d* derivative = 0) const;
    //! Finds a point `p` that distort() maps to `d` up to an error of at most 1e-11 (1 + |d|); the
    //! error is usually as small as rounding errors. False if no such point is found.
    bool undistort(const Vec2d& d, Vec2d& p) const;
    //! Undistorts `count` points in place. A point for which no undistorted point is found becomes
    //! NaN.
    void undistort(double* x, double* y, int count) const;

private:
    enum { COEFFICIENTS = 14 };

    double radial(double squared, double* derivative = 0) const;
    double firstFold() const;
    bool startOf(const Vec2d& d, Vec2d& p) const;
    bool descend(const Vec2d& d, Vec2d& p) const;

    bool identity, straight;  //!< no distortion at all; no tilt of the sensor
    double c[COEFFICIENTS];
    Matx33d tilt;
    double limit;  //!< squared radius of the first fold; INFINITY: there is no fold
};

}  // namespace usacv20
}  // namespace cv

#endif
