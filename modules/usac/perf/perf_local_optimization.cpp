// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_precomp.hpp"
#include "perf_scene.hpp"
#include "local_optimization/labeling.hpp"

namespace opencv_test {
namespace {

typedef TestBaseWithParam<tuple<PerfProblem, int>> UsacGraphCut;

//! The best model of a sample of true matches, as the start of a local optimization.
Model modelOfSample(const PerfScene& scene, int stream)
{
    const Context& context = scene.context;
    const MinimalSolver& solver = *context.components.minimalSolver;
    Rng rng(1, stream);
    int sample[MAX_SAMPLE_SIZE];
    bool right;
    do
    {
        rng.distinct(context.points.size, solver.sampleSize(), sample);
        right = true;
        for (int i = 0; i < solver.sampleSize(); ++i)
            right = right && scene.isRight(sample[i]);
    } while (!right);
    Model models[MAX_MODELS], best;
    Quality bestQuality;
    const int count = solver.solve(context.points, sample, models);
    for (int i = 0; i < count; ++i)
    {
        const Quality quality = context.rate(models[i]);
        if (!quality.betterThan(bestQuality))
            continue;
        best = models[i];
        bestQuality = quality;
    }
    return best;
}

//! Complete local optimizations of 20 models, each as if the model were the first one of a run.
PERF_TEST_P(UsacGraphCut, optimize_20models,
            testing::Combine(testing::ValuesIn(PERF_PROBLEMS), testing::Values(1000, 10000)))
{
    const PerfScene scene(get<0>(GetParam()).type, get<1>(GetParam()));
    std::vector<Model> models;
    for (int k = 0; k < 20; ++k)
        models.push_back(modelOfSample(scene, k));
    int improved = 0;
    TEST_CYCLE()
    {
        improved = 0;
        for (int k = 0; k < 20; ++k)
        {
            State state;
            state.rng = Rng(2, k);
            Model model = models[k];
            Quality quality = scene.context.rate(model);
            improved += scene.context.components.localOptimizer->optimize(scene.context, state,
                                                                          model, quality);
        }
    }
    EXPECT_GT(improved, 10);
    SANITY_CHECK_NOTHING();
}

//! The graph cut alone, 20 times with the true model. The neighborhood graph is built before the
//! measurement.
PERF_TEST_P(UsacGraphCut, cut_20times,
            testing::Combine(testing::ValuesIn(PERF_PROBLEMS), testing::Values(1000, 10000)))
{
    const PerfScene scene(get<0>(GetParam()).type, get<1>(GetParam()));
    Labeling labeling;
    std::vector<int> inliers(scene.context.points.size);
    int found = 0;
    labeling.cut(scene.context, scene.model, inliers.data());
    TEST_CYCLE()
    {
        for (int k = 0; k < 20; ++k)
            found = labeling.cut(scene.context, scene.model, inliers.data());
    }
    EXPECT_GT(found, get<1>(GetParam()) / 3);
    SANITY_CHECK_NOTHING();
}

}  // namespace
}  // namespace opencv_test
