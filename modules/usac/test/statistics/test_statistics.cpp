// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problem_objects.hpp"
#include "residuals/residuals.hpp"
#include "statistics/chi_square.hpp"
#include "statistics/gamma.hpp"
#include "statistics/marginalized_weights.hpp"
#include "statistics/mixture.hpp"
#include "statistics/noise_scale.hpp"

namespace opencv_test {
namespace {

//! Simpson's rule.
template <class F>
double integrate(const F& f, double from, double to, int steps)
{
    const double h = (to - from) / (2 * steps);
    double sum = f(from) + f(to);
    for (int i = 1; i < 2 * steps; ++i)
        sum += (i % 2 ? 4 : 2) * f(from + i * h);
    return sum * h / 3;
}

//! The integrand of the gamma functions, with t = s^2: smooth at 0 for a >= 1/2.
struct GammaIntegrand
{
    double a;
    double operator()(double s) const { return 2 * std::pow(s, 2 * a - 1) * std::exp(-s * s); }
};

//! With t = exp(s): for a = 0.
struct ExponentialIntegrand
{
    double operator()(double s) const { return std::exp(-std::exp(s)); }
};

TEST(Usac_Statistics, gammaAgainstIntegration)
{
    const double shapes[] = {0.5, 1, 1.5, 2, 3.5};
    for (int k = 0; k < 5; ++k)
        for (double x = 0.01; x < 30; x *= 1.4)
        {
            const GammaIntegrand f = {shapes[k]};
            EXPECT_NEAR(integrate(f, 0, std::sqrt(x), 2000), lowerGamma(shapes[k], x), 1e-10) << shapes[k] << " " << x;
            EXPECT_NEAR(integrate(f, std::sqrt(x), 8, 2000), upperGamma(shapes[k], x), 1e-10) << shapes[k] << " " << x;
        }
    for (double x = 1e-6; x < 30; x *= 1.4)
        EXPECT_NEAR(integrate(ExponentialIntegrand(), std::log(x), std::log(50.), 4000), upperGamma(0, x), 1e-9) << x;
}

TEST(Usac_Statistics, gammaKnownValues)
{
    EXPECT_NEAR(0.219383934395520, upperGamma(0, 1), 1e-14);
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

TEST(Usac_Statistics, chiSquareKnownValues)
{
    EXPECT_NEAR(6.634896601021214, chiSquareQuantile(0.99, 1), 1e-12);
    EXPECT_NEAR(3.841458820694124, chiSquareQuantile(0.95, 1), 1e-12);
    EXPECT_NEAR(0.454936423119573, chiSquareQuantile(0.5, 1), 1e-12);
    EXPECT_NEAR(-2 * std::log(0.01), chiSquareQuantile(0.99, 2), 1e-12);
    EXPECT_NEAR(13.27670413598762, chiSquareQuantile(0.99, 4), 1e-11);
    EXPECT_NEAR(std::sqrt(6.634896601021214), thresholdInSigmas(1), 1e-12);
    EXPECT_NEAR(std::sqrt(-2 * std::log(0.01)), thresholdInSigmas(2), 1e-12);
    EXPECT_EQ(0, chiSquareQuantile(0, 3));
    for (int degrees = 1; degrees < 9; ++degrees)
        for (double p = 0.001; p < 1; p += 0.037)
            EXPECT_NEAR(p, chiSquareDistribution(chiSquareQuantile(p, degrees), degrees), 1e-12);
    EXPECT_THROW(chiSquareQuantile(1, 2), cv::Exception);
}

double squaredDistance(const Matx33d& H, const Point2d& a, const Point2d& b)
{
    const Vec3d y = H * Vec3d(a.x, a.y, 1);
    return (y[0] / y[2] - b.x) * (y[0] / y[2] - b.x) + (y[1] / y[2] - b.y) * (y[1] / y[2] - b.y);
}

//! Sampson's or the symmetric epipolar distance, squared.
double squaredEpipolar(const Matx33d& F, const Point2d& a, const Point2d& b, bool symmetric)
{
    const Vec3d l2 = F * Vec3d(a.x, a.y, 1), l1 = F.t() * Vec3d(b.x, b.y, 1);
    const double N = b.x * l2[0] + b.y * l2[1] + l2[2];
    const double n1 = l1[0] * l1[0] + l1[1] * l1[1], n2 = l2[0] * l2[0] + l2[1] * l2[1];
    return symmetric ? N * N * (1 / n1 + 1 / n2) : N * N / (n1 + n2);
}

//! Squared errors of one exact match with `count` draws of noise in all four coordinates.
std::vector<double> noisyErrors(const Scene& scene, const Matx33d& inverse, int row, bool symmetric, int count,
                                RNG& rng)
{
    std::vector<double> errors(count);
    for (int i = 0; i < count; ++i)
    {
        const Point2d a = scene.clean1[row] + Point2d(rng.gaussian(0.5), rng.gaussian(0.5));
        const Point2d b = scene.clean2[row] + Point2d(rng.gaussian(0.5), rng.gaussian(0.5));
        if (scene.problem == HOMOGRAPHY)
            errors[i] = squaredDistance(scene.model, a, b) + (symmetric ? squaredDistance(inverse, b, a) : 0);
        else
            errors[i] = squaredEpipolar(scene.F, a, b, symmetric);
    }
    std::sort(errors.begin(), errors.end());
    return errors;
}

/** The choice of the degrees of freedom: the quantiles of the errors are those of chi-square, up to the scale. The
ratio of the 0.9 to the 0.3 quantile is 18.2 for one degree, 6.5 for two, 4.4 for three and 3.5 for four. */
TEST(Usac_Statistics, degreesOfFreedomOfTheErrors)
{
    const ProblemType problems[] = {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL};
    for (int k = 0; k < 6; ++k)
    {
        SceneOptions options;
        options.outliers = 0;
        const Scene scene = makeScene(problems[k / 2], options);
        const Matx33d inverse = problems[k / 2] == HOMOGRAPHY ? scene.model.inv() : Matx33d::eye();
        const int degrees = problemObject(problems[k / 2]).errorDimension(), COUNT = 20000;
        EXPECT_EQ(k < 2 ? 2 : 1, degrees);
        RNG rng(k + 1);
        double ratio = 0;
        for (int row = 0; row < 3; ++row)
        {
            const std::vector<double> errors = noisyErrors(scene, inverse, row, k % 2 == 1, COUNT, rng);
            ratio += errors[COUNT * 9 / 10] / errors[COUNT * 3 / 10] / 3;
        }
        const double expected = chiSquareQuantile(0.9, degrees) / chiSquareQuantile(0.3, degrees);
        EXPECT_NEAR(expected, ratio, 0.06 * expected) << "problem " << k / 2 << " symmetric " << k % 2;
    }
}

//! The scale of Sampson's distance is that of the noise in each coordinate: 99 in 100 inliers lie within k sigma.
TEST(Usac_Statistics, thresholdKeepsInliers)
{
    SceneOptions options;
    options.inliers = 20000;
    options.outliers = 0;
    const Scene scene = makeScene(FUNDAMENTAL, options);
    const double limit = options.noise * thresholdInSigmas(1);
    int within = 0;
    for (int i = 0; i < scene.size(); ++i)
        within += squaredEpipolar(scene.F, scene.points1[i], scene.points2[i], false) <= limit * limit;
    EXPECT_NEAR(0.99, within / 20000., 0.003);
}

//! sigma^-n r^(n-1) exp(-r^2 / (2 sigma^2)), the density of the error up to a factor, with sigma = exp(s).
struct Density
{
    int degrees;
    double r;
    double operator()(double s) const
    {
        const double sigma = std::exp(s);
        return sigma * std::pow(sigma, -degrees) * std::pow(r, degrees - 1) * std::exp(-r * r / (2 * sigma * sigma));
    }
};

//! The weight by its definition, sigma_max being 1.
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
    for (int degrees = 1; degrees <= 2; ++degrees)
    {
        const MarginalizedWeights weights(degrees);
        const double k = thresholdInSigmas(degrees);
        const WeightedError f = {degrees};
        const double atEnd = integrate(f, 1e-9, k, 200);
        for (double u = 0.0025; u < 1; u += 0.095)
        {
            const double r = k * std::sqrt(u);
            EXPECT_NEAR(integrate(f, 1e-9, r, 200) / atEnd, weights.loss(u), 2e-5) << degrees << " " << u;
            // the derivative by u = (r/k)^2 of the integral of r w(r)
            const double weight = 0.5 * k * k * marginalDensity(degrees, r) / atEnd;
            EXPECT_NEAR(weight, weights.weight(u), 1e-4 * (1 + weight)) << degrees << " " << u;
        }
    }
}

TEST(Usac_Statistics, marginalizedWeightsTables)
{
    const float infinite = std::numeric_limits<float>::infinity(), undefined = std::numeric_limits<float>::quiet_NaN();
    for (int degrees = 1; degrees <= 2; ++degrees)
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
    EXPECT_EQ(&MarginalizedWeights::of(problemObject(FUNDAMENTAL).errorDimension()),
              &MarginalizedWeights::of(problemObject(ESSENTIAL).errorDimension()));
    EXPECT_NE(&MarginalizedWeights::of(problemObject(FUNDAMENTAL).errorDimension()),
              &MarginalizedWeights::of(problemObject(HOMOGRAPHY).errorDimension()));
}

//! Points are as dense as their extent says, H: in image 2, F: on the mean over both images.
TEST(Usac_Statistics, outlierExtent)
{
    std::vector<Point2d> points1, points2;
    for (int i = 0; i < 2; ++i)
    {
        points1.push_back(Point2d(10 * i, 40 * i));
        points2.push_back(Point2d(5 + 100 * i, -400 * i));
    }
    const OwnPoints H(HOMOGRAPHY, points1, points2), F(FUNDAMENTAL, points1, points2);
    EXPECT_NEAR(200, H.view().problem->outlierExtent(H.view()), 1e-6);
    EXPECT_NEAR(std::sqrt(20. * 200.), F.view().problem->outlierExtent(F.view()), 1e-6);
    const OwnPoints line(HOMOGRAPHY, points1, std::vector<Point2d>(2));
    EXPECT_EQ(0, line.view().problem->outlierExtent(line.view()));
    EXPECT_NEAR(std::log(200 / (std::sqrt(2 * CV_PI) * 0.5)), logDensityRatio(200, 0.5, 2), 1e-12);
    for (int degrees = 1; degrees <= 2; ++degrees)  // equally likely at the threshold
    {
        const double k = thresholdInSigmas(degrees);
        EXPECT_NEAR(1, std::exp(degrees * logDensityRatio(0, 0.5, degrees) - k * k / 2), 1e-12);
    }
}

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

TEST(Usac_Statistics, chiSquareOfNonsense)
{
    EXPECT_THROW(chiSquareQuantile(-0.1, 1), cv::Exception);
    EXPECT_THROW(chiSquareQuantile(1, 1), cv::Exception);
    EXPECT_THROW(chiSquareQuantile(0.5, 0), cv::Exception);
    EXPECT_THROW(thresholdInSigmas(0), cv::Exception);
    EXPECT_THROW(thresholdInSigmas(3), cv::Exception);
}

}
}  // namespace
