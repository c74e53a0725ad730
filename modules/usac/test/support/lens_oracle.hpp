// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_LENS_ORACLE_HPP
#define OPENCV_USACV20_TEST_LENS_ORACLE_HPP

#include "support/bounded.hpp"
#include "opencv2/core.hpp"

namespace opencv_test {

/** What is seen through a lens, by cv::projectPoints alone: the point that it moves to a given
place is found by Newton's method with the derivatives of that function, and its bound by what is
left then. Beyond the first radius from which the radial terms lead back nothing is seen. */
class LensOracle
{
public:
    enum Answer { NOT_SEEN, SEEN, UNDECIDED };

    //! @param distortion 4 to 14 coefficients, or none
    explicit LensOracle(const cv::Mat& distortion);

    //! The point of the normalized image plane that is seen at x, y, which it replaces.
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
