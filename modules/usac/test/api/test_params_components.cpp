// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"
#include "support/scene_geometry.hpp"

// A field of Params must have an effect when only this field is changed. This file tests the
// fields of verification, local optimization, termination, degeneracy and polishing;
// test_params_effects.cpp tests other fields.

namespace opencv_test {
namespace {

typedef UsacProblem UsacComponents;
INSTANTIATE_TEST_CASE_P(/**/, UsacComponents, testing::ValuesIn(TWO_VIEW_PROBLEMS));

//! Counts the points whose errors are computed in single precision, as in the search.
class CountingResidual : public Residual
{
public:
    explicit CountingResidual(const Ptr<Residual>& residual_) : points(0), residual(residual_) {}

    void squaredErrors(const Correspondences& p, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        points += end - begin;
        residual->squaredErrors(p, model, begin, end, errors);
    }

    void squaredErrors(const Model& model, const double* const* columns, int count,
                       double* errors) const CV_OVERRIDE
    {
        residual->squaredErrors(model, columns, count, errors);
    }

    mutable int64 points;

private:
    Ptr<Residual> residual;
};

//! Number of point errors that a run without local optimization computes in single precision.
int64 pointsTested(const Scene& scene, VerificationType verification)
{
    Params params;
    params.localOptimization = LOCAL_OPTIMIZATION_NONE;
    params.quality = QUALITY_INLIERS;
    params.verification = verification;
    params.termination = 0;
    params.maxIterations = 500;
    Ptr<Usac> usac = createUsac(scene, params);
    const Ptr<CountingResidual> counter = makePtr<CountingResidual>(usac->components().residual);
    usac->components().residual = counter;
    EXPECT_FALSE(usac->run().empty());
    return counter->points;
}

TEST_P(UsacComponents, verification)
{
    const Scene scene = makeScene(problem(), 1000, 1000, 3);
    const int64 all = pointsTested(scene, VERIFICATION_NONE),
                sprt = pointsTested(scene, VERIFICATION_SPRT);
    EXPECT_GT(sprt, 0);
    EXPECT_LT(sprt, 0.75 * all);
}

//! Records the sizes of the point sets to which models are fitted.
class FitRecorder : public NonMinimalSolver
{
public:
    //! @param part_ fraction of the step from the old model to the fitted model that is taken; with
    //! 1, the fitted model is returned
    FitRecorder(const Ptr<NonMinimalSolver>& solver_, double part_) : solver(solver_), part(part_)
    {}

    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int iterations) const CV_OVERRIDE
    {
        sizes.push_back(count);
        Model fitted = model;
        if (!solver->fit(points, indices, count, weights, fitted, iterations))
            return false;
        const Matx33d from = model, to = fitted;
        model = part == 1 ? to : from + part * (to * (to.dot(from) < 0 ? -1. : 1.) - from);
        return true;
    }

