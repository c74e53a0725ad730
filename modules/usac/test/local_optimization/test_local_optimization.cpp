// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/run_context.hpp"
#include "test_precomp.hpp"
#include "local_optimization/local_optimization.hpp"
#include "neighborhood/neighborhood.hpp"

#include <tuple>

namespace opencv_test {
namespace {

//! The test parameters are a problem and a local optimization.
typedef testing::TestWithParam<std::tuple<int, int>> Usac_LocalOptimization;

TEST_P(Usac_LocalOptimization, neverWorsensTheScore)
{
    const ProblemType problem = (ProblemType)std::get<0>(GetParam());
    int improved = 0, tried = 0;
    for (int quality = 0; quality < 2; ++quality)
        for (uint64 seed = 1; seed <= 4; ++seed)
        {
            SceneOptions options;
            options.seed = seed;
            const Scene scene = makeScene(problem, options);
            Params params;
            params.quality = (QualityType)quality;
            params.localOptimization = (LocalOptimizationType)std::get<1>(GetParam());
            const Ptr<Usac> usac = createUsac(scene, params);
            Arena arena;
            const Context context(usac->points(), usac->components(), params, arena);
            usac->components().start(context);
            const Ptr<LocalOptimizer> optimizer = usac->components().localOptimizer;
            State state;
            for (int i = 0; i < 50; ++i)
            {
                int sample[MAX_SAMPLE_SIZE];
                Model models[MAX_MODELS];
                Rng(seed, i).distinct(scene.size(), usac->components().minimalSolver->sampleSize(),
                                      sample);
                const int count = usac->components().minimalSolver->solve(usac->points(), sample,
                                                                          models);
                for (int k = 0; k < count; ++k, ++tried)
                {
                    const Quality before = context.rate(models[k]);
                    Model model = models[k];
                    Quality after = before;
                    const bool better = optimizer->optimize(context, state, model, after);
                    improved += better;
                    EXPECT_EQ(better, after.betterThan(before));
                    EXPECT_EQ(better, model != models[k]);
                    const Quality again = context.rate(model);
                    EXPECT_EQ(again.cost, after.cost);
                    EXPECT_EQ(again.inliers, after.inliers);
                }
            }
        }
    EXPECT_GT(improved, tried / 10);
}

//! Noise is added to the entries of the true model. In at least 8 of 10 scenes (GC-RANSAC: 1 of
//! 10), local optimization must lead back to a model that is about as good as the true one.
TEST_P(Usac_LocalOptimization, improvesRoughModels)
{
    const ProblemType problem = (ProblemType)std::get<0>(GetParam());
    int good = 0;
    const int SCENES = 30;
    for (uint64 seed = 1; seed <= SCENES; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        const Scene scene = makeScene(problem, options);
        Params params;
        params.localOptimization = (LocalOptimizationType)std::get<1>(GetParam());
        if (params.localOptimization != LOCAL_OPTIMIZATION_GRAPH_CUT)
            params.localSamples = 4;
        if (params.localOptimization >= LOCAL_OPTIMIZATION_SIGMA_CONSENSUS &&
            params.localOptimization <=
                // these methods use the threshold as an upper bound of the noise
                LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS)
        {
            params.threshold = 4;
            params.quality = QUALITY_MAGSAC_PLUS_PLUS;
        }
        const Ptr<Usac> usac = createUsac(scene, params);
        Arena arena;
        const Context context(usac->points(), usac->components(), params, arena);
        usac->components().start(context);
        const Quality truth = context.rate(toInternal(usac->points(), scene.model));
        RNG rng(seed);
        Model model = toInternal(usac->points(), scene.model);
        for (int i = 0; i < 9; ++i)
            model.val[i] += rng.gaussian(problem == HOMOGRAPHY ? 2e-3 : 5e-4);
        State state;
        Quality quality = context.rate(model);
        usac->components().localOptimizer->optimize(context, state, model, quality);
        good += quality.cost < truth.cost * 1.02;
    }
    // GC-RANSAC fits models only to inliers, not to all points within three times the threshold,
    // and therefore often ends in a worse local minimum.
    EXPECT_GE(good,
              SCENES * (std::get<1>(GetParam()) == LOCAL_OPTIMIZATION_GC_RANSAC ? 1 : 8) / 10);
}

INSTANTIATE_TEST_CASE_P(All, Usac_LocalOptimization,
                        testing::Combine(testing::Range(0, 3),
                                         testing::Range((int)LOCAL_OPTIMIZATION_GRAPH_CUT,
                                                        LOCAL_OPTIMIZATION_GC_RANSAC + 1)));

//! A solver for which every `period`-th fit fails, or (if `silent`) returns a wrong model as if it
//! were correct.
class UnreliableSolver : public NonMinimalSolver
{
public:
    UnreliableSolver(const Ptr<NonMinimalSolver>& solver_, int period_, bool silent_)
        : fits(0), solver(solver_), period(period_), silent(silent_)
    {}

    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int iterations) const CV_OVERRIDE
    {
        if (++fits % period > 0)
            return solver->fit(points, indices, count, weights, model, iterations);
        if (silent)
            model = Matx33d(1, 0, 1e3, 0, 1, -1e3, 0, 0, 1) * (1 / std::sqrt(2e6 + 3));
        return silent;
    }

