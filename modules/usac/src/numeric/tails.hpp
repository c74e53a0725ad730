// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TAILS_HPP
#define OPENCV_USACV20_TAILS_HPP

namespace cv {
namespace usacv20 {

/** @brief P(Binomial(n, p) >= k), 0 <= k <= n, 0 < p < 1.

Sums the probabilities of k, k + 1, ... or, if k is not above the mean, those of k - 1, k - 2, ...,
which are then subtracted from 1. The first probability is computed as in @cite loader2000fast,
which avoids cancellation, and each of the others from its ratio to the one before. The result is 0
if it is below the range of double. Takes at most O(n) time, usually O(sqrt(n)). */
double binomialTail(int k, int n, double p);

/** @brief Probability that at least `successes` of `trials` trials succeed, given that
`earlierSuccesses` of `earlierTrials` trials succeeded and that the prior of the common probability
of success is uniform: the upper tail of the beta-binomial distribution @cite gelman2013bayesian.

With many earlier trials it is close to the tail of the binomial distribution. With few earlier
trials the tail is heavier, because the common probability of success is then hardly known. The sum
is computed as in binomialTail(); its first term has a relative error of up to 1e-9. Takes at most
O(trials) time, usually O(sqrt(trials)). */
double betaBinomialTail(int successes, int trials, int earlierSuccesses, int earlierTrials);

//! log(n!), n >= 0.
double logFactorial(double n);

}  // namespace usacv20
}  // namespace cv

#endif
