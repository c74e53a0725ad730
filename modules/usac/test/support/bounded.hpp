// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_BOUNDED_HPP
#define OPENCV_USACV20_TEST_BOUNDED_HPP

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace opencv_test {

/** A number with a bound of its error due to rounding to double. The bound is several times the
rounding error of the operations below, so that it holds for sums and products in any order, and
tests need no tolerance. The bound is infinite if an intermediate result is too large for double, or
if a divisor could be 0. */
struct Bounded
{
    Bounded(long double v = 0, long double e = 0) : value(v), error(e)
    {
        if (!(std::abs(value) + error < DBL_MAX))
            error = HUGE_VALL;
    }
    long double value, error;
};

//! Bound of the relative rounding error of one operation.
const long double UNIT = 8 * DBL_EPSILON;

inline Bounded operator+(const Bounded& a, const Bounded& b)
{
    const long double v = a.value + b.value;
    return Bounded(v, a.error + b.error + UNIT * std::abs(v));
}

inline Bounded operator-(const Bounded& a, const Bounded& b)
{
    return a + Bounded(-b.value, b.error);
}

inline Bounded operator*(const Bounded& a, const Bounded& b)
{
    const long double v = a.value * b.value;
    return Bounded(v, std::abs(a.value) * b.error + (std::abs(b.value) + b.error) * a.error +
                          UNIT * std::abs(v) + DBL_MIN);
}

inline Bounded operator/(const Bounded& a, const Bounded& b)
{
    const long double least = std::abs(b.value) - b.error;
    if (!(least > DBL_MIN))
        return Bounded(0, HUGE_VALL);
    const long double v = a.value / b.value;
    return Bounded(v, (a.error + std::abs(v) * b.error) / least + UNIT * std::abs(v) + DBL_MIN);
}

inline Bounded squareRoot(const Bounded& a)
{
    const long double high = std::sqrt(std::max(a.value, 0.L) + a.error),
                      low = std::sqrt(std::max(a.value - a.error, 0.L));
    return Bounded((high + low) / 2, (high - low) / 2 + UNIT * high);
}

}  // namespace opencv_test

#endif
