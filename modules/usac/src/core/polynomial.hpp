// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_POLYNOMIAL_HPP
#define OPENCV_USACV20_POLYNOMIAL_HPP

namespace cv {
namespace usacv20 {

//! Highest degree that #realRoots accepts.
constexpr int MAX_DEGREE = 10;

/** @brief Real roots of a polynomial, in no particular order, each once.

The roots of the derivative isolate those in [-1, 1]; the others are inverses of roots of the
reversed polynomial. Newton's method inside a bracket refines them to double precision. A cubic is
solved in closed form.
@param coefficients degree + 1 numbers, the constant term first
@param degree at most #MAX_DEGREE
@param roots output, at most `degree`
@return number of roots; 0 for a constant and for coefficients that are not finite.
@cite press2007numerical */
int realRoots(const double* coefficients, int degree, double* roots);

//! Bounds of the roots of a polynomial and of the reversed one. No round numbers, because Sturm's
//! theorem excludes a root at the lower end of the interval.
constexpr double LOWEST = -1.0009765625, HIGHEST = 1.0007;

//! The roots in (#LOWEST, #HIGHEST] of a polynomial whose largest coefficient is 1.
int rootsNearZero(const double* coefficients, int degree, double* roots);

}  // namespace usacv20
}  // namespace cv

#endif
