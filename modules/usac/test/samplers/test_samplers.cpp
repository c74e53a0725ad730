// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "draw.hpp"
#include "samplers/samplers.hpp"

namespace opencv_test {
namespace {

TEST(Usac_Samplers, uniformByChiSquared)
{
    const int N = 30, SAMPLES = 60000;
    for (int problem = 0; problem < 3; ++problem)
    {
        Draw draw((ProblemType)problem, N, createUniformSampler(), problem);
        std::vector<std::vector<int>> places(draw.m, std::vector<int>(N, 0));
        std::vector<int> firstPair(N * N, 0), lastPair(N * N, 0);
        for (int i = 0; i < SAMPLES; ++i)
        {
            draw.next();
            ASSERT_TRUE(draw.valid());
            ASSERT_EQ(N, draw.sampler->subsetSize(draw.context));
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

TEST(Usac_Samplers, seedsDiffer)
{
    Draw a(HOMOGRAPHY, 50, createUniformSampler(), 1), b(HOMOGRAPHY, 50, createUniformSampler(), 2),
        c(HOMOGRAPHY, 50, createUniformSampler(), 1);
    int same = 0;
    for (int i = 0; i < 1000; ++i)
    {
        a.next();
        b.next();
        c.next();
        same += std::equal(a.sample, a.sample + 4, b.sample);
        EXPECT_TRUE(std::equal(a.sample, a.sample + 4, c.sample));
    }
    EXPECT_LE(same, 2);
}

//! T'_n of the published algorithm for n = 0 .. N, from the product that defines T_n; T_N: no more samples than there
//! are.
std::vector<double> publishedGrowth(int N, int m)
{
    long double subsets = 1;
    for (int i = 0; i < m; ++i)
        subsets = subsets * (N - i) / (i + 1);
    const long double T_N = std::min(subsets, (long double)200000);
    std::vector<double> limit(N + 1, 0.);
    limit[m] = 1;
    for (int n = m; n < N; ++n)
    {
        long double low = T_N, high = T_N;
        for (int i = 0; i < m; ++i)
        {
            low *= (long double)(n - i) / (N - i);
            high *= (long double)(n + 1 - i) / (N - i);
        }
        limit[n + 1] = limit[n] + (double)std::ceil((high - low) * (1 - 1e-12L));
    }
    return limit;
}

TEST(Usac_Samplers, prosacGrowsAsPublished)
{
    const int sizes[] = {40, 200, 1000};
    for (int problem = 0; problem < 3; ++problem)
        for (int k = 0; k < 3; ++k)
        {
            const int N = sizes[k];
            Draw draw((ProblemType)problem, N, createProsacSampler());
            const std::vector<double> limit = publishedGrowth(N, draw.m);
            int n = draw.m, wrongSize = 0, withoutNewest = 0, outside = 0;
            for (int t = 1; t <= 30000; ++t)
            {
                while (n < N && t > limit[n])
                    ++n;
                draw.next();
                ASSERT_TRUE(draw.valid());
                // where a difference T_{n+1} - T_n is an integer, rounding may decide: one size more or less for a
                // while
                wrongSize += draw.sampler->subsetSize(draw.context) != n;
                if (draw.sampler->subsetSize(draw.context) < N)
                    withoutNewest += !draw.contains(draw.state.order[draw.sampler->subsetSize(draw.context) - 1]);
                for (int i = 0; i < draw.m; ++i)
                    outside += std::find(draw.state.order.begin(),
                                         draw.state.order.begin() + draw.sampler->subsetSize(draw.context),
                                         draw.sample[i]) ==
                               draw.state.order.begin() + draw.sampler->subsetSize(draw.context);
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
    while (draw.sampler->subsetSize(draw.context) < N)
    {
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

//! Of the next samples, the fraction whose points all share a cell of the coarsest layer.
double localFraction(Draw& draw, int samples)
{
    Neighborhood& grid = *draw.usac->components().neighborhood;
    int together = 0;
    for (int i = 0; i < samples; ++i)
    {
        draw.next();
        EXPECT_TRUE(draw.valid());
        const int* members = 0;
        const int count = grid.members(draw.context, grid.layers() - 1, draw.sample[0], members);
        bool all = true;
        for (int k = 1; k < draw.m; ++k)
            all = all && std::find(members, members + count, draw.sample[k]) != members + count;
        together += all;
    }
    return together / (double)samples;
}

TEST(Usac_Samplers, pNapsacStartsLocalAndEndsGlobal)
{
    const int N = 1000, WINDOW = 20000;
    for (int problem = 0; problem < 3; ++problem)
    {
        Draw draw((ProblemType)problem, N, createPNapsacSampler());
        Draw prosac((ProblemType)problem, N, createProsacSampler());
        Draw uniform((ProblemType)problem, N, createUniformSampler());
        const double early = localFraction(draw, 200), global = localFraction(uniform, WINDOW);
        EXPECT_GT(early, localFraction(prosac, 200) + 0.1) << "problem " << problem;
        EXPECT_GT(early, global + 0.1) << "problem " << problem;
        while (draw.state.iteration < 260000)
            draw.next();
        EXPECT_NEAR(global, localFraction(draw, WINDOW), 0.01) << "problem " << problem;
        std::vector<int> singles(N, 0);
        for (int i = 0; i < WINDOW; ++i)
        {
            draw.next();
            ASSERT_EQ(N, draw.sampler->subsetSize(draw.context));
            for (int k = 0; k < 2; ++k)
                ++singles[draw.sample[k]];
        }
        EXPECT_LT(std::abs(deviation(singles, 2. * WINDOW)), 4.5) << "problem " << problem;
    }
}

//! The first point of P-NAPSAC's samples is PROSAC's: of the growing set, and the newest point as long as it is new.
//! This holds for one sample in Params::orderedEvery, but none of the first eight if the order is a guess; the others
//! are uniform, and they count.
void expectGrowth(int ordering, int period)
{
    const int N = 300, first = ordering == ORDERING_DENSITY ? 8 : 0;
    Draw draw(FUNDAMENTAL, N, createPNapsacSampler());
    draw.params.ordering = ordering;
    draw.params.orderedEvery = period;
    const std::vector<double> limit = publishedGrowth(N, draw.m);
    int n = draw.m, wrongSize = 0, outside = 0, notNewest = 0, early = 0;
    for (int t = 1; t <= 20000; ++t)
    {
        while (n < N && t > limit[n])
            ++n;
        draw.next();
        ASSERT_TRUE(draw.valid());
        wrongSize += draw.sampler->subsetSize(draw.context) != n;
        const std::vector<int>::const_iterator end = draw.state.order.begin() + draw.sampler->subsetSize(draw.context);
        const bool out = std::find(draw.state.order.cbegin(), end, draw.sample[0]) == end;
        const bool ordered = (t - 1) % period == 0 && (t > first || period == 1);
        EXPECT_EQ(!ordered || period == 1, draw.state.counts) << t;
        if (!ordered)
        {
            early += out;
            continue;
        }
        if (draw.sampler->subsetSize(draw.context) < N)
            notNewest += draw.sample[0] != draw.state.order[draw.sampler->subsetSize(draw.context) - 1];
        outside += out;
    }
    EXPECT_LE(wrongSize, 30);
    EXPECT_EQ(0, notNewest);
    EXPECT_EQ(0, outside);
    EXPECT_EQ(period > 1, early > 1000) << early;
}

TEST(Usac_Samplers, pNapsacCentersGrowLikeProsac)
{
    expectGrowth(ORDERING_INPUT_ORDER, 1);
    expectGrowth(ORDERING_INPUT_ORDER, 3);
    expectGrowth(ORDERING_DENSITY, 4);
}

TEST(Usac_Samplers, asManyPointsAsASampleNeeds)
{
    for (int problem = 0; problem < 3; ++problem)
        for (int kind = 0; kind < 3; ++kind)
            for (int more = 0; more < 3; ++more)
            {
                const int N = (problem == 0 ? 4 : problem == 1 ? 7 : 5) + more;
                Draw draw((ProblemType)problem, N,
                          kind == 0   ? createUniformSampler()
                          : kind == 1 ? createProsacSampler()
                                      : createPNapsacSampler());
                for (int i = 0; i < 300; ++i)
                {
                    draw.next();
                    ASSERT_TRUE(draw.valid()) << problem << " " << kind << " " << more;
                    ASSERT_LE(draw.sampler->subsetSize(draw.context), N);
                    ASSERT_GE(draw.sampler->subsetSize(draw.context), draw.m);
                }
            }
}

//! Counts the calls.
class CountingOrdering : public Ordering
{
public:
    CountingOrdering() : calls(0) {}
    void sort(const Context&, std::vector<int>&) CV_OVERRIDE { ++calls; }
    int calls;
};

int sortings(ProblemType problem, int ordering, int outliers)
{
    SceneOptions options;
    options.outliers = outliers;
    const Scene scene = makeScene(problem, options);
    Params params;
    params.ordering = ordering;
    const Ptr<Usac> usac = createUsac(scene, params);
    const Ptr<CountingOrdering> counting = makePtr<CountingOrdering>();
    usac->components().ordering = counting;
    EXPECT_FALSE(usac->run().empty());
    return counting->calls;
}

//! Where the order is a guess, easy problems end before it is needed; one that is known serves from the first sample.
TEST(Usac_Samplers, pointsAreSortedOnceAndOnlyIfNeeded)
{
    for (int problem = FUNDAMENTAL; problem <= ESSENTIAL; ++problem)
    {
        EXPECT_EQ(0, sortings((ProblemType)problem, ORDERING_DENSITY, 0)) << problem;
        EXPECT_EQ(1, sortings((ProblemType)problem, ORDERING_DENSITY, 150)) << problem;
        EXPECT_EQ(1, sortings((ProblemType)problem, ORDERING_INPUT_ORDER, 0)) << problem;
    }
}

}
}  // namespace