    mutable int fits;

private:
    const Ptr<NonMinimalSolver> solver;
    const int period;
    const bool silent;
};

Mat withUnreliableFits(const Scene& scene, const Params& params, int period, bool silent, int& fits)
{
    const Ptr<Usac> usac = createUsac(scene, params);
    const Ptr<UnreliableSolver> solver = makePtr<UnreliableSolver>(
        usac->components().nonMinimalSolver, period, silent);
    usac->components().nonMinimalSolver = solver;
    const Mat model = usac->run();
    fits = solver->fits;
    return model;
}

//! If all fits fail or return a wrong model, the result must be the same as without local
//! optimization. If only every third fit fails or returns a wrong model, the error must not be
//! larger than without local optimization.
TEST(Usac_LocalOptimizers, fitsThatFail)
{
    for (int problem = 0; problem < 3; ++problem)
        for (int type = LOCAL_OPTIMIZATION_GRAPH_CUT; type <= LOCAL_OPTIMIZATION_GC_RANSAC; ++type)
        {
            SCOPED_TRACE(cv::format("problem %d, local optimization %d", problem, type));
            SceneOptions options;
            options.outliers = problem == ESSENTIAL ? 100 : 60;
            const Scene scene = makeScene((ProblemType)problem, options);
            Params params;
            params.maxIterations = 100;
            params.degeneracy = 0;
            params.termination = 0;
            params.polishing = POLISHING_NONE;
            params.localIterations = type % 2 ? 1 : 4;
            params.localOptimization = LOCAL_OPTIMIZATION_NONE;
            const Mat plain = estimate(scene, params);
            params.localOptimization = (LocalOptimizationType)type;
            for (int silent = 0; silent < 2; ++silent)
            {
                int fits = 0;
                const Mat same = withUnreliableFits(scene, params, 1, silent != 0, fits);
                EXPECT_GT(fits, 0);
                EXPECT_EQ(0, cvtest::norm(plain, same, NORM_INF));
                EXPECT_LE(
                    modelError(scene, withUnreliableFits(scene, params, 3, silent != 0, fits)),
                    modelError(scene, plain));
                EXPECT_GT(fits, 2);
            }
        }
}

//! Number of fits in a graph-cut optimization of a model. @param best quality of the best model
int fitsOf(const Context& context, const UnreliableSolver& solver, const Model& given,
           const Quality& best)
{
    Model model = given;
    Quality quality = context.rate(model);
    State state;
    state.bestQuality = best;
    const int before = solver.fits;
    context.components.localOptimizer->optimize(context, state, model, quality);
    return solver.fits - before;
}

//! Models of samples with outliers are far from the best model, even after one fit. Their
//! optimization must end early, but not if there is no best model yet. That of a model near the
//! true one must not end early.
TEST(Usac_LocalOptimizers, graphCutEndsForModelsFarFromTheBest)
{
    SceneOptions options;
    options.outliers = 60;
    const Scene scene = makeScene(HOMOGRAPHY, options);
    Params params;
    const Ptr<Usac> usac = createUsac(scene, params);
    const Correspondences& points = usac->points();
    Components parts = usac->components();
    const Ptr<UnreliableSolver> solver = makePtr<UnreliableSolver>(parts.nonMinimalSolver, INT_MAX,
                                                                   false);
    parts.nonMinimalSolver = solver;
    const RunContext run(points, parts, params);
    const Context& context = run;
    const Model truth = toInternal(points, scene.model);
    const Quality best = context.rate(truth);
    int early = 0, tried = 0;
    for (int i = 0; i < 200; ++i)
    {
        int sample[MAX_SAMPLE_SIZE];
        Model models[MAX_MODELS];
        Rng(1, i).distinct(points.size, 4, sample);
        if (parts.minimalSolver->solve(points, sample, models) == 0 ||
            points.size - context.rate(models[0]).cost > 0.2 * (points.size - best.cost))
            continue;
        const int all = fitsOf(context, *solver, models[0], Quality()),
                  some = fitsOf(context, *solver, models[0], best);
        EXPECT_LE(some, all);
        if (all > 1)  // otherwise, there are too few points for a fit
        {
            ++tried;
            early += some == 1;
        }
    }
    EXPECT_GT(tried, 20);
    EXPECT_GT(early, tried / 2);
    Model rough = truth;
    for (int k = 0; k < 9; ++k)
        rough.val[k] *= k % 2 ? 1.001 : 0.999;
    EXPECT_GE(fitsOf(context, *solver, rough, best), 3);
}

//! If there are too few inliers for inner samples of full size (12 points of H), an optimization
//! must fit at least four of them, unless none are asked for.
TEST(Usac_LocalOptimizers, graphCutDrawsMoreSamplesFromFewInliers)
{
    const int inliers[] = {20, 40}, asked[] = {0, 1, 10};
    for (int k = 0; k < 2; ++k)
    {
        const Scene scene = makeScene(HOMOGRAPHY, inliers[k], 20);
        int fits[3];
        for (int i = 0; i < 3; ++i)
        {
            Params params;
            params.localSamples = asked[i];
            params.localIterations = 1;
            const Ptr<Usac> usac = createUsac(scene, params);
            Components parts = usac->components();
            const Ptr<UnreliableSolver> solver = makePtr<UnreliableSolver>(parts.nonMinimalSolver,
                                                                           INT_MAX, false);
            parts.nonMinimalSolver = solver;
            const RunContext run(usac->points(), parts, params);
            fits[i] = fitsOf(run, *solver, toInternal(usac->points(), scene.model), Quality());
        }
        EXPECT_EQ(k == 0 ? 4 : 1, fits[1] - fits[0]);
        EXPECT_EQ(10, fits[2] - fits[0]);
    }
}

//! A grid that records how many points the graph cut labels.
class RecordedGrid : public Neighborhood
{
public:
    explicit RecordedGrid(bool first_) : first(first_), grid(createGridNeighborhood(4)) {}

