// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/draw.hpp"
#include "samplers/samplers.hpp"

namespace opencv_test {
namespace {

TEST(Usac_Samplers, uniformByChiSquared)
{
    const int N = 30, SAMPLES = 60000;
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        if (sampleSizeOf(problem) == 1)
            continue;
        Draw draw((ProblemType)problem, N, createUniformSampler(), problem);
        std::vector<std::vector<int>> places(draw.m, std::vector<int>(N, 0));
        std::vector<int> firstPair(N * N, 0), lastPair(N * N, 0);
        for (int i = 0; i < SAMPLES; ++i)
        {
            draw.next();
            ASSERT_TRUE(draw.valid());
            for (int k = 0; k < draw.m; ++k)
                ++places[k][draw.sample[k]];
            ++firstPair[draw.sample[0] * N + draw.sample[1]];
            ++lastPair[draw.sample[draw.m - 1] * N + draw.sample[0]];
        }
        for (int k = 0; k < draw.m; ++k)
            EXPECT_LT(std::abs(deviation(places[k], SAMPLES)), 4.5) << "place " << k;
        for (int i = N - 1; i >= 0; --i)  // pairs of equal points do not occur
        {
            EXPECT_EQ(0, firstPair[i * N + i]);
            firstPair.erase(firstPair.begin() + i * N + i);
            lastPair.erase(lastPair.begin() + i * N + i);
        }
        EXPECT_LT(std::abs(deviation(firstPair, SAMPLES)), 4.5);
        EXPECT_LT(std::abs(deviation(lastPair, SAMPLES)), 4.5);
    }
}

}
}  // namespace
