// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/contracts.hpp"

// An object that is run again must give the results of a new object.

namespace opencv_test {
namespace {

void expectSame(const Mat& a, const Mat& maskA, const Report& reportA, const Mat& b,
                const Mat& maskB, const Report& reportB)
{
    ASSERT_EQ(a.empty(), b.empty());
    if (!a.empty())
    {
        EXPECT_EQ(0, cv::norm(a, b, NORM_INF));
    }
    EXPECT_EQ(0, cv::norm(maskA, maskB, NORM_INF));
    EXPECT_EQ(reportA.iterations, reportB.iterations);
    EXPECT_EQ(reportA.cost, reportB.cost);
    EXPECT_EQ(reportA.threshold, reportB.threshold);
    EXPECT_EQ(reportA.stop, reportB.stop);
    EXPECT_EQ(reportA.models, reportB.models);
}

typedef testing::TestWithParam<int> Usac_Rerun;

TEST_P(Usac_Rerun, givesTheSame)
{
    const ProblemType problem = (ProblemType)GetParam();
    const std::vector<NamedPreset> presets = allPresets(problem);
    SceneOptions options;
    options.outliers = 60;
    const Scene scene = makeScene(problem, options);
    for (size_t p = 0; p < presets.size(); ++p)
    {
        Params params = presets[p].params;
        params.maxIterations = std::min(params.maxIterations, 500);
        // below the noise, so that the reach of magsac() and magsacPlusPlus() grows during a run
        params.threshold = 0.3;
        const Ptr<Usac> usac = createUsac(scene, params);
        Mat masks[3], models[3];
        Report reports[3];
        for (int i = 0; i < 3; ++i)
            models[i] = usac->run(masks[i], &reports[i]);
        for (int i = 1; i < 3; ++i)
            expectSame(models[0], masks[0], reports[0], models[i], masks[i], reports[i]);
    }
}

//! The points are replaced by more, fewer and very few others, and by the first ones again.
TEST_P(Usac_Rerun, withOtherPoints)
{
    const ProblemType problem = (ProblemType)GetParam();
    const int sizes[] = {100, 300, 20, 3, 100};
    const Ptr<Usac> usac = createUsac(makeScene(problem), Params());
    for (int i = 0; i < 5; ++i)
    {
        SceneOptions options;
        options.setSize(sizes[i], 0.7);
        options.seed = 1 + i % 4;
        const Scene scene = makeScene(problem, options);
        Mat masks[2];
        Report reports[2];
        usac->setPoints(scene.points1, scene.points2);
        EXPECT_EQ(sizes[i], usac->points().size);
        const Mat again = usac->run(masks[0], &reports[0]),
                  once = createUsac(scene, Params())->run(masks[1], &reports[1]);
        expectSame(again, masks[0], reports[0], once, masks[1], reports[1]);
    }
    EXPECT_THROW(usac->setPoints(std::vector<Point2d>(3), std::vector<Point2d>(4)), cv::Exception);
}

INSTANTIATE_TEST_CASE_P(All, Usac_Rerun, testing::ValuesIn(TWO_VIEW_PROBLEMS));

//! After setPoints() has raised an exception, the object must have no points. It must then accept
//! valid points again.
TEST(Usac_RerunPoints, afterAMistake)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    const Ptr<Usac> usac = createUsac(scene, Params());
    Report report;
    EXPECT_FALSE(usac->run(noArray(), &report).empty());
    EXPECT_THROW(usac->setPoints(scene.points1, std::vector<Point2d>(4)), cv::Exception);
    EXPECT_EQ(0, usac->points().size);
    EXPECT_TRUE(usac->run(noArray(), &report).empty());
    EXPECT_EQ((int)STOP_TOO_FEW_POINTS, report.stop);
    usac->setPoints(scene.points1, scene.points2);
    EXPECT_EQ(0, cv::norm(usac->run(), estimate(scene, Params()), NORM_INF));
}

//! Counts the starts of a component, and its uses since the last start. `size` is the number of
//! points at the last start. `wrong` counts the uses with another number of points.
struct Life
{
    Life() : starts(0), size(-1), uses(0), wrong(0) {}

