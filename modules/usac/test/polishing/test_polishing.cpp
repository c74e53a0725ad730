// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/run_context.hpp"
#include "test_precomp.hpp"
#include "support/counted_solver.hpp"
#include "polishing/polishing.hpp"

namespace opencv_test {
namespace {

//! Mean errors in pixels over 20 scenes, with least-squares polishing and with robust polishing
//! (`reweighted`) after the same search.
void comparePolishers(ProblemType problem, double noise, double& leastSquares, double& reweighted)
{
    leastSquares = reweighted = 0;
    const int SCENES = 20;
    for (int i = 0; i < SCENES; ++i)
    {
        SceneOptions options;
        options.noise = noise;
        options.seed = 1 + i;
        const Scene scene = makeScene(problem, options);
        Params params;
        params.threshold = 1;
        params.polishing = POLISHING_LEAST_SQUARES;
        leastSquares += modelError(scene, estimate(scene, params)) / SCENES;
        params.polishing = POLISHING_ROBUST;
        reweighted += modelError(scene, estimate(scene, params)) / SCENES;
    }
}

//! A threshold of only one standard deviation of the noise cuts off many true matches. Robust
//! polishing, whose smooth weights extend beyond the threshold, must then be more accurate than
//! least squares.
TEST(Usac_Polishing, smoothWeightsSurviveASmallThreshold)
{
    const ProblemType problems[] = {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL};
    for (int k = 0; k < 3; ++k)
    {
        double leastSquares, reweighted;
        comparePolishers(problems[k], 1.0, leastSquares, reweighted);
        EXPECT_LT(reweighted, leastSquares) << "problem " << (int)problems[k];
    }
}

//! Robust polishing must end as soon as further steps are expected to change hardly anything: for
//! H, each step leaves only a small part of the distance to the minimum. The result must then be
//! nearly as close to the minimum as that of many more steps.
TEST(Usac_Polishing, robustEndsWhenFurtherStepsChangeLittle)
{
    int fits = 0;
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        SceneOptions options;
        options.noise = 0.5;
        options.inliers = 3000;
        options.outliers = 1000;
        options.seed = seed;
        const Scene scene = makeScene(HOMOGRAPHY, options);
        const Ptr<Usac> usac = createUsac(scene, Params());
        Components parts = usac->components();
        const Ptr<CountedSolver> solver = makePtr<CountedSolver>(parts.nonMinimalSolver);
        parts.nonMinimalSolver = solver;
        Params params;
        params.polishingSteps = 50;
        const RunContext run(usac->points(), parts, params);
        const Ptr<Polisher> polisher = createRobustPolisher();
        Model model = toInternal(usac->points(), scene.model);
        polisher->polish(run, model);
        fits += solver->fits;
        Model more = model;
        for (int i = 0; i < 5; ++i)
            polisher->polish(run, more);
        const double moved = modelDistance(normalized(toInternal(usac->points(), scene.model)),
                                           normalized(model));
        EXPECT_LT(modelDistance(normalized(model), normalized(more)), 0.06 * moved) << seed;
    }
    EXPECT_LE(fits, 45);  // 50 if a step ends the polishing only by its own decrease
    EXPECT_GE(fits, 20);
}

//! A fit whose result has another scale and sign than its initial model.
class RescalingSolver : public NonMinimalSolver
{
public:
    explicit RescalingSolver(const Ptr<NonMinimalSolver>& solver_) : solver(solver_) {}

    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int iterations) const CV_OVERRIDE
    {
        const bool fitted = solver->fit(points, indices, count, weights, model, iterations);
        model = Matx33d(model) * -3;
        return fitted;
    }

private:
    const Ptr<NonMinimalSolver> solver;
};

//! Robust polishing takes longer steps than the fits. Scale and sign of a homogeneous model must
//! not matter for this.
TEST(Usac_Polishing, robustWithAnyScaleOfTheFit)
{
    for (ProblemType problem : {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL})
    {
        SceneOptions options;
        options.noise = 0.5;
        const Scene scene = makeScene(problem, options);
        const Ptr<Usac> usac = createUsac(scene, Params());
        Components parts = usac->components();
        Params params;
        Model models[2];
        for (int k = 0; k < 2; ++k)
        {
            const RunContext run(usac->points(), parts, params);
            models[k] = toInternal(usac->points(), scene.model);
            createRobustPolisher()->polish(run, models[k]);
            parts.nonMinimalSolver = makePtr<RescalingSolver>(parts.nonMinimalSolver);
        }
        EXPECT_LT(modelDistance(normalized(models[0]), normalized(models[1])), 1e-7)
            << (int)problem;
        EXPECT_GT(modelDistance(toInternal(usac->points(), scene.model), normalized(models[0])),
                  1e-5);
    }
}

//! A fit whose steps are 2.15 times as long. As re-weighted steps are too short by a sixth, they
//! still reach the minimum, but slowly; if they were longer, they would lead away from it.
class OvershootingSolver : public NonMinimalSolver
{
public:
    explicit OvershootingSolver(const Ptr<NonMinimalSolver>& solver_) : solver(solver_) {}

    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int) const CV_OVERRIDE
    {
        const Model before = model;
        const bool fitted = solver->fit(points, indices, count, weights, model, 1);
        for (int k = 0; k < model.size(); ++k)
            model.val[k] += 1.15 * (model.val[k] - before.val[k]);
        return fitted;
    }

