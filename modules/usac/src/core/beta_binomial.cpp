// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "core/beta_binomial.hpp"

namespace cv {
namespace usacv20 {

//! By Stirling's series, because std::lgamma writes to a global variable in some C libraries.
double logFactorial(double n)
{
    if (n < 16)
    {
        double factorial = 1;
        for (int i = 2; i <= (int)n; ++i)
            factorial *= i;
        return std::log(factorial);
    }
    const double r = 1 / (n * n);
    return (n + 0.5) * std::log(n) - n + 0.5 * std::log(2 * CV_PI) +
           (1. / 12 - (1. / 360 - (1. / 1260 - r / 1680) * r) * r) / n;
}

double betaBinomialTail(int successes, int trials, int earlierSuccesses, int earlierTrials)
{
    if (successes <= 0 || successes > trials)
        return successes <= 0 ? 1 : 0;
    const double n = trials, c = earlierSuccesses, f = earlierTrials - earlierSuccesses;
    const bool upper = successes > n * (c + 1) / (c + f + 2);
    double k = upper ? successes : successes - 1;
    double term = std::exp(logFactorial(n) - logFactorial(k) - logFactorial(n - k) +
                           logFactorial(k + c) + logFactorial(n - k + f) -
                           logFactorial(n + c + f + 1) + logFactorial(c + f + 1) - logFactorial(c) -
                           logFactorial(f));
    double sum = 0;
    for (; k >= 0 && k <= n && term > 1e-17 * sum; k += upper ? 1 : -1)
    {
        sum += term;
        term *= upper ? (n - k) / (k + 1) * ((k + c + 1) / (n - k + f))
                      : k / (n - k + 1) * ((n - k + f + 1) / (k + c));
    }
    return upper ? std::min(sum, 1.) : std::max(1 - sum, 0.);
}

}  // namespace usacv20
}  // namespace cv
