// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_contracts.hpp"
#include "statistics/significant_scale.hpp"

namespace opencv_test {
namespace {

//! Errors of inliers with a standard deviation of 1 in each of `degrees` directions, others anywhere in a square of 400
//! by 400.
std::vector<float> drawErrors(RNG& rng, int degrees, int inliers, int size)
{
    std::vector<float> errors;
    for (int i = 0; i < size; ++i)
    {
        const bool inlier = i * 7 % size < inliers;  // in any order
        const double x = inlier ? rng.gaussian(1) : rng.uniform(-200., 200.);
        const double y = inlier ? rng.gaussian(1) : rng.uniform(-200., 200.);
        errors.push_back((float)(x * x + (degrees == 2 ? y * y : 0)));
    }
    return errors;
}

double scaleOf(const std::vector<float>& errors, int degrees, double unit)
{
    const double chance = degrees == 2 ? CV_PI * unit * unit / (400. * 400) : 2 * unit / 400;
    return SignificantScale::estimate(errors.data(), (int)errors.size(), unit, chance, degrees, 8 / degrees);
}

//! Within 15 % of the noise, by whatever threshold, and the same within the width of a bin.
TEST(Usac_SignificantScale, isThatOfTheNoise)
{
    for (int degrees = 1; degrees <= 2; ++degrees)
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

//! That of the narrow half, if there are two.
TEST(Usac_SignificantScale, ofTwoPlanes)
{
    RNG rng(7);
    std::vector<float> errors = drawErrors(rng, 2, 1000, 1000);
    for (int i = 0; i < 1000; i += 3)
        errors[i] *= 100;
    EXPECT_NEAR(1, scaleOf(errors, 2, 0.1), 0.3);
}

TEST(Usac_SignificantScale, noneOfRandomErrors)
{
    for (int degrees = 1; degrees <= 2; ++degrees)
        for (int seed = 1; seed < 20; ++seed)
        {
            RNG rng(seed);
            const std::vector<float> errors = drawErrors(rng, degrees, 0, 1001);
            EXPECT_EQ(0, scaleOf(errors, degrees, 0.1));
            EXPECT_EQ(0, scaleOf(std::vector<float>(errors.begin(), errors.begin() + 8 / degrees), degrees, 0.1));
        }
    const std::vector<float> undefined(100, std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(0, scaleOf(undefined, 2, 0.1));
    EXPECT_EQ(0, SignificantScale::estimate(0, 0, 1, 0.1, 2, 4));
}

typedef testing::TestWithParam<int> Usac_WidestReach;
INSTANTIATE_TEST_CASE_P(/**/, Usac_WidestReach, testing::Values((int)HOMOGRAPHY, (int)FUNDAMENTAL, (int)ESSENTIAL));

//! Of some scenes; the mask is checked, too.
double meanError(int problem, Params params, double pixels)
{
    enum { SCENES = 6 };
    params.threshold = pixels;
    double sum = 0;
    for (int seed = 1; seed <= SCENES; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        const Scene scene = makeScene((ProblemType)problem, options);
        Report report;
        Mat mask;
        const Mat model = estimate(scene, params, mask, &report);
        EXPECT_EQ(pixels, report.threshold);
        if (!model.empty())
            checkResult(scene, pixels, model, mask, report, params.widestReach);
        sum += modelError(scene, model) / SCENES;
    }
    return sum;
}

//! A noise of 0.5 pixels: a threshold of a hundredth to a half is as good as one of three times that.
TEST_P(Usac_WidestReach, thresholdsBelowTheNoise)
{
    const double usual = meanError(GetParam(), Params::magsacPlusPlus(), 1.5);
    const double thresholds[] = {0.005, 0.05, 0.3, 0.6};
    for (int i = 0; i < 4; ++i)
        EXPECT_LT(meanError(GetParam(), Params::magsacPlusPlus(), thresholds[i]), 1.3 * usual) << thresholds[i];
    EXPECT_LT(meanError(GetParam(), Params::magsac(), 0.1), 1.3 * usual);
    Params narrow = Params::magsacPlusPlus();
    narrow.widestReach = 1;
    EXPECT_GT(meanError(GetParam(), narrow, 0.1), 2 * usual);
    narrow.widestReach = 5;  // half of the noise's
    const double between = meanError(GetParam(), narrow, 0.1);
    EXPECT_GT(between, 1.1 * usual);
}

//! Where no more noise is found than the threshold allows for, nothing changes; and it does not depend on the threads
//! where it is.
TEST_P(Usac_WidestReach, bits)
{
    const Scene scene = makeScene((ProblemType)GetParam());
    for (int below = 0; below < 2; ++below)
    {
        Params params = Params::magsacPlusPlus();
        params.threshold = below ? 0.1 : 2;
        Mat masks[3], models[3];
        for (int i = 0; i < 3; ++i)
        {
            params.threads = i == 1 ? 3 : 1;
            params.widestReach = i == 2 ? 1 : 1000;
            models[i] = estimate(scene, params, masks[i]);
        }
        EXPECT_TRUE(sameBits(models[0], models[1]));
        EXPECT_TRUE(sameBits(masks[0], masks[1]));
        EXPECT_EQ(below == 0, sameBits(models[0], models[2]));
    }
}

//! Coordinates and threshold in another unit give the same inliers and errors in that unit.
TEST_P(Usac_WidestReach, unit)
{
    if (GetParam() == ESSENTIAL)  // its unit is the focal length
        return;
    const Scene scene = makeScene((ProblemType)GetParam());
    Mat masks[2];
    for (int i = 0; i < 2; ++i)
    {
        const double unit = i ? 64 : 1;
        std::vector<Point2d> points1, points2;
        for (int k = 0; k < scene.size(); ++k)
        {
            points1.push_back(scene.points1[k] * unit);
            points2.push_back(scene.points2[k] * unit);
        }
        Params params = Params::magsacPlusPlus();
        params.threshold = 0.1 * unit;
        Report report;
        EXPECT_FALSE(estimatePoints(scene.problem, points1, points2, params, masks[i], report).empty());
    }
    EXPECT_TRUE(sameBits(masks[0], masks[1]));
}

//! A model that is right may have no inliers at all.
TEST(Usac_WidestReach_Mask, mayBeEmpty)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    Params params = Params::magsacPlusPlus();
    params.threshold = 1e-4;
    params.widestReach = 1e6;
    Mat mask;
    Report report;
    const Mat model = estimate(scene, params, mask, &report);
    EXPECT_LT(modelError(scene, model), 0.3);
    EXPECT_EQ(scene.size(), (int)mask.total());
    EXPECT_EQ(0, countNonZero(mask));
    EXPECT_EQ(0, report.inliers);
    EXPECT_NE((int)STOP_NO_MODEL, report.stop);
}

}
}  // namespace
