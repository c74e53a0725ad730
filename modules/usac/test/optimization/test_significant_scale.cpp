// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "optimization/significant_scale.hpp"

namespace opencv_test {
namespace {

//! Draws squared errors. The errors of inliers have a standard deviation of 1 in each of `degrees`
//! directions. Those of outliers are uniform in a cube of side 400 with `degrees` dimensions.
std::vector<float> drawErrors(RNG& rng, int degrees, int inliers, int size)
{
    std::vector<float> errors;
    for (int i = 0; i < size; ++i)
    {
        const bool inlier = i * 7 % size < inliers;  // inliers are not consecutive
        const double x = inlier ? rng.gaussian(1) : rng.uniform(-200., 200.);
        const double y = inlier ? rng.gaussian(1) : rng.uniform(-200., 200.);
        const double z = degrees < 3 ? 0 : inlier ? rng.gaussian(1) : rng.uniform(-200., 200.);
        errors.push_back((float)(x * x + (degrees >= 2 ? y * y : 0) + z * z));
    }
    return errors;
}

//! Size of a minimal sample: for 2 degrees that of H, for 3 that of a 3-D motion, for 1 about that
//! of F.
int sampleSizeOf(int degrees) { return degrees == 3 ? 3 : 8 / degrees; }

double scaleOf(const std::vector<float>& errors, int degrees, double unit)
{
    const double part = unit / 400, chance = degrees == 3   ? 4 * CV_PI / 3 * part * part * part
                                             : degrees == 2 ? CV_PI * part * part
                                                            : 2 * part;
    return SignificantScale::estimate(errors.data(), (int)errors.size(), 0, 0, unit, chance,
                                      degrees, sampleSizeOf(degrees))
        .sigma;
}

//! The standard deviation must be estimated within 15 %, whatever the threshold `unit` is.
TEST(Usac_SignificantScale, isThatOfTheNoise)
{
    for (int degrees = 1; degrees <= 3; ++degrees)
        for (int part = 0; part < 3; ++part)
        {
            const int inliers = part == 0 ? 300 : part == 1 ? 500 : 1001;
            RNG rng(part + 1);
            const std::vector<float> errors = drawErrors(rng, degrees, inliers, 1001);
            for (double unit = 0.01; unit < 5; unit *= 3.1)
            {
                SCOPED_TRACE(cv::format("%d degrees, %d inliers, unit %g", degrees, inliers, unit));
                EXPECT_NEAR(1, scaleOf(errors, degrees, unit), 0.15);
            }
        }
}

//! A third of the errors form a narrow core with standard deviation 0.5. The others, with standard
//! deviation 9, agree with the model, too. The scale must be that of all errors, or that of the
//! core if no radius above the threshold is tried.
TEST(Usac_SignificantScale, ofTheCore)
{
    RNG rng(7);
    std::vector<float> errors;
    for (int i = 0; i < 1000; ++i)
    {
        const double sigma = i % 3 == 0 ? 0.5 : 9;
        const double x = rng.gaussian(sigma), y = rng.gaussian(sigma);
        errors.push_back((float)(x * x + y * y));
    }
    const double unit = 2, chance = CV_PI * unit * unit / (400. * 400);
    const SignificantScale::Found all = SignificantScale::estimate(errors.data(), 1000, 0, 0, unit,
                                                                   chance, 2, 4),
                                  core = SignificantScale::estimate(errors.data(), 1000, 0, 0, unit,
                                                                    chance, 2, 4, 1);
    EXPECT_GT(all.sigma, 2);
    EXPECT_GT(all.inliers, 900);
    EXPECT_NEAR(0.5, core.sigma, 0.1);
    EXPECT_GT(core.inliers, 300);
    EXPECT_LT(core.inliers, 400);
}

//! If a third of the inliers have ten times the noise of the others, the scale must be that of the
//! others.
TEST(Usac_SignificantScale, ofTwoSurfaces)
{
    for (int degrees = 2; degrees <= 3; ++degrees)
    {
        RNG rng(7);
        std::vector<float> errors = drawErrors(rng, degrees, 1000, 1000);
        for (int i = 0; i < 1000; i += 3)
            errors[i] *= 100;
        EXPECT_NEAR(1, scaleOf(errors, degrees, 0.1), 0.3);
    }
}

TEST(Usac_SignificantScale, noneOfRandomErrors)
{
    for (int degrees = 1; degrees <= 3; ++degrees)
        for (int seed = 1; seed < 20; ++seed)
        {
            RNG rng(seed);
            const std::vector<float> errors = drawErrors(rng, degrees, 0, 1001);
            EXPECT_EQ(0, scaleOf(errors, degrees, 0.1));
            const std::vector<float> sample(errors.begin(), errors.begin() + sampleSizeOf(degrees));
            EXPECT_EQ(0, scaleOf(sample, degrees, 0.1));
        }
    const std::vector<float> undefined(100, std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(0, scaleOf(undefined, 2, 0.1));
    EXPECT_EQ(0, SignificantScale::estimate(0, 0, 0, 0, 1, 0.1, 2, 4).sigma);
}

//! Clustered points are near many models. If random matches of the same points (whose errors are
//! the third argument of estimate()) have as many small errors as the given matches, the errors of
//! the model are no evidence, and the scale must be 0.
TEST(Usac_SignificantScale, noneOfWhatWrongMatchesHave)
{
    RNG rng(5);
    const std::vector<float> errors = drawErrors(rng, 2, 500, 1000),
                             same = drawErrors(rng, 2, 500, 1000),
                             few = drawErrors(rng, 2, 50, 1000);
    const double chance = CV_PI / (400. * 400);
    EXPECT_NEAR(1, SignificantScale::estimate(errors.data(), 1000, 0, 0, 1, chance, 2, 4).sigma,
                0.15);
    EXPECT_EQ(
        0,
        SignificantScale::estimate(errors.data(), 1000, same.data(), 1000, 1, chance, 2, 4).sigma);
    EXPECT_NEAR(
        1, SignificantScale::estimate(errors.data(), 1000, few.data(), 1000, 1, chance, 2, 4).sigma,
        0.15);
}

}  // namespace
}  // namespace opencv_test
