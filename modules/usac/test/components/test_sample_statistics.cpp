// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "components/sample_statistics.hpp"

namespace opencv_test {
namespace {

//! P(Binomial(n, p) = k) for k = 0 .. n, computed by adding the trials one by one.
std::vector<long double> distribution(int n, double p)
{
    std::vector<long double> all(1, 1.L);
    for (int i = 0; i < n; ++i)
    {
        all.push_back(0);
        for (int k = i + 1; k >= 0; --k)
            all[k] = all[k] * (1 - (long double)p) + (k > 0 ? all[k - 1] * p : 0);
    }
    return all;
}

TEST(Usac_NonRandomness, chanceAgainstTheSum)
{
    const double ratios[] = {1e-12, 1e-5, 0.003, 0.1, 0.5, 0.83, 0.9999};
    const int sizes[] = {5, 9, 30, 400};
    for (int m = 4; m <= 7; ++m)
        for (int s = 0; s < 4; ++s)
            for (int r = 0; r < 7; ++r)
            {
                const int n = std::max(sizes[s], m);
                const std::vector<long double> all = distribution(n - m, ratios[r]);
                long double tail = 0;
                for (int inliers = n; inliers > m; --inliers)
                {
                    tail += all[inliers - m];
                    const double chance = chanceOf(inliers, n, m, ratios[r]);
                    if (tail > 1e-290)
                    {
                        ASSERT_NEAR(1, chance / tail, 1e-11)
                            << inliers << " of " << n << " ratio " << ratios[r];
                    }
                    else
                    {
                        ASSERT_LE(chance, 1e-280);
                    }
                }
            }
}

TEST(Usac_NonRandomness, chanceAtTheLimits)
{
    for (int inliers = 0; inliers <= 4; ++inliers)
        EXPECT_EQ(1, chanceOf(inliers, 100, 4, 0.1)) << "no other inliers than the sample";
    EXPECT_EQ(0, chanceOf(5, 100, 4, 0));
    EXPECT_EQ(1, chanceOf(5, 100, 4, 1));
    EXPECT_EQ(0, chanceOf(101, 100, 4, 0.5));
    EXPECT_EQ(1, chanceOf(4, 4, 4, 0.5));
    EXPECT_EQ(0.25, chanceOf(5, 5, 4, 0.25));
    EXPECT_EQ(0, chanceOf(900000, 1000000, 7, 0.01)) << "below the smallest positive double";
    EXPECT_EQ(1, chanceOf(8, 1000000, 7, 0.9));
}

//! For a million points, the tail probability is compared with the sum of the single probabilities,
//! which are computed from log-factorials in long double.
TEST(Usac_NonRandomness, chanceOfAMillionPoints)
{
    const int n = 1000000, m = 4;
    const double ratios[] = {1e-6, 2e-3, 0.3};
    for (int r = 0; r < 3; ++r)
    {
        const long double N = n - m, p = ratios[r], mean = N * p,
                          deviation = std::sqrt(mean * (1 - p));
        for (int step = -3; step <= 8; ++step)
        {
            const int first = std::max(1, (int)(mean + step * deviation));
            long double sum = 0;
            for (int k = first; k < first + 20 * deviation + 60 && k <= N; ++k)
                sum += std::exp(std::lgamma(N + 1) - std::lgamma((long double)k + 1) -
                                std::lgamma(N - k + 1) + k * std::log(p) +
                                (N - k) * std::log1p(-p));
            EXPECT_NEAR(1, chanceOf(first + m, n, m, ratios[r]) / sum, 1e-8)
                << ratios[r] << " " << step;
        }
    }
}

}  // namespace
}  // namespace opencv_test
