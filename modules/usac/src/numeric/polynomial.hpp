// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_POLYNOMIAL_HPP
#define OPENCV_USACV20_POLYNOMIAL_HPP

namespace cv {
namespace usacv20 {

//! Highest degree that #realRoots accepts.
constexpr int MAX_DEGREE = 10;

/** @brief Real roots of a polynomial, in no particular order; a multiple root is listed once.

Roots in (#LOWEST, #HIGHEST], about -1 to 1, are isolated by the roots of the derivative; the other
roots are inverses of roots of the polynomial with reversed coefficients. Newton's method inside a
bracket refines simple roots to double precision. A cubic whose leading coefficient is not small is
solved in closed form @cite press2007numerical.
@param coefficients degree + 1 numbers, the constant term first
@param degree at most #MAX_DEGREE
@param roots output, at most `degree`
@return number of roots; 0 for a constant and for coefficients that are not finite */
int realRoots(const double* coefficients, int degree, double* roots);

//! Roots outside these bounds are found from the polynomial with reversed coefficients. The bounds
//! are not -1 and 1, because these are likely roots, and Sturm's theorem, which
//! lanes/roots.inl.hpp uses with the same bounds, does not count a root at the lower end of an
//! interval.
constexpr double LOWEST = -1.0009765625, HIGHEST = 1.0007;

//! The roots in (#LOWEST, #HIGHEST] of a polynomial whose largest absolute coefficient is 1.
//! @return number of roots
int rootsNearZero(const double* coefficients, int degree, double* roots);

}  // namespace usacv20
}  // namespace cv

#endif