    void start(const Context& context)
    {
        ++starts;
        size = context.points.size;
        uses = 0;
    }

    //! Records a use with this number of points.
    void use(int points)
    {
        ++uses;
        wrong += points != size;
    }

    int starts, size, uses, wrong;
};

/* Components of a caller, which record how they are used. Otherwise they work like those of the
library or have no effect. */

class LivingSampler : public Sampler
{
public:
    void start(const Context& context) CV_OVERRIDE { life.start(context); }
    void sample(const Context& context, State& state, int* out) CV_OVERRIDE
    {
        life.use(context.points.size);
        state.rng.distinct(context.points.size, context.components.minimalSolver->sampleSize(),
                           out);
    }
    Life life;
};

class LivingSolver : public MinimalSolver
{
public:
    explicit LivingSolver(const Ptr<MinimalSolver>& solver_) : solver(solver_) {}
    void start(const Context& context) CV_OVERRIDE { life.start(context); }
    int sampleSize() const CV_OVERRIDE { return solver->sampleSize(); }
    int solve(const Correspondences& points, const int* sample, Model* models) const CV_OVERRIDE
    {
        life.use(points.size);
        return solver->solve(points, sample, models);
    }
    mutable Life life;

private:
    const Ptr<MinimalSolver> solver;
};

class LivingFit : public NonMinimalSolver
{
public:
    explicit LivingFit(const Ptr<NonMinimalSolver>& solver_) : solver(solver_) {}
    void start(const Context& context) CV_OVERRIDE
    {
        life.start(context);
        solver->start(context);
    }
    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int iterations) const CV_OVERRIDE
    {
        life.use(points.size);
        return solver->fit(points, indices, count, weights, model, iterations);
    }
    mutable Life life;

private:
    const Ptr<NonMinimalSolver> solver;
};

class LivingScore : public Score
{
public:
    void start(const Context& context) CV_OVERRIDE { life.start(context); }
    void accumulate(float* errors, int count, float limit, Quality& sum) const CV_OVERRIDE
    {
        life.use(life.size);
        life.wrong += life.starts == 0;
        for (int i = 0; i < count; ++i)
        {
            sum.inliers += errors[i] <= limit;
            sum.cost += errors[i] <= limit ? errors[i] / limit : 1;
        }
    }
    mutable Life life;
};

class LivingOrdering : public Ordering
{
public:
    void start(const Context& context) CV_OVERRIDE { life.start(context); }
    void sort(const Context& context, int* order) CV_OVERRIDE
    {
        life.use(context.points.size);
        for (int i = 0; i < context.points.size; ++i)
            order[i] = i;
    }
    Life life;
};

class LivingNeighborhood : public Neighborhood
{
public:
    void start(const Context& context) CV_OVERRIDE { life.start(context); }
    int layers() const CV_OVERRIDE { return 1; }
    int members(const Context&, int, int, const int*&) CV_OVERRIDE { return 0; }
    int edges(const Context& context, const uchar*, const Vec2i*& edges) CV_OVERRIDE
    {
        life.use(context.points.size);
        edges = 0;
        return 0;
    }
    Life life;
};

class LivingVerifier : public Verifier
{
public:
    void start(const Context& context) CV_OVERRIDE { life.start(context); }
    int nextBlock(int) const CV_OVERRIDE { return 64; }
    bool proceed(int, int) const CV_OVERRIDE { return true; }
    void sampleTested(State&, int, int) CV_OVERRIDE {}
    void adapt(const Context& context, State&) CV_OVERRIDE { life.use(context.points.size); }
    Life life;
};

