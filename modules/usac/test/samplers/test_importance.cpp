// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/draw.hpp"
#include "samplers/samplers.hpp"

namespace opencv_test {
namespace {

Params withScores(const std::vector<float>& scores)
{
    Params params = Draw::ordered();
    params.scores = scores;
    params.scoreOrder = SCORES_HIGHER_IS_BETTER;
    return params;
}

//! Distance of the chi-squared statistic of counts with these expectations from its mean, in
//! standard deviations. Counts with expectation 0 must be 0.
double deviationFrom(const std::vector<int>& counts, const std::vector<double>& expected)
{
    double sum = 0, freedom = -1;
    for (size_t i = 0; i < counts.size(); ++i)
    {
        if (expected[i] == 0)
        {
            EXPECT_EQ(0, counts[i]);
            continue;
        }
        sum += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
        ++freedom;
    }
    return (sum - freedom) / std::sqrt(2 * freedom);
}

//! A sampler with the given scores as weights, and the weights in the internal order of the points.
struct Weighted
{
    Weighted(ProblemType problem, const std::vector<float>& scores, uint64 seed)
        : draw(problem, (int)scores.size(), createImportanceSampler(), seed, withScores(scores)),
          sum(0)
    {
        for (size_t i = 0; i < scores.size(); ++i)
        {
            weights.push_back(scores[draw.context.points.inputIndex[i]]);
            sum += weights.back();
        }
    }

    Draw draw;
    std::vector<double> weights;
    double sum;
};

//! Weights over three orders of magnitude and some weights of 0.
std::vector<float> variedScores(int count)
{
    std::vector<float> scores;
    for (int i = 0; i < count; ++i)
        scores.push_back(i % 7 == 3 ? 0.f : i % 5 == 1 ? 30.f : 0.03f + 0.1f * i);
    return scores;
}

//! The first point of a sample must be drawn with a probability proportional to its weight, the
//! second point in the same way from the remaining points.
TEST(Usac_Importance, distributionByChiSquared)
{
    const int N = 24, SAMPLES = 200000;
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        if (sampleSizeOf(problem) == 1)
            continue;
        Weighted weighted((ProblemType)problem, variedScores(N), problem);
        Draw& draw = weighted.draw;
        std::vector<int> first(N, 0), pairs(N * N, 0), grouped(N, 0);
        for (int i = 0; i < SAMPLES; ++i)
        {
            draw.next();
            ASSERT_TRUE(draw.valid());
            ++first[draw.sample[0]];
            ++pairs[draw.sample[0] * N + draw.sample[1]];
            ++grouped[draw.sample[1]];
        }
        std::vector<double> expected(N), expectedPairs(N * N, 0.), expectedSecond(N, 0.);
        for (int i = 0; i < N; ++i)
            expected[i] = SAMPLES * weighted.weights[i] / weighted.sum;
        for (int i = 0; i < N; ++i)
            for (int j = 0; j < N; ++j)
                if (i != j)
                {
                    expectedPairs[i * N + j] = expected[i] * weighted.weights[j] /
                                               (weighted.sum - weighted.weights[i]);
                    expectedSecond[j] += expectedPairs[i * N + j];
                }
        EXPECT_LT(std::abs(deviationFrom(first, expected)), 4.5);
        EXPECT_LT(std::abs(deviationFrom(grouped, expectedSecond)), 4.5);
        EXPECT_LT(std::abs(deviationFrom(pairs, expectedPairs)), 4.5);
    }
}

//! If at most as many points as a sample needs have positive weights, all of them must be in each
//! sample, and the remaining points of the sample must be uniform.
TEST(Usac_Importance, fewPointsOfPositiveWeight)
{
    const int N = 30, SAMPLES = 20000;
    for (int problem : TWO_VIEW_PROBLEMS)
        for (int positive = 0; positive <= sampleSizeOf(problem); ++positive)
        {
            std::vector<float> scores(N, 0.f);
            for (int i = 0; i < positive; ++i)
                scores[3 * i + 1] = 0.5f + i;
            Weighted weighted((ProblemType)problem, scores, positive);
            std::vector<int> rest(N, 0);
            for (int i = 0; i < SAMPLES; ++i)
            {
                weighted.draw.next();
                ASSERT_TRUE(weighted.draw.valid());
                int inside = 0;
                for (int k = 0; k < weighted.draw.m; ++k)
                    inside += weighted.weights[weighted.draw.sample[k]] > 0;
                ASSERT_EQ(positive, inside);
                ++rest[weighted.draw.sample[weighted.draw.m - 1]];
            }
            if (positive == weighted.draw.m)
                continue;
            for (int i = N - 1; i >= 0; --i)
                if (weighted.weights[i] > 0)
                    rest.erase(rest.begin() + i);
            EXPECT_LT(std::abs(deviation(rest, SAMPLES)), 4.5)
                << "problem " << problem << " positive " << positive;
        }
}

//! If one or two points have nearly all of the weight, samples must still have distinct points, and
//! the other points must have the right probabilities.
TEST(Usac_Importance, overwhelmingWeights)
{
    const int N = 20, SAMPLES = 20000;
    for (int heavy = 1; heavy <= 2; ++heavy)
    {
        std::vector<float> scores(N, 1.f);
        for (int i = 0; i < heavy; ++i)
            scores[5 * i] = i ? 1e30f : 3e38f;
        scores[7] = 1e-30f;
        Weighted weighted(HOMOGRAPHY, scores, heavy);
        std::vector<int> others(N, 0);
        for (int i = 0; i < SAMPLES; ++i)
        {
            weighted.draw.next();
            ASSERT_TRUE(weighted.draw.valid());
            for (int k = 0; k < heavy; ++k)
                ASSERT_GT(weighted.weights[weighted.draw.sample[k]], 1e20);
            ++others[weighted.draw.sample[2]];
        }
        std::vector<double> expected(N);
        for (int i = 0; i < N; ++i)
            expected[i] = weighted.weights[i] > 0.5 && weighted.weights[i] < 2
                              ? SAMPLES / (N - heavy - 1.)
                              : 0;
        EXPECT_LT(std::abs(deviationFrom(others, expected)), 4.5) << heavy;
    }
}

TEST(Usac_Importance, needsScores)
{
    Draw draw(HOMOGRAPHY, 30, createImportanceSampler());
    EXPECT_THROW(draw.next(), cv::Exception);
}

}
}  // namespace
