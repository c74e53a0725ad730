// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_DISTORTION_HPP
#define OPENCV_USACV20_DISTORTION_HPP

#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

/** @brief OpenCV's model of lens distortion, on the normalized image plane.

Rational radial terms k1 to k6, tangential p1, p2, thin prism s1 to s4, tilt of the sensor tau_x,
tau_y; in the order k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 tau_x tau_y (see cv::projectPoints). A model
with few coefficients is valid near the center of the image only: beyond some radius, the radial
terms fold the plane back onto itself. Points outside the first fold are not seen. */
class Distortion
{
public:
    //! @param coefficients the first ones of the list above, any depth, as readDistortion() returns
    //! them; empty: no distortion
    explicit Distortion(const Mat& coefficients);

    bool none() const { return identity; }
    /** @brief Distorts a point.
    @param p the point
    @param d output, distorted point
    @param derivative output, of `d` with respect to `p`; may be null
    @return false if `p` is not seen */
    bool distort(const Vec2d& p, Vec2d& d, Matx22d* derivative = 0) const;
    //! Finds the point `p` that distort() maps to `d`, to double precision. False if there is none.
    bool undistort(const Vec2d& d, Vec2d& p) const;
    //! The same for many points, in place; NaN where there is no such point.
    void undistort(double* x, double* y, int count) const;

private:
    enum { COEFFICIENTS = 14 };

    double radial(double squared, double* derivative = 0) const;
    double firstFold() const;
    bool startOf(const Vec2d& d, Vec2d& p) const;
    bool descend(const Vec2d& d, Vec2d& p) const;

    bool identity, straight;  //!< no distortion; the sensor is not tilted
    double c[COEFFICIENTS];
    Matx33d tilt;
    double limit;  //!< squared radius of the first fold
};

}  // namespace usacv20
}  // namespace cv

#endif
