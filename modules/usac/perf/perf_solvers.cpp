// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_precomp.hpp"
#include "perf_scene.hpp"

#include <numeric>

namespace opencv_test {
namespace {

typedef TestBaseWithParam<PerfProblem> UsacSolver;

//! Each test cycle solves 10000 samples, as many at once as in a run. 50 % of the points are
//! outliers, so about half of the samples, or more, contain outliers, as in a real run.
PERF_TEST_P(UsacSolver, minimal_10000samples, testing::ValuesIn(PERF_PROBLEMS))
{
    const int samples = 10000;
    const PerfScene scene(GetParam().type, 1000);
    const MinimalSolver& solver = *scene.usac->components().minimalSolver;
    const Correspondences& points = scene.usac->points();
    const int together = solver.together();
    std::vector<int> sample(samples * MAX_SAMPLE_SIZE);
    std::vector<const int*> all;
    for (int k = 0; k < samples; ++k)
    {
        all.push_back(&sample[k * MAX_SAMPLE_SIZE]);
        Rng(1, k).distinct(points.size, solver.sampleSize(), &sample[k * MAX_SAMPLE_SIZE]);
    }
    std::vector<Model> models(together * MAX_MODELS);
    std::vector<Model*> places;
    for (int k = 0; k < together; ++k)
        places.push_back(&models[k * MAX_MODELS]);
    std::vector<int> counts(together);
    int found = 0;
    TEST_CYCLE()
    {
        found = 0;
        for (int k = 0; k < samples; k += together)
        {
            const int count = std::min(together, samples - k);
            solver.solveMany(points, &all[k], count, places.data(), counts.data());
            found += std::accumulate(counts.begin(), counts.begin() + count, 0);
        }
    }
    EXPECT_GT(found, samples / 2);
    SANITY_CHECK_NOTHING();
}

}  // namespace
}  // namespace opencv_test
