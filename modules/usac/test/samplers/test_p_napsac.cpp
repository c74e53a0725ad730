// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/draw.hpp"
#include "ordering/ordering.hpp"
#include "support/run_context.hpp"
#include "samplers/samplers.hpp"

namespace opencv_test {
namespace {

//! The fraction of the next samples whose points are all in one cell of the grid's coarsest layer.
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
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        if (sampleSizeOf(problem) == 1)
            continue;
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
            for (int k = 0; k < 2; ++k)
                ++singles[draw.sample[k]];
        }
        EXPECT_LT(std::abs(deviation(singles, 2. * WINDOW)), 4.5) << "problem " << problem;
    }
}

//! The first point of a sample of P-NAPSAC must be the newest point of PROSAC's growing set until
//! this set contains all points, and any of its points afterward. This holds for all samples if
//! `period` (Params::orderedEvery) is 1, otherwise for one in `period` samples after the first
//! eight. The other samples must be uniform and count for the termination criteria.
void expectGrowth(OrderingType ordering, int period)
{
    const int N = 300, first = period > 1 ? 8 : 0;
    Params params;
    params.ordering = ordering;
    params.orderedEvery = period;
    Draw draw(FUNDAMENTAL, N, createPNapsacSampler(), 0, params);
    const std::vector<double> limit = publishedGrowth(N, draw.m);
    // if the order is known, the set grows only with samples that follow it, otherwise (F) with all
    const bool known = ordering == ORDERING_INPUT_ORDER;
    GrowingSet set(draw.m, N);
    int n = draw.m, wrongSize = 0, outside = 0, notNewest = 0, early = 0, grown = 0;
    for (int t = 1; t <= 20000; ++t)
    {
        if (!known || ((t - 1) % period == 0 && t > first))
        {
            ++grown;
            set.next();
        }
        while (n < N && grown > limit[n])
            ++n;
        draw.next();
        ASSERT_TRUE(draw.valid());
        wrongSize += set.size() != n;
        const std::vector<int>::const_iterator end = draw.order.begin() + set.size();
        const bool out = std::find(draw.order.cbegin(), end, draw.sample[0]) == end;
        const bool ordered = (t - 1) % period == 0 && t > first;
        EXPECT_EQ(!ordered || period == 1, draw.state.counts) << t;
        if (!ordered)
        {
            early += out;
            continue;
        }
        if (set.size() < N)
            notNewest += draw.sample[0] != draw.order[set.size() - 1];
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

//! A search for a homography without a known order must begin with eight uniform samples, but with
//! samples that follow the density if it is limited to few samples. The next 16 samples must follow
//! the density: their first point must be the newest of the growing set, and the other points of
//! some of them neighbors outside of this set.
TEST(Usac_Samplers, pNapsacFollowsTheDensityAtOnceIfFewSamplesAreAllowed)
{
    for (int limit : {1, 63, 64, 10000})
    {
        Params params;
        params.maxIterations = limit;
        Draw draw(HOMOGRAPHY, 300, createPNapsacSampler(), 0, params);
        const int uniform = limit < 64 ? 0 : 8;
        GrowingSet set(draw.m, 300);
        int outside = 0;
        for (int i = 0; i < std::min(limit, uniform + 16); ++i)
        {
            SCOPED_TRACE(cv::format("limit %d, sample %d", limit, i));
            draw.next();
            EXPECT_EQ(i < uniform, draw.state.counts);
            set.next();
            if (i < uniform)
                continue;
            ASSERT_TRUE(set.newest());
            EXPECT_EQ(draw.order[set.size() - 1], draw.sample[0]);
            const std::vector<int>::const_iterator end = draw.order.cbegin() + set.size();
            for (int k = 0; k < draw.m; ++k)
                outside += std::find(draw.order.cbegin(), end, draw.sample[k]) == end;
        }
        EXPECT_EQ(limit > 1, outside > 8) << outside;
    }
}

//! A custom ordering by the row numbers, which counts as informative if `known` is true.
class OwnOrdering : public Ordering
{
public:
    explicit OwnOrdering(bool known_) : known(known_) {}
    void sort(const Context& context, int* order) CV_OVERRIDE
    {
        const Ptr<Ordering> rows = createInputOrderOrdering();
        rows->sort(context, order);
    }
    bool informative(const Context&) const CV_OVERRIDE { return known; }

private:
    const bool known;
};

//! Records the samples, and whether they count for the termination criteria.
class Recorder : public Sampler
{
public:
    Recorder() : sampler(createPNapsacSampler()) {}
    void start(const Context& context) CV_OVERRIDE { sampler->start(context); }
    void sample(const Context& context, State& state, int* out) CV_OVERRIDE
    {
        sampler->sample(context, state, out);
        drawn.insert(drawn.end(), out, out + context.components.minimalSolver->sampleSize());
        drawn.push_back(state.counts);
    }

    const Ptr<Sampler> sampler;
    std::vector<int> drawn;
};

std::vector<int> samplesBy(OrderingType ordering, const Ptr<Ordering>& own = Ptr<Ordering>())
{
    SceneOptions options;
    const Scene scene = makeScene(FUNDAMENTAL, options);
    Params params;
    params.ordering = ordering;
    params.maxIterations = 40;
    params.termination = 0;
    const Ptr<Usac> usac = createUsac(scene, params);
    const Ptr<Recorder> recorder = makePtr<Recorder>();
    usac->components().sampler = recorder;
    if (own)
        usac->components().ordering = own;
    usac->run();
    return recorder->drawn;
}

//! Whether an order is informative must depend on the Ordering and not on Params::ordering. With an
//! informative ordering by the rows, the samples must be those of ORDERING_INPUT_ORDER; with the
//! same ordering declared as not informative, they must differ.
TEST(Usac_Samplers, pNapsacAsksTheOrdering)
{
    const std::vector<int> rows = samplesBy(ORDERING_INPUT_ORDER);
    EXPECT_EQ(rows, samplesBy(ORDERING_AUTO, makePtr<OwnOrdering>(true)));
    EXPECT_EQ(rows, samplesBy(ORDERING_DENSITY, makePtr<OwnOrdering>(true)));
    const std::vector<int> guess = samplesBy(ORDERING_AUTO, makePtr<OwnOrdering>(false));
    EXPECT_NE(rows, guess);
    EXPECT_EQ(guess, samplesBy(ORDERING_INPUT_ORDER, makePtr<OwnOrdering>(false)));
    EXPECT_FALSE(createDensityOrdering()->informative(
        RunContext(Correspondences(), Components(), Params())));
}

}
}  // namespace
