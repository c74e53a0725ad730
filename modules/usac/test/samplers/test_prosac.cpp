// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/draw.hpp"
#include "samplers/samplers.hpp"

namespace opencv_test {
namespace {

TEST(Usac_Samplers, prosacGrowsAsPublished)
{
    const int sizes[] = {40, 200, 1000};
    for (int problem : TWO_VIEW_PROBLEMS)
        for (int k = 0; k < 3; ++k)
        {
            const int N = sizes[k];
            Draw draw((ProblemType)problem, N, createProsacSampler());
            const std::vector<double> limit = publishedGrowth(N, draw.m);
            GrowingSet set(draw.m, N);
            int n = draw.m, wrongSize = 0, withoutNewest = 0, outside = 0;
            for (int t = 1; t <= 30000; ++t)
            {
                while (n < N && t > limit[n])
                    ++n;
                set.next();
                draw.next();
                ASSERT_TRUE(draw.valid());
                // where a difference T_{n+1} - T_n is an integer, rounding decides whether the set
                // grows one sample earlier or later
                wrongSize += set.size() != n;
                if (set.size() < N)
                    withoutNewest += !draw.contains(draw.order[set.size() - 1]);
                const std::vector<int>::const_iterator end = draw.order.begin() + set.size();
                for (int i = 0; i < draw.m; ++i)
                    outside += std::find(draw.order.cbegin(), end, draw.sample[i]) == end;
            }
            EXPECT_LE(wrongSize, 30) << "N " << N << " m " << draw.m;
            EXPECT_EQ(0, withoutNewest);
            EXPECT_EQ(0, outside);
        }
}

TEST(Usac_Samplers, prosacEndsUniform)
{
    const int N = 25, SAMPLES = 60000;
    Draw draw(HOMOGRAPHY, N, createProsacSampler());
    GrowingSet set(draw.m, N);
    while (set.size() < N)
    {
        set.next();
        draw.next();
        ASSERT_LT(draw.state.iteration, 210000);
    }
    EXPECT_NEAR(publishedGrowth(N, 4)[N - 1] + 1, draw.state.iteration, N);
    std::vector<int> pairs(N * N, 0), singles(N, 0);
    for (int i = 0; i < SAMPLES; ++i)
    {
        draw.next();
        ++pairs[draw.sample[0] * N + draw.sample[1]];
        ++singles[draw.sample[3]];
    }
    for (int i = N - 1; i >= 0; --i)
        pairs.erase(pairs.begin() + i * N + i);
    EXPECT_LT(std::abs(deviation(pairs, SAMPLES)), 4.5);
    EXPECT_LT(std::abs(deviation(singles, SAMPLES)), 4.5);
}

}
}  // namespace
