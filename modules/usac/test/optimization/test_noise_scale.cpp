// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "numeric/chi_square.hpp"
#include "optimization/noise_scale.hpp"

namespace opencv_test {
namespace {

//! The standard deviation of Gaussian noise among uniform outliers must be estimated within 20 %.
//! With fewer than NoiseScale::LEAST errors other than NaN, the result must be the standard
//! deviation for which the threshold is the 0.99 quantile of the errors.
TEST(Usac_Statistics, noiseScale)
{
    for (int degrees = 1; degrees <= 3; ++degrees)
        for (int k = 0; k < 4; ++k)
        {
            const double sigma = 0.2 * (k + 1);  // in units of the threshold, which is 3 pixels
            RNG rng(1 + k);
            std::vector<float> errors;
            for (int i = 0; i < 400; ++i)
            {
                double square = 0;
                for (int axis = 0; axis < degrees; ++axis)
                {
                    const double a = rng.gaussian(3 * sigma);
                    square += a * a;
                }
                const double far = 3 * NoiseScale::REACH *
                                   std::pow(rng.uniform(0., 1.), 1. / degrees);
                errors.push_back((float)(i % 4 ? square : far * far));
            }
            EXPECT_NEAR(sigma, NoiseScale::estimate(errors.data(), 400, 3, degrees), 0.2 * sigma)
                << degrees << " " << sigma;
        }
    const std::vector<float> few(NoiseScale::LEAST - 1, 0.01f);
    EXPECT_EQ(1 / thresholdInSigmas(1), NoiseScale::estimate(few.data(), (int)few.size(), 1, 1));
    const std::vector<float> exact(100, 0.f), nothing(100, std::numeric_limits<float>::quiet_NaN());
    EXPECT_LT(NoiseScale::estimate(exact.data(), 100, 1, 1), 1e-2);
    for (int degrees = 2; degrees <= 3; ++degrees)
        EXPECT_EQ(1 / thresholdInSigmas(degrees),
                  NoiseScale::estimate(nothing.data(), 100, 1, degrees));
}

//! A standard deviation sigma below NoiseScale::leastSigma() must be returned only if there are
//! hardly more errors between 4 sigma and the threshold than outliers explain.
TEST(Usac_Statistics, noiseScaleNeedsEvidence)
{
    for (int degrees = 1; degrees <= 3; ++degrees)
        for (int tail = 0; tail < 2; ++tail)
        {
            RNG rng(5);
            std::vector<float> errors;
            for (int i = 0; i < 200; ++i)
            {
                double square = 0;
                for (int axis = 0; axis < degrees; ++axis)
                {
                    const double a = rng.gaussian(0.05);
                    square += a * a;
                }
                const double within = rng.uniform(0.4, 1.),
                             far = (int)NoiseScale::REACH *
                                   std::pow(rng.uniform(0., 1.), 1. / degrees);
                errors.push_back((float)(i % 8 ? square : tail ? within * within : far * far));
            }
            const double sigma = NoiseScale::estimate(errors.data(), 200, 1, degrees);
            if (tail)
            {
                EXPECT_GE(sigma, NoiseScale::leastSigma()) << degrees;
            }
            else
            {
                EXPECT_NEAR(0.05, sigma, 0.02) << degrees;
            }
        }
}

}  // namespace
}  // namespace opencv_test
