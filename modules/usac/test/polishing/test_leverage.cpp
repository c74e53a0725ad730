// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "polishing/leverage.hpp"
#include "polishing/polishing.hpp"
#include "problems/kernels.hpp"
#include "support/problem_objects.hpp"
#include "support/run_context.hpp"

// If the true matches leave some parameters of F nearly free, a model can be distorted to fit
// outliers of high leverage. The class Leverage must prevent this.

namespace opencv_test {
namespace {

//! A scene for F, whose camera moves by a small `baseline`; the depths are 4 to 9 in the same unit.
//! 60 % of the matches are inliers. The threshold of 1.5 pixels is five standard deviations of the
//! noise.
Scene smallBaseline(int size, double baseline, uint64 seed)
{
    SceneOptions options;
    options.setSize(size, 0.6);
    options.noise = 0.3;
    options.baseline = baseline;
    options.seed = seed;
    return makeScene(FUNDAMENTAL, options);
}

//! Median and upper sextile (5/6 quantile), over 60 scenes, of the errors in pixels.
struct Errors
{
    Errors(const Params& preset, int size, double baseline)
    {
        enum { RUNS = 60 };
        std::vector<double> all;
        for (int seed = 1; seed <= RUNS; ++seed)
        {
            Params params = preset;
            params.threshold = 1.5;
            const Scene scene = smallBaseline(size, baseline, 1000 + seed);
            all.push_back(modelError(scene, estimate(scene, params)));
        }
        std::sort(all.begin(), all.end());
        median = all[RUNS / 2];
        sextile = all[RUNS * 5 / 6];
    }
    double median, sextile;
};

//! The errors must be nearly as small as those of cv::USAC_MAGSAC, which has medians of 0.09 to
//! 0.10 pixels with 200 matches and 0.05 with 1000, and upper sextiles of 0.12 to 0.15 and 0.06 to
//! 0.08 pixels. Without Leverage, the medians are 0.17 to 0.19 and 0.09 to 0.16 pixels at a
//! baseline of 0.02.
TEST(Usac_Leverage, small_baselines)
{
    const Params presets[] = {Params::usacV20(), Params::accurate()};
    for (const Params& preset : presets)
        for (double baseline : {0.02, 0.05, 0.1})
        {
            const Errors few(preset, 200, baseline), many(preset, 1000, baseline);
            EXPECT_LE(few.median, 0.13) << preset.runnersUp << ", " << baseline;
            EXPECT_LE(many.median, 0.055) << preset.runnersUp << ", " << baseline;
            EXPECT_LE(many.sextile, 0.1) << preset.runnersUp << ", " << baseline;
        }
}

//! The residual of F as a caller could write it: without kernels.
class PlainResidual : public Residual
{
public:
    explicit PlainResidual(const Ptr<Residual>& inner_) : inner(inner_) {}

