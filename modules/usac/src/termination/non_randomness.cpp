// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "termination/non_randomness.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! log(n!) minus Stirling's formula, n > 0.
double stirlingError(double n)
{
    if (n > 15)
    {
        const double r = 1 / (n * n);
        return (1. / 12 - (1. / 360 - (1. / 1260 - r / 1680) * r) * r) / n;
    }
    double factorial = 1;
    for (int i = 2; i <= (int)n; ++i)
        factorial *= i;
    return std::log(factorial) - 0.5 * std::log(2 * CV_PI * n) - n * std::log(n) + n;
}

//! x log(x / mean) + mean - x, x > 0.
double deviance(double x, double mean)
{
    return mean - x + x * (2 * mean < x ? std::log(x / mean) : -std::log1p((mean - x) / x));
}

//! P(Binomial(n, p) = k) for 0 <= k <= n, 0 < p < 1.
double binomial(double k, double n, double p)
{
    if (k == 0)
        return std::exp(n * std::log1p(-p));
    if (k == n)
        return std::exp(n * std::log(p));
    const double exponent = stirlingError(n) - stirlingError(k) - stirlingError(n - k) -
                            deviance(k, n * p) - deviance(n - k, n * (1 - p));
    return std::exp(exponent) * std::sqrt(n / (2 * CV_PI * k * (n - k)));
}

//! P(Binomial(n, p) >= k)
double upperTail(int k, int n, double p)
{
    const double odds = p / (1 - p);
    double sum = 0;
    if (k > n * p)
    {
        double term = binomial(k, n, p);
        for (int j = k; j <= n && term > 1e-17 * sum; ++j)
        {
            sum += term;
            term *= (double)(n - j) / (j + 1) * odds;
        }
        return std::min(sum, 1.);
    }
    double term = binomial(k - 1, n, p);
    for (int j = k - 1; j >= 0 && term > 1e-17 * sum; --j)
    {
        sum += term;
        term *= j / ((double)(n - j + 1) * odds);
    }
    return std::max(1 - sum, 0.);
}

}  // namespace

double chanceOf(int inliers, int n, int m, double randomRatio)
{
    if (inliers <= m)
        return 1;
    if (inliers > n || !(randomRatio > 0))
        return 0;
    return randomRatio < 1 ? upperTail(inliers - m, n - m, randomRatio) : 1;
}

}  // namespace usacv20
}  // namespace cv
