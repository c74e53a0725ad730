// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_GAMMA_HPP
#define OPENCV_USACV20_GAMMA_HPP

namespace cv {
namespace usacv20 {

/* Incomplete gamma functions, from power series for x < a + 1 and from continued fractions for
larger x @cite press2007numerical. The relative error is about 1e-14. */

//! The gamma function, a > 0. std::tgamma is not used, because the last bit of its result differs
//! between versions of glibc.
double gammaFunction(double a);
//! Integral of t^(a-1) exp(-t) over 0 .. x; a > 0, x >= 0.
double lowerGamma(double a, double x);
//! Integral of t^(a-1) exp(-t) over x .. infinity; a >= 0, x >= 0. For a = 0, the integral
//! is the exponential integral E_1, infinite at x = 0.
double upperGamma(double a, double x);

}  // namespace usacv20
}  // namespace cv

#endif
