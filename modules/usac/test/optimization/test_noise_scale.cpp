// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "core/chi_square.hpp"
#include "optimization/noise_scale.hpp"

namespace opencv_test {
namespace {

//! Gaussian noise of known size among uniform outliers.
TEST(Usac_Statistics, noiseScale)
{
    for (int degrees = 1; degrees <= 2; ++degrees)
        for (int k = 0; k < 4; ++k)
        {
            const double sigma = 0.2 * (k + 1);  // in thresholds of 3 pixels
            RNG rng(1 + k);
            std::vector<float> errors;
            for (int i = 0; i < 400; ++i)
            {
                const double a = rng.gaussian(3 * sigma), b = degrees == 2 ? rng.gaussian(3 * sigma) : 0;
                const double far = rng.uniform(0., 1.), reach = 3 * NoiseScale::REACH;
                errors.push_back((float)(i % 4 ? a * a + b * b : reach * reach * (degrees == 2 ? far : far * far)));
            }
            EXPECT_NEAR(sigma, NoiseScale::estimate(errors.data(), 400, 3, degrees), 0.2 * sigma)
                << degrees << " " << sigma;
        }
    const std::vector<float> few(NoiseScale::LEAST - 1, 0.01f);
    EXPECT_EQ(1 / thresholdInSigmas(1), NoiseScale::estimate(few.data(), (int)few.size(), 1, 1));
    const std::vector<float> exact(100, 0.f), nothing(100, std::numeric_limits<float>::quiet_NaN());
    EXPECT_LT(NoiseScale::estimate(exact.data(), 100, 1, 1), 1e-2);
    EXPECT_EQ(1 / thresholdInSigmas(2), NoiseScale::estimate(nothing.data(), 100, 1, 2));
}

}
}  // namespace
