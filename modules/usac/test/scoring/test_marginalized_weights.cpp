// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/integrate.hpp"
#include "support/problem_objects.hpp"
#include "numeric/chi_square.hpp"
#include "scoring/marginalized_weights.hpp"

namespace opencv_test {
namespace {

//! The density of the error up to a factor, sigma^-n r^(n-1) exp(-r^2 / (2 sigma^2)), times sigma
//! for the substitution sigma = exp(s).
struct Density
{
    int degrees;
    double r;
    double operator()(double s) const
    {
        const double sigma = std::exp(s);
        return sigma * std::pow(sigma, -degrees) * std::pow(r, degrees - 1) *
               std::exp(-r * r / (2 * sigma * sigma));
    }
};

//! The marginalized weight by its definition, for sigma_max = 1.
double marginalDensity(int degrees, double r)
{
    const Density f = {degrees, r};
    return integrate(f, std::log(r / thresholdInSigmas(degrees)), 0, 50);
}

struct WeightedError
{
    int degrees;
    double operator()(double r) const { return r * marginalDensity(degrees, r); }
};

TEST(Usac_Statistics, marginalizedWeightsAgainstIntegration)
{
    for (int degrees = 1; degrees <= 3; ++degrees)
    {
        const MarginalizedWeights weights(degrees);
        const double k = thresholdInSigmas(degrees);
        const WeightedError f = {degrees};
        const double atEnd = integrate(f, 1e-9, k, 200);
        for (double u = 0.0025; u < 1; u += 0.095)
        {
            const double r = k * std::sqrt(u);
            EXPECT_NEAR(integrate(f, 1e-9, r, 200) / atEnd, weights.loss(u), 2e-5)
                << degrees << " " << u;
            // the derivative of the integral of r w(r) with respect to u = (r/k)^2
            const double weight = 0.5 * k * k * marginalDensity(degrees, r) / atEnd;
            EXPECT_NEAR(weight, weights.weight(u), 1e-4 * (1 + weight)) << degrees << " " << u;
        }
    }
}

TEST(Usac_Statistics, marginalizedWeightsTables)
{
    const float infinite = std::numeric_limits<float>::infinity(),
                undefined = std::numeric_limits<float>::quiet_NaN();
    for (int degrees = 1; degrees <= 3; ++degrees)
    {
        const MarginalizedWeights weights(degrees);
        EXPECT_EQ(0.f, weights.tabulatedLoss(0));
        const float outside[] = {1.f, 1.5f, infinite, undefined};
        for (int i = 0; i < 4; ++i)
        {
            EXPECT_EQ(1.f, weights.tabulatedLoss(outside[i])) << outside[i];
            EXPECT_EQ(0.f, weights.tabulatedWeight(outside[i])) << outside[i];
        }
        float lastLoss = 0, lastWeight = FLT_MAX;
        for (float u = 0; u < 1; u += 0.0001f)
        {
            const float loss = weights.tabulatedLoss(u), weight = weights.tabulatedWeight(u);
            EXPECT_NEAR(weights.loss(u), loss, 1e-3) << u;
            EXPECT_NEAR(weights.weight(u), weight, 1e-3 * weights.weight(u) + 1e-6) << u;
            ASSERT_GE(loss, lastLoss);
            ASSERT_LE(weight, lastWeight);
            lastLoss = loss;
            lastWeight = weight;
        }
    }
    // the shared tables must equal new tables for the same number of degrees of freedom
    for (int degrees = 1; degrees <= 3; ++degrees)
        EXPECT_EQ(MarginalizedWeights(degrees).tabulatedLoss(0.3f),
                  MarginalizedWeights::of(degrees).tabulatedLoss(0.3f));
    EXPECT_EQ(&MarginalizedWeights::of(problemObject(FUNDAMENTAL).errorDimension()),
              &MarginalizedWeights::of(problemObject(ESSENTIAL).errorDimension()));
    EXPECT_NE(&MarginalizedWeights::of(problemObject(FUNDAMENTAL).errorDimension()),
              &MarginalizedWeights::of(problemObject(HOMOGRAPHY).errorDimension()));
}

}
}  // namespace
