// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "local_optimization/runners_up.hpp"

// Tests of RunnersUp, which keeps good models that were never the best model. When the search is
// about to end, these models are optimized, too.

namespace opencv_test {
namespace {

Candidate candidateOf(double cost)
{
    Sample sample = Sample::all(0);
    sample[0] = (int)cost;
    return Candidate(sample, Matx33d::eye(), Quality(cost, 10));
}

//! Points in rows; row r is shifted by 10 r pixels in image 2. The inliers of a translation by 10 r
//! pixels are the points of row r.
struct Rows
{
    Rows() : rows(20), each(10)
    {
        for (int i = 0; i < rows * each; ++i)
        {
            from.push_back(Point2d(20. * (i % each), 20. * (i / each)));
            to.push_back(from.back() + Point2d(10. * (i / each), 0));
        }
        usac = Usac::create(HOMOGRAPHY, from, to, Params());
    }

    InlierBits bitsOf(int row) const
    {
        const Params params;
        const Context context(usac->points(), usac->components(), params, arena);
        return InlierBits(context,
                          toInternal(usac->points(), Matx33d(1, 0, 10. * row, 0, 1, 0, 0, 0, 1)));
    }

    const int rows, each;
    std::vector<Point2d> from, to;
    Ptr<Usac> usac;
    mutable Arena arena;
};

std::vector<double> costsOf(RunnersUp& kept)
{
    const RunnerUp* taken;
    const int count = kept.take(taken);
    std::vector<double> costs;
    for (int i = 0; i < count; ++i)
    {
        EXPECT_EQ((int)taken[i].candidate.quality.cost, taken[i].candidate.sample[0])
            << "the sample of another candidate";
        costs.push_back(taken[i].candidate.quality.cost);
    }
    return costs;
}

//! Among models with equally many inliers that the best model does not have, those with the lowest
//! cost must be kept.
TEST(Usac_RunnersUp, keepsTheBestOfAnyOrder)
{
    const Rows scene;
    RNG rng(5);
    for (int most = 1; most <= 12; most += 5)
    {
        std::vector<double> costs;
        Arena arena;
        RunnersUp kept(most, arena);
        for (int i = 0; i < 100; ++i)
        {
            costs.push_back(rng.uniform(0, 60));  // some costs are equal
            kept.add(candidateOf(costs.back()), scene.bitsOf(i % scene.rows));
        }
        std::sort(costs.begin(), costs.end());
        costs.resize(most);
        EXPECT_EQ(costs, costsOf(kept));
    }
}

//! A model whose inliers are outliers of the best model must be kept, even if many models of lower
//! cost have the inliers of the best model.
TEST(Usac_RunnersUp, keepsWhatIsDifferent)
{
    const Rows scene;
    Arena arena;
    RunnersUp kept(3, arena);
    kept.setBest(scene.bitsOf(2));
    kept.add(candidateOf(50), scene.bitsOf(7));
    for (int i = 0; i < 20; ++i)
        kept.add(candidateOf(i), scene.bitsOf(2));
    EXPECT_EQ(scene.each, kept.mostUnexplained());
    const double expected[] = {50, 0, 1};
    EXPECT_EQ(std::vector<double>(expected, expected + 3), costsOf(kept));
}

//! When the best model changes, runners-up must be ranked by the number of inliers that the new
//! best model does not have.
TEST(Usac_RunnersUp, followTheBestModel)
{
    const Rows scene;
    Arena arena;
    RunnersUp kept(3, arena);
    for (int row = 0; row < 3; ++row)
        kept.add(candidateOf(row), scene.bitsOf(row));
    kept.setBest(scene.bitsOf(0));
    EXPECT_EQ(scene.each, kept.mostUnexplained());
    kept.add(candidateOf(9),
             // replaces the model of row 0, all of whose inliers are inliers of the best model
             scene.bitsOf(3));
    const double expected[] = {1, 2, 9};
    EXPECT_EQ(std::vector<double>(expected, expected + 3), costsOf(kept));
    kept.clear();
    EXPECT_EQ(0, kept.mostUnexplained());
}

//! Counts the optimizations and improves no model.
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
            const Ptr<Usac> usac = createUsac(noisyScene((ProblemType)GetParam(), 0.5, seed),
                                              params);
            usac->components().localOptimizer = makePtr<IdleOptimizer>(calls + i);
            EXPECT_FALSE(usac->run().empty());
        }
    EXPECT_GT(calls[0], 0);
    EXPECT_GT(calls[1], calls[0]);
    EXPECT_LE(calls[1], calls[0] + 10 * 3);
    EXPECT_GT(calls[2], calls[1]);
    EXPECT_LE(calls[2], calls[0] + 10 * 20);
}

//! Runners-up leave the regular samples of the search unchanged, but more models are compared. The
//! cost must therefore never be higher than without runners-up, and must be lower in at least one
//! of these hard scenes.
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

//! Runners-up are optimized when the search is about to end, and then the termination criteria are
//! evaluated again. The search must therefore never be shorter than without runners-up.
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
        EXPECT_LE(with.iterations, 2 * without.iterations)
            << "more than twice as many samples as without runners-up";
    }
}

INSTANTIATE_TEST_CASE_P(/**/, Usac_RunnersUpOf,
                        testing::Values((int)HOMOGRAPHY, (int)FUNDAMENTAL, (int)ESSENTIAL));

/* 90 % of the true matches are on a plane, and two motions agree with these matches. With
runners-up, the correct motion, which has the lower cost, must be found in every scene. */
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

}  // namespace
}  // namespace opencv_test