    mutable std::vector<int> sizes;

private:
    Ptr<NonMinimalSolver> solver;
    double part;
};

//! The number of points of each fit in the local optimizations of a run. The run has no polishing,
//! because the fits of the polishing would be recorded, too.
std::vector<int> localFits(const Scene& scene, Params params, Report* report = 0, double part = 1)
{
    params.polishing = POLISHING_NONE;
    params.degeneracy = 0;
    params.sampler = SAMPLER_UNIFORM;
    params.termination = 0;
    params.maxIterations = 300;
    Ptr<Usac> usac = createUsac(scene, params);
    const Ptr<FitRecorder> recorder = makePtr<FitRecorder>(usac->components().nonMinimalSolver,
                                                           part);
    usac->components().nonMinimalSolver = recorder;
    usac->run(noArray(), report);
    return recorder->sizes;
}

TEST_P(UsacComponents, localOptimization)
{
    const Scene scene = makeScene(problem(), 200, 200, 3);
    Params params;
    Report with, without;
    EXPECT_FALSE(localFits(scene, params, &with).empty());
    params.localOptimization = LOCAL_OPTIMIZATION_NONE;
    EXPECT_TRUE(localFits(scene, params, &without).empty());
    EXPECT_GT(with.localOptimizations, 0);
    EXPECT_GT(with.localImprovements, 0);
    EXPECT_EQ(0, without.localOptimizations);
    EXPECT_LT(with.cost, without.cost);
}

//! The fits make only a fifth of the step to the optimum, so that one iteration does not converge.
//! A run with up to ten iterations must therefore make more fits than a run with one.
TEST_P(UsacComponents, localIterations)
{
    size_t one = 0, ten = 0;
    for (uint64 seed = 1; seed <= 5; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.outliers = 20;
        const Scene scene = makeScene(problem(), options);
        Params params;
        params.localIterations = 1;
        one += localFits(scene, params, 0, 0.2).size();
        params.localIterations = 10;
        ten += localFits(scene, params, 0, 0.2).size();
    }
    EXPECT_GT(one, (size_t)0);
    EXPECT_GT(ten, one);
}

TEST_P(UsacComponents, localSamples)
{
    const Scene scene = makeScene(problem(), 200, 200, 3);
    Params params;
    params.localIterations = 1;
    params.localSampleMultiple = 9;
    const int size = 9 * sampleSizeOf(problem());
    params.localSamples = 0;
    const std::vector<int> none = localFits(scene, params);
    params.localSamples = 10;
    const std::vector<int> ten = localFits(scene, params);
    EXPECT_GE(std::count(ten.begin(), ten.end(), size),
              std::count(none.begin(), none.end(), size) + 10);
    EXPECT_GE(ten.size(), none.size() + 10);
}

TEST_P(UsacComponents, localSampleMultiple)
{
    const Scene scene = makeScene(problem(), 400, 100, 3);
    const int multiples[] = {2, 7, 15};
    for (int i = 0; i < 3; ++i)
    {
        Params params;
        params.localSampleMultiple = multiples[i];
        params.localSamples = 4;
        const std::vector<int> sizes = localFits(scene, params);
        const int wanted = multiples[i] * sampleSizeOf(problem());
        EXPECT_GE(std::count(sizes.begin(), sizes.end(), wanted), 4) << "samples of " << wanted;
        for (int k = 0; k < 3; ++k)
            if (k != i)
            {
                EXPECT_EQ(0, std::count(sizes.begin(), sizes.end(),
                                        multiples[k] * sampleSizeOf(problem())));
            }
    }
}

TEST_P(UsacComponents, spatialWeight)
{
    const Scene scene = makeScene(problem(), 200, 50, 3);
    Params params;
    // equal to the standard deviation of the noise, so that the errors of many points are near the
    // threshold and their labels depend on their neighbors
    params.threshold = 0.5;
    std::vector<int> before;
    const double weights[] = {0, 0.14, 5};
    for (int i = 0; i < 3; ++i)
    {
        params.spatialWeight = weights[i];
        const std::vector<int> sizes = localFits(scene, params);
        ASSERT_FALSE(sizes.empty());
        EXPECT_NE(before, sizes) << "the weight must change the inliers";
        before = sizes;
    }
}

TEST_P(UsacComponents, termination)
{
    const Scene scene = makeScene(problem(), 150, 150, 3);
    Params params;
    params.termination = TERMINATION_STANDARD;
    EXPECT_EQ((int)STOP_STANDARD, reportOf(scene, params).stop);
    params.termination = TERMINATION_SPRT;
    EXPECT_EQ((int)STOP_SPRT, reportOf(scene, params).stop);
    params.termination = TERMINATION_P_NAPSAC;
    EXPECT_EQ((int)STOP_P_NAPSAC, reportOf(scene, params).stop);
    params.termination = 0;
    params.maxIterations = 500;
    const Report all = reportOf(scene, params);
    EXPECT_EQ((int)STOP_MAX_ITERATIONS, all.stop);
    EXPECT_EQ(500, all.iterations);
    params.termination = 7;
    params.maxIterations = 5000;
    const Report first = reportOf(scene, params);
    // with samples of one point, all criteria are fulfilled in the first batch of samples
    if (sampleSizeOf(problem()) > 1)
    {
        EXPECT_EQ((int)STOP_P_NAPSAC, first.stop) << "the criterion that is fulfilled first";
    }
    EXPECT_LT(first.iterations, 5000);
}

TEST_P(UsacComponents, relaxation)
{
    const Scene scene = makeScene(problem(), 100, 200, 3);
    int before = INT_MAX;
    const double relaxations[] = {0, 0.2, 0.6};
    for (int i = 0; i < 3; ++i)
    {
        Params params;
        params.termination = TERMINATION_P_NAPSAC;
        params.sampler = SAMPLER_UNIFORM;
        params.maxIterations = 1000000;
        params.relaxation = relaxations[i];
        const int iterations = reportOf(scene, params).iterations;
        EXPECT_LT(iterations, before);
        before = iterations;
    }
}

TEST_P(UsacComponents, degeneracy_orientation)
{
    const Scene scene = makeScene(problem(), 100, 200, 3);
    Params params;
    params.termination = 0;
    params.maxIterations = 300;
    params.degeneracy = DEGENERACY_ORIENTATION;
    const Report with = reportOf(scene, params);
    params.degeneracy = 0;
    const Report without = reportOf(scene, params);
    EXPECT_EQ(0, without.rejectedModels);
    if (problem() == HOMOGRAPHY)
    {
        EXPECT_GT(with.rejectedSamples, without.rejectedSamples + 50);
    }
    else if (isAffine(problem()))
    {
        EXPECT_EQ(without.rejectedSamples, with.rejectedSamples) << "all orientations are valid";
        EXPECT_EQ(0, with.rejectedModels);
    }
    else
    {
        EXPECT_GT(with.rejectedModels, 50);
    }
}

TEST(Usac_Components, degeneracy_degensac)
{
    double with = 0, without = 0;
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        SceneOptions options;
        options.planeFraction = 0.9;
        options.seed = seed;
        const Scene scene = makeScene(FUNDAMENTAL, options);
        Params params;
        Report report;
        with += std::min(10.,
                         modelError(scene, estimate(scene, params, noArray(), &report), OFF_PLANE));
        EXPECT_TRUE(report.degenerate);
        params.degeneracy = DEGENERACY_ORIENTATION;
        without += std::min(
            10., modelError(scene, estimate(scene, params, noArray(), &report), OFF_PLANE));
        EXPECT_FALSE(report.degenerate);
    }
    EXPECT_LT(with, without);
}