    void squaredErrors(const Correspondences& points, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        inner->squaredErrors(points, model, begin, end, errors);
    }
    void squaredErrors(const Model& model, const double* const* columns, int count,
                       double* errors) const CV_OVERRIDE
    {
        inner->squaredErrors(model, columns, count, errors);
    }
    int error(const Model& model, const double* datum, double* error) const CV_OVERRIDE
    {
        return inner->error(model, datum, error);
    }
    int linearize(const Model& model, const double* datum, double* error,
                  double* derivative) const CV_OVERRIDE
    {
        return inner->linearize(model, datum, error, derivative);
    }

private:
    const Ptr<Residual> inner;
};

//! A residual without kernels must give nearly the same errors. Without Leverage, the median would
//! be nearly twice as large.
TEST(Usac_Leverage, without_kernels)
{
    std::vector<double> errors[2];
    for (int seed = 1; seed <= 20; ++seed)
        for (int k = 0; k < 2; ++k)
        {
            const Scene scene = smallBaseline(200, 0.02, 1000 + seed);
            Params params;
            params.threshold = 1.5;
            const Ptr<Usac> usac = createUsac(scene, params);
            if (k == 1)
            {
                Components& parts = usac->components();
                parts.residual = makePtr<PlainResidual>(parts.residual);
                parts.nonMinimalSolver = usac->points().problem->createNonMinimalSolver(
                    parts.residual);
            }
            errors[k].push_back(modelError(scene, usac->run()));
        }
    for (std::vector<double>& all : errors)
        std::sort(all.begin(), all.end());
    EXPECT_LE(errors[1][10], 1.2 * errors[0][10]);
    EXPECT_LE(errors[1][16], 1.3 * errors[0][16]);
}

//! True matches off a dominant plane also have a high leverage and must not be dropped. Of 100
//! models, 2 miss these matches. Without Leverage, 1 model would miss them; if Leverage ignored
//! planes, 27 models would.
TEST(Usac_Leverage, few_matches_off_a_plane_stay)
{
    int lost = 0;
    for (int seed = 1; seed <= 100; ++seed)
    {
        SceneOptions options;
        options.setSize(1000, 0.5);
        options.noise = 0.5;
        options.planeFraction = 0.95;
        options.seed = seed;
        const Scene scene = makeScene(FUNDAMENTAL, options);
        Params params;
        params.threshold = 1.5;
        lost += modelError(scene, estimate(scene, params), OFF_PLANE) > 1.5;
    }
    EXPECT_LE(lost, 6);
}

//! The derivative of Sampson's distance must agree with finite differences. The distance has a
//! sign, because the root of its square has no derivative at 0. A step of 1e-9 changes errors by
//! about 1e-3 pixels.
TEST(Usac_Leverage, derivative_of_Sampsons_distance)
{
    const double STEP = 1e-9;
    const Ptr<Residual> residual = createResidualOf<SampsonError>();
    const Scene scene = smallBaseline(50, 1, 1);
    const Model model(scene.F * (1 / cv::norm(scene.F)));
    for (int i = 0; i < scene.size(); ++i)
    {
        const double datum[] = {scene.points1[i].x, scene.points1[i].y, scene.points2[i].x,
                                scene.points2[i].y};
        double error, derivative[9], other;
        ASSERT_EQ(1, residual->linearize(model, datum, &error, derivative));
        EXPECT_NEAR(pixelError(scene, scene.F, scene.points1[i], scene.points2[i]), std::abs(error),
                    1e-6);
        ASSERT_EQ(1, residual->error(model, datum, &other));
        EXPECT_NEAR(other, error, 1e-12 * (1 + std::abs(error)));
        const double size = cv::norm(Mat(9, 1, CV_64F, derivative));
        for (int k = 0; k < 9; ++k)
        {
            Model above = model, below = model;
            above.val[k] += STEP;
            below.val[k] -= STEP;
            double high, low;
            residual->error(above, datum, &high);
            residual->error(below, datum, &low);
            EXPECT_NEAR(derivative[k], (high - low) / (2 * STEP), 1e-4 * size) << i << ", " << k;
        }
    }
}

//! A custom problem that estimates F. `free_` selects the result of leavesFree(): 0: false; 1:
//! true; -1: that of the base class Problem.
class OwnFundamental : public Problem
{
public:
    explicit OwnFundamental(int free_) : free(free_), F(problemObject(FUNDAMENTAL)) {}

    String name() const CV_OVERRIDE { return "own"; }
    int dimension() const CV_OVERRIDE { return F.dimension(); }
    int errorDimension() const CV_OVERRIDE { return F.errorDimension(); }
    SampleCost sampleCost() const CV_OVERRIDE { return F.sampleCost(); }
    int normalization(int residual) const CV_OVERRIDE { return F.normalization(residual); }
    bool leavesFree(const Context& context, const Model& model) const CV_OVERRIDE
    {
        return free < 0 ? Problem::leavesFree(context, model) : free > 0;
    }
    bool toInput(const Model& model, const Correspondences& points, Model& result) const CV_OVERRIDE
    {
        return F.toInput(model, points, result);
    }
    Model closest(const Model& model) const CV_OVERRIDE { return F.closest(model); }
    Ptr<Residual> createResidual(int type) const CV_OVERRIDE { return F.createResidual(type); }
    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE { return F.createMinimalSolver(); }
    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>& residual) const CV_OVERRIDE
    {
        return F.createNonMinimalSolver(residual);
    }

private:
    const int free;
    const Problem& F;
};

//! By default, Problem::leavesFree is false, that is, the inliers of a custom problem are taken to
//! determine all parameters. Leverage then corrects models even if their sum of squared errors
//! decreases little. If leavesFree() is true, some of these corrections must not be made.
TEST(Usac_Leverage, custom_problems_leave_nothing_free)
{
    int prevented = 0;
    for (uint64 seed = 1; seed <= 20; ++seed)
    {
        const Scene scene = smallBaseline(200, 0.02, seed);
        Params params;
        params.threshold = 1.5;
        Mat models[3];
        for (int free = -1; free <= 1; ++free)
            models[free + 1] = Usac::create(makePtr<OwnFundamental>(free), scene.points1,
                                            scene.points2, params)
                                   ->run();
        EXPECT_EQ(0, cv::norm(models[0], models[1], NORM_INF)) << seed;
        prevented += cv::norm(models[0], models[2], NORM_INF) > 0;
    }
    EXPECT_GT(prevented, 0);
}

//! A solver that counts its fits. All fits except the first `good` ones fail.
class CountedFit : public NonMinimalSolver
{
public:
    CountedFit(const Ptr<NonMinimalSolver>& inner_, int good_) : inner(inner_), good(good_), fits(0)
    {}
    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int iterations) const CV_OVERRIDE
    {
        return fits++ < good && inner->fit(points, indices, count, weights, model, iterations);
    }

    const Ptr<NonMinimalSolver> inner;
    const int good;
    mutable int fits;
};

