// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "local_optimization/runners_up.hpp"

// The best models of samples that were never the best of all: what is kept, and what becomes of them.

namespace opencv_test {
namespace {

Candidate candidateOf(double cost)
{
    Sample sample = Sample::all(0);
    sample[0] = (int)cost;
    return Candidate(sample, Matx33d::eye(), Quality(cost, 10));
}

std::vector<double> costsOf(const std::vector<Candidate>& candidates)
{
    std::vector<double> costs;
    for (size_t i = 0; i < candidates.size(); ++i)
    {
        EXPECT_EQ((int)candidates[i].quality.cost, candidates[i].sample[0]) << "another's sample";
        costs.push_back(candidates[i].quality.cost);
    }
    return costs;
}

std::vector<Candidate> taken(RunnersUp& kept)
{
    const Candidate* candidates;
    const int count = kept.take(candidates);
    return std::vector<Candidate>(candidates, candidates + count);
}

TEST(Usac_RunnersUp, keepsTheBestOfAnyOrder)
{
    RNG rng(5);
    for (int most = 1; most <= 12; most += 5)
    {
        std::vector<double> costs;
        Arena arena;
        RunnersUp kept(most, arena);
        for (int i = 0; i < 100; ++i)
        {
            costs.push_back(rng.uniform(0, 60));  // also equal ones
            kept.add(candidateOf(costs.back()));
        }
        std::sort(costs.begin(), costs.end());
        costs.resize(most);
        EXPECT_EQ(costs.back(), kept.uselessCost(0));
        EXPECT_EQ(costs, costsOf(taken(kept)));
    }
}

TEST(Usac_RunnersUp, givesEachOnce)
{
    Arena arena;
    RunnersUp kept(2, arena);
    EXPECT_TRUE(taken(kept).empty());
    EXPECT_GT(kept.uselessCost(3), 1e300) << "all are welcome as long as there is room";
    const double first[] = {5, 3, 4};
    for (int i = 0; i < 3; ++i)
        kept.add(candidateOf(first[i]));
    EXPECT_EQ(2u, taken(kept).size());
    EXPECT_TRUE(taken(kept).empty());
    kept.add(candidateOf(9));  // two better ones have been given
    EXPECT_TRUE(taken(kept).empty());
    kept.add(candidateOf(2));
    EXPECT_EQ(std::vector<double>(1, 2.), costsOf(taken(kept)));
}

TEST(Usac_RunnersUp, noneAreKeptIfNoneAreAskedFor)
{
    Arena arena;
    RunnersUp kept(0, arena);
    kept.add(candidateOf(1));
    EXPECT_TRUE(taken(kept).empty());
    EXPECT_EQ(7, kept.uselessCost(7)) << "only what beats the best one is of use";
}

//! Counts the optimizations and improves nothing.
class IdleOptimizer : public LocalOptimizer
{
public:
    explicit IdleOptimizer(int* calls_) : calls(calls_) {}
    bool optimize(const Context&, State&, Model&, Quality&) CV_OVERRIDE
    {
        ++*calls;
        return false;
    }

private:
    int* calls;
};

Scene noisyScene(ProblemType problem, double inlierRatio, uint64 seed)
{
    SceneOptions options;
    options.setSize(200, inlierRatio);
    options.noise = 1;
    options.seed = seed;
    return makeScene(problem, options);
}

typedef testing::TestWithParam<int> Usac_RunnersUpOf;

TEST_P(Usac_RunnersUpOf, areOptimizedBesideTheBestModels)
{
    int calls[3] = {0, 0, 0}, most[] = {0, 3, 20};
    for (int i = 0; i < 3; ++i)
        for (uint64 seed = 1; seed <= 10; ++seed)
        {
            Params params;
            params.runnersUp = most[i];
            params.termination = 0;
            params.maxIterations = 500;
            const Ptr<Usac> usac = createUsac(noisyScene((ProblemType)GetParam(), 0.5, seed), params);
            usac->components().localOptimizer = makePtr<IdleOptimizer>(calls + i);
            EXPECT_FALSE(usac->run().empty());
        }
    EXPECT_GT(calls[0], 0);
    EXPECT_GT(calls[1], calls[0]);
    EXPECT_LE(calls[1], calls[0] + 10 * 3);
    EXPECT_GT(calls[2], calls[1]);
    EXPECT_LE(calls[2], calls[0] + 10 * 20);
}

//! The same search, and a choice of more models: the cost is never higher, and on hard scenes often lower.
TEST_P(Usac_RunnersUpOf, neverRaiseTheCost)
{
    int lower = 0;
    for (uint64 seed = 1; seed <= 20; ++seed)
    {
        const Scene scene = noisyScene((ProblemType)GetParam(), 0.3, seed);
        Report with, without;
        Params params;
        params.termination = 0;
        params.maxIterations = 500;
        params.polishing = POLISHING_NONE;
        estimate(scene, params, noArray(), &with);
        params.runnersUp = 0;
        estimate(scene, params, noArray(), &without);
        EXPECT_LE(with.cost, without.cost * (1 + 1e-6)) << "seed " << seed;
        lower += with.cost < without.cost * (1 - 1e-3);
    }
    EXPECT_GE(lower, 1);
}

//! They are looked at when the search is about to end, never before, and the criteria are asked again.
TEST_P(Usac_RunnersUpOf, doNotEndTheSearchEarlier)
{
    for (uint64 seed = 1; seed <= 40; ++seed)
    {
        const Scene scene = noisyScene((ProblemType)GetParam(), 0.5, seed);
        Report with, without;
        Params params;
        params.maxIterations = 100000;
        estimate(scene, params, noArray(), &with);
        params.runnersUp = 0;
        estimate(scene, params, noArray(), &without);
        EXPECT_NE((int)STOP_MAX_ITERATIONS, with.stop);
        EXPECT_GE(with.iterations, without.iterations);
        EXPECT_LE(with.iterations, 2 * without.iterations) << "a better model does not ask for many more samples";
    }
}

INSTANTIATE_TEST_CASE_P(/**/, Usac_RunnersUpOf, testing::Values((int)HOMOGRAPHY, (int)FUNDAMENTAL, (int)ESSENTIAL));

/* Nearly all points on a plane: a plane has two motions, and most points agree with both. The one with the lower cost
 * is right. */
TEST(Usac_RunnersUp, tellTheTwoMotionsOfAPlane)
{
    int wrong[2] = {0, 0};
    for (int with = 0; with < 2; ++with)
        for (uint64 seed = 1; seed <= 40; ++seed)
        {
            SceneOptions options;
            options.setSize(400, 0.8);
            options.planeFraction = 0.9;
            options.seed = seed;
            const Scene scene = makeScene(ESSENTIAL, options);
            Params params;
            params.runnersUp = with ? Params().runnersUp : 0;
            wrong[with] += modelError(scene, estimate(scene, params), OFF_PLANE) > 5;
        }
    EXPECT_LE(wrong[1], wrong[0]);
    EXPECT_EQ(0, wrong[1]);
}

}
}  // namespace
