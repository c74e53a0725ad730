// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"
#include "support/scene_geometry.hpp"

// A field of Params must have an effect when only this field is changed. This file tests the
// fields of local optimization, verification and polishing;
// test_params_effects.cpp tests other fields.

namespace opencv_test {
namespace {

typedef UsacProblem UsacComponents;
INSTANTIATE_TEST_CASE_P(/**/, UsacComponents, testing::ValuesIn(TWO_VIEW_PROBLEMS));

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
