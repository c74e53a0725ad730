// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_precomp.hpp"
#include "perf_scene.hpp"

namespace opencv_test {
namespace {

CV_ENUM(Problem, HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL, AFFINITY, SIMILARITY, RIGID_3D, SIMILARITY_3D)
typedef TestBaseWithParam<Problem> UsacSolver;

//! 10 000 samples a call. Half of the matches are wrong, so nearly all samples hold some, as in a
//! real run.
PERF_TEST_P(UsacSolver, minimal_10000samples, Problem::all())
{
    const int samples = 10000;
    const PerfScene scene((ProblemType)(int)GetParam(), 1000);
    const MinimalSolver& solver = *scene.usac->components().minimalSolver;
    const Correspondences& points = scene.usac->points();
    std::vector<int> sample(samples * MAX_SAMPLE_SIZE);
    for (int k = 0; k < samples; ++k)
        Rng(1, k).distinct(points.size, solver.sampleSize(), &sample[k * MAX_SAMPLE_SIZE]);
    int found = 0;
    TEST_CYCLE()
    {
        Model models[MAX_MODELS];
        found = 0;
        for (int k = 0; k < samples; ++k)
            found += solver.solve(points, &sample[k * MAX_SAMPLE_SIZE], models);
    }
    EXPECT_GT(found, samples / 2);
    SANITY_CHECK_NOTHING();
}

}
}  // namespace
