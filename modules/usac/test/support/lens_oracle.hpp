// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_LENS_ORACLE_HPP
#define OPENCV_USACV20_TEST_LENS_ORACLE_HPP

#include <cfloat>

#include "support/bounded.hpp"
#include "opencv2/core.hpp"

namespace opencv_test {

//! Bound of the relative rounding error of sums and products of some dozens of numbers in any
//! order, and of a pose whose rotation is made orthogonal once more.
const double ROUNDING = 300 * DBL_EPSILON;
//! If the radius of a point differs relatively by less than this from that of a fold of the lens,
//! where the distorted radius has a maximum, the oracle does not decide.
const double OFF_FOLD = 1e-3;

/** Inverts the lens distortion by cv::projectPoints alone. The undistorted point is found by
Newton's method with the derivatives of that function; the remaining residual bounds its error.
Points are not seen beyond the smallest radius at which the distorted radius, by the radial terms,
begins to decrease. */
class LensOracle
{
public:
    enum Answer { NOT_SEEN, SEEN, UNDECIDED };

    //! @param distortion 4 to 14 coefficients, or none
    explicit LensOracle(const cv::Mat& distortion);

    //! Replaces the distorted point x, y by the point of the normalized image plane that is seen
    //! there.
    Answer invert(Bounded& x, Bounded& y) const;

private:
    double radial(double radius) const;
    bool grows(double radius) const;
    Answer startOf(const cv::Vec2d& seen, cv::Vec2d& point) const;
    cv::Vec2d distort(const cv::Vec2d& point, cv::Matx22d& J, double& rounding) const;

    double d[14];
};

}  // namespace opencv_test

#endif
