// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/integrate.hpp"
#include "numeric/gamma.hpp"

namespace opencv_test {
namespace {

//! The integrand of the gamma functions after the substitution t = s^2, finite at 0 for a >= 1/2
//! and smooth enough there for the tested shapes.
struct GammaIntegrand
{
    double a;
    double operator()(double s) const { return 2 * std::pow(s, 2 * a - 1) * std::exp(-s * s); }
};

//! The integrand for a = 0 after the substitution t = exp(s).
struct ExponentialIntegrand
{
    double operator()(double s) const { return std::exp(-std::exp(s)); }
};

TEST(Usac_Statistics, gammaAgainstIntegration)
{
    const double shapes[] = {0.5, 1, 1.5, 2, 2.25, 3.5};
    for (int k = 0; k < 6; ++k)
        for (double x = 0.01; x < 30; x *= 1.4)
        {
            const GammaIntegrand f = {shapes[k]};
            EXPECT_NEAR(integrate(f, 0, std::sqrt(x), 2000), lowerGamma(shapes[k], x), 1e-10)
                << shapes[k] << " " << x;
            EXPECT_NEAR(integrate(f, std::sqrt(x), 8, 2000), upperGamma(shapes[k], x), 1e-10)
                << shapes[k] << " " << x;
        }
    for (double x = 1e-6; x < 30; x *= 1.4)
        EXPECT_NEAR(integrate(ExponentialIntegrand(), std::log(x), std::log(50.), 4000),
                    upperGamma(0, x), 1e-9)
            << x;
}

TEST(Usac_Statistics, gammaKnownValues)
{
    EXPECT_NEAR(0.219383934395520, upperGamma(0, 1), 1e-14);
    for (double a = 0.25; a <= 10; a += 0.25)
        EXPECT_NEAR(1, gammaFunction(a) / std::tgamma(a), 1e-14) << a;
    for (double wrong : {0., -1.5})
        EXPECT_THROW(gammaFunction(wrong), cv::Exception);
    EXPECT_NEAR(1.822923958419391, upperGamma(0, 0.1), 1e-14);
    EXPECT_EQ(0, lowerGamma(1, 0));
    EXPECT_EQ(1, upperGamma(1, 0));
    EXPECT_EQ(std::numeric_limits<double>::infinity(), upperGamma(0, 0));
    for (double x = 0.05; x < 20; x += 0.05)
    {
        EXPECT_NEAR(1 - std::exp(-x), lowerGamma(1, x), 1e-14);
        EXPECT_NEAR(std::sqrt(CV_PI) * std::erfc(std::sqrt(x)), upperGamma(0.5, x), 1e-14);
        EXPECT_NEAR(std::sqrt(CV_PI) * std::erf(std::sqrt(x)), lowerGamma(0.5, x), 1e-14);
    }
}

}  // namespace
}  // namespace opencv_test
