// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "scoring/order_likelihood.hpp"

// Tests of orderLogLikelihood(), which measures how well the order of the points explains which of
// them are inliers.

namespace opencv_test {
namespace {

double likelihood(const std::vector<uchar>& inliers)
{
    std::vector<int> blocks(2 * inliers.size() + 1);
    return orderLogLikelihood(inliers.data(), (int)inliers.size(), blocks.data());
}

double logLikelihood(int ones, int count)
{
    const double p = (double)ones / count;
    return ones == 0 || ones == count ? 0 : ones * std::log(p) + (count - ones) * std::log(1 - p);
}

//! The largest log-likelihood over all divisions of the order into parts whose inlier probabilities
//! do not increase, minus that of the undivided order. The bits of `cuts` say where parts end.
double byTrial(const std::vector<uchar>& inliers)
{
    const int size = (int)inliers.size();
    double best = -DBL_MAX;
    for (int cuts = 0; cuts < 1 << (size - 1); ++cuts)
    {
        double sum = 0, last = 1;
        bool valid = true;
        for (int i = 0, ones = 0, count = 0; i < size && valid; ++i)
        {
            ones += inliers[i];
            ++count;
            if (i + 1 < size && !(cuts >> i & 1))
                continue;
            valid = (double)ones / count <= last;
            last = (double)ones / count;
            sum += logLikelihood(ones, count);
            ones = count = 0;
        }
        if (valid)
            best = std::max(best, sum);
    }
    return best - logLikelihood((int)std::count(inliers.begin(), inliers.end(), 1), size);
}

TEST(Usac_OrderLikelihood, is_the_largest_of_all)
{
    RNG rng(1);
    for (int trial = 0; trial < 200; ++trial)
    {
        std::vector<uchar> inliers(rng.uniform(1, 12));
        for (uchar& inlier : inliers)
            inlier = (uchar)rng.uniform(0, 2);
        EXPECT_NEAR(byTrial(inliers), likelihood(inliers), 1e-9) << trial;
    }
}

//! Points of equal rank form a group, whose last point is marked in `ends`. A group must not be
//! divided into parts of different inlier probabilities, and the order within it must not matter.
TEST(Usac_OrderLikelihood, groups)
{
    RNG rng(2);
    for (int trial = 0; trial < 200; ++trial)
    {
        const int size = rng.uniform(1, 12);
        std::vector<uchar> inliers(size), ends(size), none(size, 0), all(size, 1);
        for (int i = 0; i < size; ++i)
        {
            inliers[i] = (uchar)rng.uniform(0, 2);
            ends[i] = (uchar)rng.uniform(0, 2);
        }
        std::vector<int> blocks(2 * size);
        const auto of = [&](const std::vector<uchar>& flags, const std::vector<uchar>& groups) {
            return orderLogLikelihood(flags.data(), size, blocks.data(), groups.data());
        };
        EXPECT_EQ(likelihood(inliers), of(inliers, all));
        EXPECT_EQ(0, of(inliers, none));
        std::vector<uchar> sorted = inliers;  // within each group, the inliers come last
        for (int begin = 0, i = 0; i < size; ++i)
            if (ends[i] || i + 1 == size)
            {
                std::sort(sorted.begin() + begin, sorted.begin() + i + 1);
                begin = i + 1;
            }
        EXPECT_EQ(of(inliers, ends), of(sorted, ends));
        // even without `ends`, a group whose inliers come last is not divided
        EXPECT_NEAR(likelihood(sorted), of(sorted, ends), 1e-9);
    }
}

TEST(Usac_OrderLikelihood, no_points_and_points_of_one_kind)
{
    EXPECT_EQ(0, likelihood(std::vector<uchar>()));
    EXPECT_EQ(0, likelihood(std::vector<uchar>(9, 0)));
    EXPECT_EQ(0, likelihood(std::vector<uchar>(9, 1)));
}

}  // namespace
}  // namespace opencv_test
