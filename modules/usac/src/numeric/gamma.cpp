// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/gamma.hpp"

namespace cv {
namespace usacv20 {

namespace {

constexpr int MAX_TERMS = 1000;  // limit of every loop; usually a few dozen terms are enough

//! x^a exp(-x) times the sum of x^n / (a (a+1) .. (a+n)) over n >= 0.
double lowerSeries(double a, double x)
{
    double term = 1 / a, sum = term;
    for (int n = 1; n < MAX_TERMS && term > sum * DBL_EPSILON; ++n)
    {
        term *= x / (a + n);
        sum += term;
    }
    return sum * std::pow(x, a) * std::exp(-x);
}

//! The exponential integral E_1: -C - log(x) - S, where C is Euler's constant and S is the sum of
//! (-x)^n / (n n!) over n >= 1.
double exponentialSeries(double x)
{
    double power = 1, sum = -0.57721566490153286061 - std::log(x);
    for (int n = 1; n < MAX_TERMS && std::abs(power) > DBL_EPSILON * std::abs(sum); ++n)
    {
        power *= -x / n;
        sum -= power / n;
    }
    return sum;
}

//! x^a exp(-x) / (x+1-a - 1(1-a) / (x+3-a - 2(2-a) / (x+5-a - ...))), a continued fraction that is
//! evaluated from the first term on by Lentz's method.
double upperFraction(double a, double x)
{
    double b = x + 1 - a, c = 1 / DBL_MIN, d = 1 / b, h = d;
    for (int n = 1; n < MAX_TERMS; ++n)
    {
        const double numerator = n * (a - n);
        b += 2;
        d = 1 / (b + numerator * d);
        c = b + numerator / c;
        h *= c * d;
        if (std::abs(c * d - 1) <= DBL_EPSILON)
            break;
    }
    return h * std::pow(x, a) * std::exp(-x);
}

}  // namespace

double gammaFunction(double a)
{
    CV_Assert(a > 0);
    const bool whole = a == std::floor(a);
    if (2 * a != std::floor(2 * a))
        return lowerSeries(a, a + 1) + upperFraction(a, a + 1);
    double product = whole ? 1 : 1.7724538509055160273;  // sqrt(pi)
    for (double k = whole ? 1 : 0.5; k < a; ++k)
        product *= k;
    return product;
}

double lowerGamma(double a, double x)
{
    if (!(x > 0))
        return 0;
    return x < a + 1 ? lowerSeries(a, x) : gammaFunction(a) - upperFraction(a, x);
}

double upperGamma(double a, double x)
{
    if (x >= a + 1)
        return upperFraction(a, x);
    if (a > 0)
        return gammaFunction(a) - lowerGamma(a, x);
    return x > 0 ? exponentialSeries(x) : std::numeric_limits<double>::infinity();
}

}  // namespace usacv20
}  // namespace cv
