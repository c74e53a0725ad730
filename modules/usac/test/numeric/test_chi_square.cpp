// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/problem_objects.hpp"
#include "numeric/chi_square.hpp"

namespace opencv_test {
namespace {

TEST(Usac_Statistics, chiSquareKnownValues)
{
    EXPECT_NEAR(6.634896601021214, chiSquareQuantile(0.99, 1), 1e-12);
    EXPECT_NEAR(3.841458820694124, chiSquareQuantile(0.95, 1), 1e-12);
    EXPECT_NEAR(0.454936423119573, chiSquareQuantile(0.5, 1), 1e-12);
    EXPECT_NEAR(-2 * std::log(0.01), chiSquareQuantile(0.99, 2), 1e-12);
    EXPECT_NEAR(11.34486673014437, chiSquareQuantile(0.99, 3), 1e-11);
    EXPECT_NEAR(13.27670413598762, chiSquareQuantile(0.99, 4), 1e-11);
    EXPECT_NEAR(std::sqrt(6.634896601021214), thresholdInSigmas(1), 1e-12);
    EXPECT_NEAR(std::sqrt(-2 * std::log(0.01)), thresholdInSigmas(2), 1e-12);
    EXPECT_NEAR(std::sqrt(11.34486673014437), thresholdInSigmas(3), 1e-12);
    EXPECT_EQ(0, chiSquareQuantile(0, 3));
    for (int degrees = 1; degrees < 9; ++degrees)
        for (double p = 0.001; p < 1; p += 0.037)
            EXPECT_NEAR(p, chiSquareDistribution(chiSquareQuantile(p, degrees), degrees), 1e-12);
    EXPECT_THROW(chiSquareQuantile(1, 2), cv::Exception);
}

//! Satterthwaite's approximation: a weighted sum of two squared normal variables must be nearly
//! chi-squared with a fractional number of degrees of freedom.
TEST(Usac_Statistics, chiSquareOfDifferentVariances)
{
    RNG rng(1);
    const int COUNT = 100000;
    for (double ratio : {0.1, 0.3, 0.7})
    {
        const double a = 1 / (1 + ratio), b = ratio / (1 + ratio), degrees = 1 / (a * a + b * b);
        for (double p : {0.5, 0.8, 0.95})
        {
            const double limit = chiSquareQuantile(p, degrees) / degrees;
            int within = 0;
            for (int i = 0; i < COUNT; ++i)
            {
                const double u = rng.gaussian(1), v = rng.gaussian(1);
                within += a * u * u + b * v * v <= limit;
            }
            EXPECT_NEAR(p, within / (double)COUNT, 0.02) << ratio;
        }
    }
}

TEST(Usac_Statistics, chiSquareOfNonsense)
{
    EXPECT_THROW(chiSquareQuantile(-0.1, 1), cv::Exception);
    EXPECT_THROW(chiSquareQuantile(1, 1), cv::Exception);
    EXPECT_THROW(chiSquareQuantile(0.5, 0), cv::Exception);
    EXPECT_THROW(thresholdInSigmas(0), cv::Exception);
    EXPECT_THROW(thresholdInSigmas(4), cv::Exception);
}

}  // namespace
}  // namespace opencv_test