class LivingDegeneracy : public Degeneracy
{
public:
    void start(const Context& context) CV_OVERRIDE { life.start(context); }
    bool validSample(const Context& context, const int*) const CV_OVERRIDE
    {
        life.use(context.points.size);
        return true;
    }
    mutable Life life;
};

class LivingTermination : public Termination
{
public:
    void start(const Context& context) CV_OVERRIDE { life.start(context); }
    int iterations(const Context& context, const State&) const CV_OVERRIDE
    {
        life.use(context.points.size);
        return 100;
    }
    mutable Life life;
};

class LivingPolisher : public Polisher
{
public:
    void start(const Context& context) CV_OVERRIDE { life.start(context); }
    void polish(const Context& context, Model&) CV_OVERRIDE { life.use(context.points.size); }
    Life life;
};

//! Each component must be started once per run, before it is used, even if there are too few
//! points.
TEST(Usac_RerunComponents, beginOnceARun)
{
    Params params;
    params.threads = 1;
    params.orderedEvery = 1;
    const Ptr<Usac> usac = createUsac(makeScene(HOMOGRAPHY), params);
    Components& parts = usac->components();
    const Ptr<LivingSampler> sampler = makePtr<LivingSampler>();
    const Ptr<LivingSolver> solver = makePtr<LivingSolver>(parts.minimalSolver);
    const Ptr<LivingFit> fit = makePtr<LivingFit>(parts.nonMinimalSolver);
    const Ptr<LivingScore> score = makePtr<LivingScore>();
    const Ptr<LivingOrdering> ordering = makePtr<LivingOrdering>();
    const Ptr<LivingNeighborhood> neighborhood = makePtr<LivingNeighborhood>();
    const Ptr<LivingVerifier> verifier = makePtr<LivingVerifier>();
    const Ptr<LivingDegeneracy> degeneracy = makePtr<LivingDegeneracy>();
    const Ptr<LivingTermination> termination = makePtr<LivingTermination>();
    const Ptr<LivingPolisher> polisher = makePtr<LivingPolisher>();
    parts.minimalSolver = solver;
    parts.nonMinimalSolver = fit;
    parts.score = score;
    parts.neighborhood = neighborhood;
    parts.verifier = verifier;
    parts.degeneracies.assign(1, degeneracy);
    parts.terminations.assign(1, termination);
    parts.polisher = polisher;
    const Life* const lives[] = {&solver->life,       &fit->life,      &score->life,
                                 &neighborhood->life, &verifier->life, &degeneracy->life,
                                 &termination->life,  &polisher->life, &sampler->life,
                                 &ordering->life};
    const int sizes[] = {300, 300, 80, 3, 500};
    for (int run = 0; run < 5; ++run)
    {
        SceneOptions options;
        options.setSize(sizes[run], 0.7);
        const Scene scene = makeScene(HOMOGRAPHY, options);
        if (run != 1)  // run 1 has the points of run 0
            usac->setPoints(scene.points1, scene.points2);
        parts.sampler = run == 2 ? (Ptr<Sampler>)sampler
                                 : createUsac(scene, params)->components().sampler;
        parts.ordering = run == 4 ? (Ptr<Ordering>)ordering : Ptr<Ordering>();
        EXPECT_EQ(sizes[run] < 4, usac->run().empty());
        for (int k = 0; k < 10; ++k)
        {
            const bool there = k < 8 || (k == 8 && run == 2) || (k == 9 && run == 4);
            EXPECT_EQ(k < 8 ? run + 1 : k == 8 ? run >= 2 : run >= 4, lives[k]->starts) << k;
            EXPECT_EQ(0, lives[k]->wrong) << k;
            if (there)
            {
                EXPECT_EQ(sizes[run], lives[k]->size) << k;
                EXPECT_EQ(sizes[run] >= 4 || k == 2, lives[k]->uses > 0) << k << " " << run;
            }
        }
    }
}

}  // namespace
}  // namespace opencv_test
