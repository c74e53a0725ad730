// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_INTEGRATE_HPP
#define OPENCV_USACV20_TEST_INTEGRATE_HPP

namespace opencv_test {

//! Integral of f from `from` to `to` by Simpson's rule with 2 * steps intervals.
template <class F>
double integrate(const F& f, double from, double to, int steps)
{
    const double h = (to - from) / (2 * steps);
    double sum = f(from) + f(to);
    for (int i = 1; i < 2 * steps; ++i)
        sum += (i % 2 ? 4 : 2) * f(from + i * h);
    return sum * h / 3;
}

}  // namespace opencv_test

#endif
