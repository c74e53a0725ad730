// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "numeric/tails.hpp"

namespace opencv_test {
namespace {

//! The beta-binomial distribution is compared with that of Polya's urn. The urn begins with the
//! earlier trials and two imagined trials, one of which is a success. The probability that a trial
//! succeeds is the fraction of successes among all trials before it.
TEST(Usac_Significance, betaBinomialAgainstAnUrn)
{
    const int trials[] = {1, 7, 60, 500}, earlier[] = {0, 9, 300, 4000};
    const double ratios[] = {0, 0.01, 0.3, 1};
    for (int t = 0; t < 4; ++t)
        for (int e = 0; e < 4; ++e)
            for (int r = 0; r < 4; ++r)
            {
                const int c = cvRound(ratios[r] * earlier[e]);
                std::vector<long double> all(1, 1.L);
                for (int i = 0; i < trials[t]; ++i)
                {
                    all.push_back(0);
                    for (int s = i + 1; s >= 0; --s)
                    {
                        const long double fails = (s <= i)
                                                      ? 1 - (c + 1.L + s) / (earlier[e] + 2.L + i)
                                                      : 0;
                        all[s] = all[s] * fails +
                                 (s > 0 ? all[s - 1] * (c + (long double)s) / (earlier[e] + 2.L + i)
                                        : 0);
                    }
                }
                long double tail = 0;
                for (int k = trials[t]; k >= 1; --k)
                {
                    tail += all[k];
                    const double found = betaBinomialTail(k, trials[t], c, earlier[e]);
                    if (tail > 1e-290L)
                    {
                        ASSERT_NEAR(1, (double)(found / tail), 1e-8)
                            << k << " of " << trials[t] << ", " << c << " before";
                    }
                }
                EXPECT_EQ(1, betaBinomialTail(0, trials[t], c, earlier[e]));
                EXPECT_EQ(0, betaBinomialTail(trials[t] + 1, trials[t], c, earlier[e]));
            }
}

}  // namespace
}  // namespace opencv_test