//! A residual whose derivatives are 0 after the first `good` fits of the solver.
class FlatResidual : public Residual
{
public:
    FlatResidual(const Ptr<Residual>& inner_, const CountedFit& solver_, int good_)
        : inner(inner_), solver(solver_), good(good_)
    {}
    void squaredErrors(const Correspondences& points, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        inner->squaredErrors(points, model, begin, end, errors);
    }
    void squaredErrors(const Model& model, const double* const* columns, int count,
                       double* errors) const CV_OVERRIDE
    {
        inner->squaredErrors(model, columns, count, errors);
    }
    int linearize(const Model& model, const double* datum, double* error,
                  double* derivative) const CV_OVERRIDE
    {
        const int components = inner->linearize(model, datum, error, derivative);
        if (solver.fits >= good)
            std::fill(derivative, derivative + components * model.size(), 0.);
        return components;
    }

private:
    const Ptr<Residual> inner;
    const CountedFit& solver;
    const int good;
};

//! The effect of Leverage on a model that fits wrong matches of high leverage. Only the first
//! `goodFits` fits of the least-squares solver succeed, and the derivatives of the residual are 0
//! after the first `goodDerivatives` fits.
struct Corrected
{
    Corrected(int goodFits, int goodDerivatives)
    {
        const Scene scene = smallBaseline(200, 0.02, 1001);
        Params params;
        params.threshold = 1.5;
        const Ptr<Usac> usac = createUsac(scene, params);
        Components& parts = usac->components();
        const Correspondences& points = usac->points();
        Model model = distorted(scene, points, *parts.nonMinimalSolver);
        const Ptr<CountedFit> solver = makePtr<CountedFit>(parts.nonMinimalSolver, goodFits);
        parts.nonMinimalSolver = solver;
        parts.residual = makePtr<FlatResidual>(parts.residual, *solver, goodDerivatives);
        const RunContext run(points, parts, params);
        const Model before = model;
        Leverage(run, *createBiweightPolisher()).improve(model);
        fits = solver->fits;
        changed = model != before;
        error = modelError(scene, Mat(toInput(points, model)));
        errorBefore = modelError(scene, Mat(toInput(points, before)));
    }

    int fits;  //!< number of fits that Leverage has started
    bool changed;
    double error, errorBefore;  //!< errors of the model after and before, see modelError()

private:
    //! F fitted to the true matches and, with a weight of 100, to the three wrong matches that have
    //! the smallest errors under the true F.
    static Model distorted(const Scene& scene, const Correspondences& points,
                           const NonMinimalSolver& solver)
    {
        std::vector<std::pair<double, int>> wrong;
        std::vector<int> fitted;
        for (int i = 0; i < points.size; ++i)
        {
            const int row = points.inputIndex[i];
            if (scene.truth[row])
                fitted.push_back(i);
            else
                wrong.push_back(std::make_pair(
                    pixelError(scene, scene.F, scene.points1[row], scene.points2[row]), i));
        }
        std::sort(wrong.begin(), wrong.end());
        std::vector<double> weights(fitted.size(), 1);
        for (int k = 0; k < 3; ++k)
        {
            fitted.push_back(wrong[k].second);
            weights.push_back(100);
        }
        Model model = toInternal(points, scene.F);
        EXPECT_TRUE(
            solver.fit(points, fitted.data(), (int)fitted.size(), weights.data(), model, 50));
        return model;
    }
};

//! Leverage makes five fits: two, from different starting points, to the inliers without those of
//! high leverage; two to the points of low leverage that agree with the better one of the first two
//! fits; and one to all points that agree with the better one of the next two. Polishing the result
//! then takes more fits. If all fits fail after the first 0, 2 or 4, the model must stay as it is.
//! If none fails, it must be corrected.
TEST(Usac_Leverage, nothingChangesIfFitsFail)
{
    const int good[] = {0, 2, 4}, asked[] = {2, 4, 5};
    for (int k = 0; k < 3; ++k)
    {
        const Corrected result(good[k], INT_MAX);
        EXPECT_EQ(asked[k], result.fits);
        EXPECT_FALSE(result.changed) << good[k];
    }
    const Corrected result(INT_MAX, INT_MAX);
    EXPECT_TRUE(result.changed);
    EXPECT_GT(result.fits, 5);
    EXPECT_GT(result.errorBefore, 2);
    EXPECT_LT(result.error, 0.4);
}

//! If the derivatives of the residual are 0, leverages cannot be computed. Leverage must then stop
//! and leave the model as it is: before the first fit, after the two fits without the points of
//! high leverage, or after the next two fits.
TEST(Usac_Leverage, nothingChangesWithoutLeverages)
{
    for (int good : {0, 2, 4})
    {
        const Corrected result(INT_MAX, good);
        EXPECT_EQ(good, result.fits);
        EXPECT_FALSE(result.changed) << good;
    }
}

}  // namespace
}  // namespace opencv_test