TEST_P(UsacComponents, polishing)
{
    Params params;
    params.localOptimization = LOCAL_OPTIMIZATION_NONE;
    double with = 0, reweighted = 0, without = 0;
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        const Scene scene = makeScene(problem(), options);
        params.polishing = POLISHING_LEAST_SQUARES;
        with += modelError(scene, estimate(scene, params));
        params.polishing = POLISHING_ROBUST;
        reweighted += modelError(scene, estimate(scene, params));
        params.polishing = POLISHING_NONE;
        without += modelError(scene, estimate(scene, params));
    }
    EXPECT_LT(with, 0.8 * without);
    EXPECT_LT(reweighted, 0.8 * without);
    EXPECT_NE(with, reweighted);
}

//! With persistence p, the number of samples must be about p times that with persistence 1. The
//! best model of this scene is found so early that the number of samples that the criterion
//! requires, before it is multiplied by p, is about the same for each p.
TEST_P(UsacComponents, persistence)
{
    const Scene scene = makeScene(problem(), 150, 150, 3);
    int iterations[3], several[] = {1, 2, 5};
    for (int i = 0; i < 3; ++i)
    {
        Params params;
        params.termination = TERMINATION_STANDARD;
        params.sampler = SAMPLER_UNIFORM;
        params.maxIterations = 100000;
        params.persistence = several[i];
        params.runnersUp = 0;  // no samples in addition to those that the criterion asks for
        const Report report = reportOf(scene, params);
        EXPECT_EQ((int)STOP_STANDARD, report.stop);
        iterations[i] = report.iterations;
    }
    EXPECT_GT(iterations[1], 1.7 * iterations[0]);
    EXPECT_LE(iterations[1], 2 * iterations[0]);
    EXPECT_GT(iterations[2], 4 * iterations[0]);
    EXPECT_LE(iterations[2], 5 * iterations[0]);
}

//! The polishing must make at most as many fits as allowed. POLISHING_ROBUST must make fewer than
//! 30 fits even if 64 are allowed, because the model no longer changes.
TEST_P(UsacComponents, polishingSteps)
{
    const Scene scene = makeScene(problem(), 200, 100, 3);
    const PolishingType types[] = {POLISHING_LEAST_SQUARES, POLISHING_REWEIGHTED, POLISHING_ROBUST};
    for (int i = 0; i < 3; ++i)
        for (int steps = 1; steps <= 65; steps *= 4)
        {
            Params params;
            params.localOptimization = LOCAL_OPTIMIZATION_NONE;
            params.degeneracy = 0;
            params.polishing = types[i];
            params.polishingSteps = steps;
            const Ptr<Usac> usac = createUsac(scene, params);
            const Ptr<FitRecorder> recorder = makePtr<FitRecorder>(
                usac->components().nonMinimalSolver, 1);
            usac->components().nonMinimalSolver = recorder;
            EXPECT_FALSE(usac->run().empty());
            const int fits = (int)recorder->sizes.size();
            EXPECT_LE(fits, steps) << (int)types[i];
            EXPECT_GE(fits, types[i] == POLISHING_ROBUST ? std::min(steps, 2) : 1) << (int)types[i];
            if (types[i] == POLISHING_ROBUST)
            {
                EXPECT_LT(fits, 30) << "the model no longer changes";
            }
        }
}

}  // namespace
}  // namespace opencv_test
