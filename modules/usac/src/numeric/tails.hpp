// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TAILS_HPP
#define OPENCV_USACV20_TAILS_HPP

namespace cv {
namespace usacv20 {

/** @brief P(Binomial(n, p) >= k), 0 <= k <= n, 0 < p < 1.

Exact sum of the terms on the side of the distribution where they decrease: the first in the form of
@cite loader2000fast, which avoids cancellation, the others by the ratios of neighboring terms. 0 if
the probability is below the range of double. At most O(n) time, mostly O(sqrt(n)). */
double binomialTail(int k, int n, double p);

/** @brief Probability that at least `successes` of `trials` succeed, given that `earlierSuccesses`
of `earlierTrials` did and that the prior of their common probability is uniform: the upper tail of
the beta-binomial distribution @cite gelman2013bayesian.

With many earlier trials it is close to the tail of the binomial distribution; with few it is wider,
as they tell little about the common probability. Summed like binomialTail(); the first term is
accurate to 1e-9. At most O(trials) time, usually O(sqrt(trials)). */
double betaBinomialTail(int successes, int trials, int earlierSuccesses, int earlierTrials);

//! log(n!), n >= 0.
double logFactorial(double n);

}  // namespace usacv20
}  // namespace cv

#endif
