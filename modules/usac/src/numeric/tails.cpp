// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/tails.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! For n above this number, log(n!) is computed with Stirling's series. The first omitted term,
//! 1 / (1188 n^9), is at most 2.2e-14.
constexpr double LARGE = 15;

//! log(n!) minus the logarithm of Stirling's formula sqrt(2 pi n) (n / e)^n, from a series;
//! n > LARGE.
double stirlingSeries(double n)
{
    const double r = 1 / (n * n);
    return (1. / 12 - (1. / 360 - (1. / 1260 - r / 1680) * r) * r) / n;
}

double logOfSmallFactorial(double n)
{
    double factorial = 1;
    for (int i = 2; i <= (int)n; ++i)
        factorial *= i;
    return std::log(factorial);
}

//! Like stirlingSeries(), but for any n > 0.
double stirlingError(double n)
{
    if (n > LARGE)
        return stirlingSeries(n);
    return logOfSmallFactorial(n) - 0.5 * std::log(2 * CV_PI * n) - n * std::log(n) + n;
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

/** Upper tail of a distribution on 0 .. n, given by its probabilities ("terms").
@param upper true: the sum of the terms k, k + 1, ...; false: 1 minus the sum of the terms k, k - 1,
...
@param term the term k
@param ratio ratio(k) is the next term in the direction of the sum, divided by the term k */
template <class Ratio>
double sumOfTerms(bool upper, double k, double n, double term, const Ratio& ratio)
{
    double sum = 0;
    for (; k >= 0 && k <= n && term > 1e-17 * sum; k += upper ? 1 : -1)
    {
        sum += term;
        term *= ratio(k);
    }
    return upper ? std::min(sum, 1.) : std::max(1 - sum, 0.);
}

}  // namespace

//! std::lgamma is not used, because it writes to a global variable in some C libraries and is then
//! not safe in several threads.
double logFactorial(double n)
{
    if (n <= LARGE)
        return logOfSmallFactorial(n);
    return (n + 0.5) * std::log(n) - n + 0.5 * std::log(2 * CV_PI) + stirlingSeries(n);
}

double binomialTail(int k, int n, double p)
{
    const double odds = p / (1 - p);
    const bool upper = k > n * p;
    const int first = upper ? k : k - 1;
    return sumOfTerms(upper, first, n, binomial(first, n, p), [=](double j) {
        return upper ? (n - j) / (j + 1) * odds : j / ((n - j + 1) * odds);
    });
}

double betaBinomialTail(int successes, int trials, int earlierSuccesses, int earlierTrials)
{
    if (successes <= 0 || successes > trials)
        return successes <= 0 ? 1 : 0;
    const double n = trials, c = earlierSuccesses, f = earlierTrials - earlierSuccesses;
    const bool upper = successes > n * (c + 1) / (c + f + 2);
    const double first = upper ? successes : successes - 1;
    const double term = std::exp(logFactorial(n) - logFactorial(first) - logFactorial(n - first) +
                                 logFactorial(first + c) + logFactorial(n - first + f) -
                                 logFactorial(n + c + f + 1) + logFactorial(c + f + 1) -
                                 logFactorial(c) - logFactorial(f));
    return sumOfTerms(upper, first, n, term, [=](double k) {
        return upper ? (n - k) / (k + 1) * ((k + c + 1) / (n - k + f))
                     : k / (n - k + 1) * ((n - k + f + 1) / (k + c));
    });
}

}  // namespace usacv20
}  // namespace cv
