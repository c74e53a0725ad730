// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_DISTORTION_HPP
#define OPENCV_USACV20_DISTORTION_HPP

#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

/** @brief How a lens moves points of the normalized image plane: OpenCV's model.

Rational radial terms k1 to k6, tangential p1, p2, thin prism s1 to s4, tilt of the sensor tau_x,
tau_y; in the order k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 tau_x tau_y (see cv::projectPoints). A model
of few coefficients is one of the middle of the image: from some radius on, the radial terms fold
the plane back upon itself. What lies outside the first fold is not seen. */
class Distortion
{
public:
    //! @param coefficients the first of them, any depth, as readDistortion() returns them; empty:
    //! nothing is moved
    explicit Distortion(const Mat& coefficients);

    bool none() const { return identity; }
    /** @brief Where a point of the plane is seen.
    @param p the point
    @param d output, where it is seen
    @param derivative output, of `d` by `p`; may be null
    @return false if it is not seen. */
    bool distort(const Vec2d& p, Vec2d& d, Matx22d* derivative = 0) const;
    //! The point that is seen at `d`, to double precision. False if there is none.
    bool undistort(const Vec2d& d, Vec2d& p) const;
    //! Of many points, in place; NaN where there is none.
    void undistort(double* x, double* y, int count) const;

private:
    enum { COEFFICIENTS = 14 };

    double radial(double squared, double* derivative = 0) const;
    double firstFold() const;
    bool startOf(const Vec2d& d, Vec2d& p) const;
    bool descend(const Vec2d& d, Vec2d& p) const;

    bool identity, straight;  //!< nothing is moved; the sensor is not tilted
    double c[COEFFICIENTS];
    Matx33d tilt;
    double limit;  //!< squared radius of the first fold
};

}  // namespace usacv20
}  // namespace cv

#endif
