// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/polynomial.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! A polynomial with its derivative, evaluated together by Horner's scheme.
struct Polynomial
{
    const double* c;
    int degree;

    void evaluate(double x, double& value, double& slope) const
    {
        value = c[degree];
        slope = 0;
        for (int i = degree - 1; i >= 0; --i)
        {
            slope = slope * x + value;
            value = value * x + c[i];
        }
    }
};

//! The root in (low, high], where the polynomial changes sign; `atLow` is its value at `low`. Uses
//! Newton's method, or bisection where a Newton step leaves the bracket.
double refine(const Polynomial& p, double low, double high, double atLow)
{
    double x = 0.5 * (low + high);
    for (int i = 0; i < 60; ++i)
    {
        double value, slope;
        p.evaluate(x, value, slope);
        if (value == 0)
            return x;
        ((value < 0) == (atLow < 0) ? low : high) = x;
        double next = x - value / slope;
        const bool inside = next > low && next < high;
        if (!inside)
            next = 0.5 * (low + high);
        // Newton's method converges quadratically: a step of 1e-9 times x leaves a relative error
        // of about 1e-18
        if (std::abs(next - x) <= (inside ? 1e-9 : 4e-16) * std::abs(x))
            return next;
        x = next;
    }
    return x;
}

//! The roots in (LOWEST, HIGHEST], bracketed by the roots of the derivative. This recursion is
//! slower than Sturm's sequence, but works for every polynomial. @return number of roots
int betweenExtrema(const Polynomial& p, double* roots)
{
    if (p.degree <= 1)
    {
        roots[0] = -p.c[0] / p.c[1];
        return roots[0] > LOWEST && roots[0] <= HIGHEST;
    }
    double derivative[MAX_DEGREE], bounds[MAX_DEGREE + 1], before, here, slope;
    for (int i = 0; i < p.degree; ++i)
        derivative[i] = (i + 1) * p.c[i + 1];
    const Polynomial d = {derivative, p.degree - 1};
    bounds[0] = LOWEST;
    const int extrema = betweenExtrema(d, bounds + 1);
    bounds[extrema + 1] = HIGHEST;
    int count = 0;
    p.evaluate(LOWEST, before, slope);
    for (int k = 1; k <= extrema + 1; ++k, before = here)
    {
        p.evaluate(bounds[k], here, slope);
        if (k <= extrema && std::abs(here) <= 1e-15)
        {
            roots[count++] = bounds[k];  // the polynomial is 0 at an extremum: a multiple root
            here = 0;
        }
        else if (before != 0 && (before < 0) != (here < 0))
            roots[count++] = refine(p, bounds[k - 1], bounds[k], before);
    }
    return count;
}

//! The result of one Newton step from x, or x itself if the step does not reduce the absolute value
//! of the polynomial.
double polish(const Polynomial& p, double x)
{
    double value, slope, newValue, newSlope;
    p.evaluate(x, value, slope);
    const double next = x - value / slope;
    p.evaluate(next, newValue, newSlope);
    return std::abs(newValue) < std::abs(value) ? next : x;
}

/** Roots of a cubic in closed form, by Viete's cosines or Cardano's cube root
@cite press2007numerical; double roots are listed once. The leading coefficient must not be small.
*/
int cubicRoots(const double* c, double* roots)
{
    const Polynomial p = {c, 3};
    const double a = c[2] / c[3], b = c[1] / c[3], d = c[0] / c[3];
    const double Q = (a * a - 3 * b) / 9, R = (2 * a * a * a - 9 * a * b + 27 * d) / 54,
                 excess = R * R - Q * Q * Q;
    const bool twice = std::abs(excess) <= 1e-13 * R * R;
    int count = 1;
    if (excess < 0 && !twice)
    {
        const double angle = std::acos(R / std::sqrt(Q * Q * Q)), size = -2 * std::sqrt(Q);
        for (count = 0; count < 3; ++count)
            roots[count] = size * std::cos((angle + (count - 1) * 2 * CV_PI) / 3) - a / 3;
    }
    else
    {
        const double A = (R > 0 ? -1 : 1) *
                         std::cbrt(std::abs(R) + std::sqrt(std::max(excess, 0.))),
                     B = A != 0 ? Q / A : 0;
        roots[0] = A + B - a / 3;
        if (twice && A != 0)
            roots[count++] = -0.5 * (A + B) - a / 3;
    }
    for (int i = 0; i < count; ++i)
        roots[i] = polish(p, polish(p, roots[i]));
    return std::abs(roots[0]) <= DBL_MAX ? count : 0;  // no roots if a coefficient is NaN
}

}  // namespace

int rootsNearZero(const double* coefficients, int degree, double* roots)
{
    while (degree > 0 && std::abs(coefficients[degree]) <= 1e-14)
        --degree;
    const Polynomial p = {coefficients, degree};
    return degree > 0 ? betweenExtrema(p, roots) : 0;
}

int realRoots(const double* coefficients, int degree, double* roots)
{
    double largest = 0, c[MAX_DEGREE + 1], reversed[MAX_DEGREE + 1];
    for (int i = 0; i <= degree; ++i)
        largest = std::max(largest, std::abs(coefficients[i]));
    if (!(largest > 0 && largest <= DBL_MAX))
        return 0;
    while (degree > 0 && std::abs(coefficients[degree]) <= 1e-14 * largest)
        --degree;
    if (degree == 0)
        return 0;
    for (int i = 0; i <= degree; ++i)
        c[i] = reversed[degree - i] = coefficients[i] / largest;
    if (degree == 3 && std::abs(c[3]) > 1e-3)
        return cubicRoots(c, roots);
    int count = rootsNearZero(c, degree, roots);
    double inverses[MAX_DEGREE];
    const int more = rootsNearZero(reversed, degree, inverses);
    for (int i = 0; i < more && count < degree; ++i)
    {
        const double root = 1 / inverses[i];
        if (std::abs(root) <= DBL_MAX && (root <= LOWEST || root > HIGHEST))
            roots[count++] = root;
    }
    return count;
}

}  // namespace usacv20
}  // namespace cv