private:
    const Ptr<NonMinimalSolver> solver;
};

//! Robust polishing must take a longer step back if this step has raised the loss.
TEST(Usac_Polishing, robustTakesBackStepsThatRaiseTheLoss)
{
    SceneOptions options;
    options.noise = 0.5;
    options.inliers = 200;
    options.outliers = 200;
    const Scene scene = makeScene(FUNDAMENTAL, options);
    const Ptr<Usac> usac = createUsac(scene, Params());
    Components parts = usac->components();
    Params params;
    params.polishingSteps = 100;
    const Model truth = toInternal(usac->points(), scene.model);
    Model models[2];
    for (int k = 0; k < 2; ++k)
    {
        const RunContext run(usac->points(), parts, params);
        models[k] = truth;
        createRobustPolisher()->polish(run, models[k]);
        parts.nonMinimalSolver = makePtr<OvershootingSolver>(parts.nonMinimalSolver);
    }
    const double moved = modelDistance(truth, normalized(models[0]));
    EXPECT_LT(modelDistance(normalized(models[0]), normalized(models[1])), 0.3 * moved);
}

//! Without points near the model, a polisher must not change the model.
TEST(Usac_Polishing, nothingNear)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    Ptr<Usac> usac = createUsac(scene, Params());
    const Params params;
    Arena arena;
    const Context context(usac->points(), usac->components(), params, arena);
    usac->components().start(context);
    const Model far = Matx33d(1, 0, 1e4, 0, 1, 1e4, 0, 0, 1);
    const Ptr<Polisher> polishers[] = {createLeastSquaresPolisher(), createRobustPolisher()};
    for (int k = 0; k < 2; ++k)
    {
        Model model = far;
        polishers[k]->polish(context, model);
        EXPECT_EQ(far, model);
    }
}

//! Counts the samples that are solved.
class CountedMinimalSolver : public MinimalSolver
{
public:
    explicit CountedMinimalSolver(const Ptr<MinimalSolver>& solver_) : solved(0), solver(solver_) {}
    int sampleSize() const CV_OVERRIDE { return solver->sampleSize(); }
    int solve(const Correspondences& points, const int* sample, Model* models) const CV_OVERRIDE
    {
        ++solved;
        return solver->solve(points, sample, models);
    }

    mutable int solved;

private:
    const Ptr<MinimalSolver> solver;
};

//! Polishes with another polisher, if there is one, and counts the samples and fits of polish().
class CountedPolisher : public Polisher
{
public:
    CountedPolisher(const Ptr<Polisher>& given_, const Ptr<CountedMinimalSolver>& samples_,
                    const Ptr<CountedSolver>& fits_)
        : solved(0), fitted(0), endSolved(0), endFitted(0), given(given_), samples(samples_),
          fits(fits_)
    {}
    void polish(const Context& context, Model& model) CV_OVERRIDE
    {
        solved = samples->solved;
        fitted = fits->fits;
        if (given)
            given->polish(context, model);
        endSolved = samples->solved;
        endFitted = fits->fits;
        solved = endSolved - solved;
        fitted = endFitted - fitted;
    }

    int solved, fitted, endSolved, endFitted;

private:
    const Ptr<Polisher> given;
    const Ptr<CountedMinimalSolver> samples;
    const Ptr<CountedSolver> fits;
};

//! All that follows the search is the polisher's work: after it, no sample is solved and nothing is
//! fitted. Only robust polishing solves samples (of few inliers). POLISHING_NONE stands here for a
//! polisher of the caller that does nothing.
TEST(Usac_Polishing, nothingButThePolisherPolishes)
{
    for (int problem : {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL})
        for (PolishingType polishing :
             {POLISHING_NONE, POLISHING_LEAST_SQUARES, POLISHING_REWEIGHTED, POLISHING_ROBUST})
        {
            Params params;
            params.polishing = polishing;
            const Ptr<Usac> usac = createUsac(makeScene((ProblemType)problem, 20, 5), params);
            Components& parts = usac->components();
            const Ptr<CountedMinimalSolver> samples = makePtr<CountedMinimalSolver>(
                parts.minimalSolver);
            const Ptr<CountedSolver> fits = makePtr<CountedSolver>(parts.nonMinimalSolver);
            const Ptr<CountedPolisher> polisher = makePtr<CountedPolisher>(parts.polisher, samples,
                                                                           fits);
            parts.minimalSolver = samples;
            parts.nonMinimalSolver = fits;
            parts.polisher = polisher;
            EXPECT_FALSE(usac->run().empty());
            SCOPED_TRACE(cv::format("problem %d, polishing %d", problem, polishing));
            EXPECT_EQ(polishing == POLISHING_ROBUST, polisher->solved > 0);
            EXPECT_EQ(polishing != POLISHING_NONE, polisher->fitted > 0);
            EXPECT_EQ(polisher->endSolved, samples->solved);
            EXPECT_EQ(polisher->endFitted, fits->fits);
        }
}

}
}  // namespace