    void start(const Context& context) CV_OVERRIDE { grid->start(context); }
    int layers() const CV_OVERRIDE { return grid->layers(); }
    int members(const Context& context, int layer, int point, const int*& members) CV_OVERRIDE
    {
        return grid->members(context, layer, point, members);
    }
    int edges(const Context& context, const uchar* wanted, const Vec2i*& edges) CV_OVERRIDE
    {
        sizes.push_back(context.points.size);
        return grid->edges(context, wanted, edges);
    }
    int mostEdges() const CV_OVERRIDE { return grid->mostEdges(); }
    bool edgesOfFirstPoints() const CV_OVERRIDE { return first; }

    std::vector<int> sizes;

private:
    const bool first;
    const Ptr<Neighborhood> grid;
};

//! With many inliers, the graph cut must at the end label only as many points as contain about a
//! thousand inliers; with few inliers, or if the neighborhood does not support it, all points.
TEST(Usac_LocalOptimizers, graphCutLabelsTheFirstPoints)
{
    const struct
    {
        int inliers, outliers;
        bool first;
        int expected;
    } cases[] = {{6000, 10000, true, 4096}, {300, 2700, true, 3000}, {6000, 10000, false, 16000}};
    for (const auto& c : cases)
    {
        const Scene scene = makeScene(HOMOGRAPHY, c.inliers, c.outliers);
        const Ptr<Usac> usac = createUsac(scene, Params());
        const Ptr<RecordedGrid> recorder = makePtr<RecordedGrid>(c.first);
        usac->components().neighborhood = recorder;
        EXPECT_FALSE(usac->run().empty());
        ASSERT_FALSE(recorder->sizes.empty());
        EXPECT_EQ(c.expected, recorder->sizes.back()) << c.inliers << " of " << scene.size();
    }
}

}  // namespace
}  // namespace opencv_test
