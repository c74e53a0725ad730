// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/facade.hpp"

// Tests of scenes with repeated structure: wrong matches between different columns of windows of a
// facade lie on the epipolar lines of a wrong F, which can have more inliers than the right F.

namespace opencv_test {
namespace {

//! Number of scenes, out of 60, in which the error of the returned F is more than half a pixel, see
//! Facade::error(). `size`, `right` and `columns` are the parameters of Facade.
int wrongOnes(int size, double right, double columns)
{
    int wrong = 0;
    for (int seed = 1; seed <= 60; ++seed)
    {
        const Facade scene(size, right, columns, seed);
        Params params;
        params.threshold = 1;
        wrong += scene.error(estimateFundamental(scene.points1, scene.points2, params)) > 0.5;
    }
    return wrong;
}

//! If the cost alone decided between models, F would be wrong in 22, 22 and 46 of 60 scenes for the
//! three sets of parameters. As common neighbors of the matches also decide (commonNeighbors()), it
//! is wrong in 2, 4 and 13 scenes. These numbers depend on the platform.
TEST(Usac_RepeatedStructure, facades)
{
    EXPECT_LE(wrongOnes(600, 0.4, 0.2), 6);
    EXPECT_LE(wrongOnes(600, 0.5, 0.25), 6);
    EXPECT_LE(wrongOnes(600, 0.5, 0.35), 18);
}

}  // namespace
}  // namespace opencv_test
