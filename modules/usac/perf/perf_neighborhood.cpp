// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_precomp.hpp"
#include "perf_scene.hpp"
#include "neighborhood/neighborhood.hpp"
#include "ordering/ordering.hpp"

namespace opencv_test {
namespace {

typedef TestBaseWithParam<int> UsacSize;

// The tests measure work that a run does at most once: building the neighborhood graph and sorting
// the points. One test cycle does this work as often as necessary for 1000000 points in total, so
// that a millisecond per cycle is a nanosecond per point.

const int POINTS = 1000000;

PERF_TEST_P(UsacSize, grid_1000000points, testing::Values(100, 1000, 10000, 100000))
{
    const PerfScene scene(FUNDAMENTAL, GetParam());
    int found = 0;
    TEST_CYCLE()
    {
        for (int k = 0; k < POINTS / GetParam(); ++k)
        {
            const int* members = 0;
            scene.context.arena.clear();
            found = createGridNeighborhood(4)->members(scene.context, 0, 0,
                                                       members);  // builds the grid
        }
    }
    EXPECT_GT(found, 0);
    SANITY_CHECK_NOTHING();
}

PERF_TEST_P(UsacSize, gridWithEdges_1000000points, testing::Values(100, 1000, 10000, 100000))
{
    const PerfScene scene(FUNDAMENTAL, GetParam());
    int edges = 0;
    TEST_CYCLE()
    {
        for (int k = 0; k < POINTS / GetParam(); ++k)
        {
            const Vec2i* links = 0;
            scene.context.arena.clear();
            edges = createGridNeighborhood(4)->edges(scene.context, 0, links);
        }
    }
    EXPECT_GT(edges, 0);
    SANITY_CHECK_NOTHING();
}

PERF_TEST_P(UsacSize, densityPrior_1000000points, testing::Values(100, 1000, 10000, 100000))
{
    const PerfScene scene(FUNDAMENTAL, GetParam());
    std::vector<int> order(GetParam());
    TEST_CYCLE()
    {
        for (int k = 0; k < POINTS / GetParam(); ++k)
            createDensityOrdering()->sort(scene.context, order.data());
    }
    std::sort(order.begin(), order.end());
    EXPECT_TRUE(order.front() == 0 && order.back() == GetParam() - 1);
    SANITY_CHECK_NOTHING();
}

}  // namespace
}  // namespace opencv_test
