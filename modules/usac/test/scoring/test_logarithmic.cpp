// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "scoring/scores.hpp"

namespace opencv_test {
namespace {

Quality scoreOf(std::vector<float> squaredErrors, float squaredThreshold)
{
    Quality sum(0, 0);
    createLogarithmicScore()->accumulate(squaredErrors.data(), (int)squaredErrors.size(),
                                         squaredThreshold, sum);
    return sum;
}

//! The cost of a point with error e is log(1 + e^2 / s^2) / log(1 + t^2 / s^2), where t is the
//! threshold and s = t / 256. The logarithm to base 2 is interpolated linearly between powers of
//! two, with an error of at most 0.0861.
TEST(Usac_LogarithmicScore, formula)
{
    const double LINEAR = 0.0861 / 16;
    for (double threshold : {0.003, 1., 40.})
    {
        double before = -1;
        for (double error = 0; error <= threshold; error += threshold / 500)
        {
            const Quality q = scoreOf({(float)(error * error)}, (float)(threshold * threshold));
            const double r = 256 * error / threshold,
                         expected = std::log(1 + r * r) / std::log(1 + 256. * 256);
            EXPECT_NEAR(expected, q.cost, LINEAR + 1e-4) << error;
            EXPECT_EQ(1, q.inliers) << error;
            EXPECT_GE(q.cost, before) << error;
            before = q.cost;
        }
        EXPECT_NEAR(1, before, 1e-2);
    }
}

TEST(Usac_LogarithmicScore, outliers)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();
    for (float error : {1.0001f, 7.f, 1e30f, infinity, nan})
    {
        const Quality q = scoreOf({error}, 1);
        EXPECT_EQ(1, q.cost) << error;
        EXPECT_EQ(0, q.inliers) << error;
    }
    const Quality both = scoreOf({0.f, nan, 1.f}, 1);
    EXPECT_EQ(2, both.inliers);
    EXPECT_NEAR(2, both.cost, 1e-6);
}

//! Unlike MSAC with this threshold, the score must prefer the model with fewer inliers but much
//! smaller errors.
TEST(Usac_LogarithmicScore, prefersNoScaleOfTheNoise)
{
    std::vector<float> precise(100, 0.0004f), rough(100, 0.09f);
    for (int i = 0; i < 10; ++i)
        precise[i] = 2;  // outliers
    EXPECT_LT(scoreOf(precise, 1).cost, scoreOf(rough, 1).cost);
    Quality msac[2] = {Quality(0, 0), Quality(0, 0)};
    createMsacScore()->accumulate(precise.data(), 100, 1, msac[0]);
    createMsacScore()->accumulate(rough.data(), 100, 1, msac[1]);
    EXPECT_GT(msac[0].cost, msac[1].cost);
}

}  // namespace
}  // namespace opencv_test
