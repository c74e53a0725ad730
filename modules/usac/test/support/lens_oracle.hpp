// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_LENS_ORACLE_HPP
#define OPENCV_USACV20_TEST_LENS_ORACLE_HPP

#include <cfloat>

#include "support/bounded.hpp"
#include "opencv2/core.hpp"

namespace opencv_test {

//! Bound of the rounding error of sums of some dozens of products in any order, relative to the sum
//! of the absolute values of the terms. It also covers the error of orthogonalizing a
//! rotation matrix again.
const double ROUNDING = 300 * DBL_EPSILON;
//! The oracles do not decide about points whose radius differs by less than this fraction from the
//! radius of a fold of the lens, that is, of a maximum of the distorted radius.
const double OFF_FOLD = 1e-3;

/** Inverts the lens distortion without code of the module: the undistorted point is found by
Newton's method with the values and derivatives of cv::projectPoints. The largest accepted residual
gives a bound of the point's error. The distorted radius, as a function of the undistorted one, can
have a maximum. If the distortion is only radial, a point with a distorted radius above the first
maximum is not seen. With other distortion, the oracle does not decide about such points, nor about
points behind a fold of the other terms. */
class LensOracle
{
public:
    enum Answer { NOT_SEEN, SEEN, UNDECIDED };

    //! @param distortion 4 to 14 coefficients, or none
    explicit LensOracle(const cv::Mat& distortion);

    //! If the answer is SEEN, the distorted point x, y is replaced by the point of the normalized
    //! image plane that is seen there. Otherwise x, y are not changed.
    Answer invert(Bounded& x, Bounded& y) const;

private:
    double radial(double radius) const;
    bool grows(double radius) const;
    bool unfolded(const cv::Vec2d& point) const;
    Answer startOf(const cv::Vec2d& seen, cv::Vec2d& point) const;
    cv::Vec2d distort(const cv::Vec2d& point, cv::Matx22d& J, double& rounding) const;

    double d[14];
};

}  // namespace opencv_test

#endif
