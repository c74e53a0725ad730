// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/run_context.hpp"
#include "test_precomp.hpp"
#include "support/problem_objects.hpp"
#include "scoring/scores.hpp"
#include "numeric/chi_square.hpp"
#include "scoring/mixture.hpp"

namespace opencv_test {
namespace {

//! Two points, in both images at opposite corners of a square with sides of length `side`.
OwnPoints* spanning(ProblemType problem, double side, double inlierThreshold)
{
    std::vector<Point2d> corners(1, Point2d(0, 0));
    corners.push_back(Point2d(side, side));
    return new OwnPoints(problem, corners, corners, inlierThreshold);
}

//! Squared errors. The fraction `part` of them belongs to inliers with sigma = 1; the others are
//! uniform on a line segment (one degree of freedom) or in a square of the given side.
std::vector<float> drawErrors(int degrees, int count, double part, double side, RNG& rng)
{
    std::vector<float> errors;
    for (int i = 0; i < count; ++i)
    {
        double error = 0;
        for (int k = 0; k < degrees; ++k)
        {
            const double e = i < part * count ? rng.gaussian(1) : rng.uniform(-side / 2, side / 2);
            error += e * e;
        }
        errors.push_back((float)error);
    }
    return errors;
}

//! Negative log-likelihood of the mixture with the inlier ratio gamma, scaled so that a point with
//! an error of 0 contributes 0 if gamma is 1, and any point contributes 1 if gamma is 0.
double directCost(const std::vector<float>& errors, int degrees, double side, double gamma)
{
    const double inlier = std::pow(2 * CV_PI, -0.5 * degrees), outlier = std::pow(side, -degrees);
    double cost = 0;
    for (size_t i = 0; i < errors.size(); ++i)
        cost += (std::log(inlier) -
                 std::log(gamma * inlier * std::exp(-0.5 * errors[i]) + (1 - gamma) * outlier)) /
                (std::log(inlier) - std::log(outlier));
    return cost;
}

//! If all points have the same likelihood ratio r of inlier to outlier, each iteration multiplies
//! the odds w / (1 - w) of the mixing weight w by r, beginning with odds of 1. The result must be
//! that of the last of 50 iterations.
TEST(Usac_Mlesac, mixingWeightOfPoorDistinction)
{
    const std::vector<float> ratios(100, 1.01f);
    const double odds = std::pow((double)ratios[0], 50);
    EXPECT_NEAR(odds / (1 + odds), mixingWeight(ratios.data(), 100, 100), 1e-12);
}

typedef testing::TestWithParam<int> Usac_Mlesac_Problem;

//! The cost must be that of the best mixing weight, which the test finds on a grid.
TEST_P(Usac_Mlesac_Problem, costAgainstGrid)
{
    const ProblemType problem = (ProblemType)GetParam();
    const int degrees = problemObject(problem).errorDimension();
    const double side = 300, k = thresholdInSigmas(degrees);
    const Ptr<OwnPoints> points(spanning(problem, side, k));
    const Ptr<Score> score = started(createMlesacScore(), points->view());
    EXPECT_TRUE(score->wholeModel());
    RNG rng(5);
    for (int trial = 0; trial < 5; ++trial)
    {
        std::vector<float> errors = drawErrors(degrees, 400, 0.2 * trial, side, rng);
        double least = DBL_MAX;
        for (int i = 0; i <= 1000; ++i)
            least = std::min(least, directCost(errors, degrees, side, 0.001 * i));
        int inliers = 0;
        for (size_t i = 0; i < errors.size(); ++i)
            inliers += errors[i] <= k * k;
        Quality quality(0, 0);
        score->accumulate(errors.data(), (int)errors.size(), (float)(k * k), quality);
        EXPECT_NEAR(least, quality.cost, 0.01) << trial;
        EXPECT_NEAR(inliers, quality.inliers, 1);
    }
}

TEST_P(Usac_Mlesac_Problem, bounds)
{
    const ProblemType problem = (ProblemType)GetParam();
    const Ptr<OwnPoints> points(spanning(problem, 300, 1));
    const Ptr<Score> score = started(createMlesacScore(), points->view());
    std::vector<float> perfect(50, 0.f), far(50, 1e6f),
        undefined(50, std::numeric_limits<float>::quiet_NaN());
    far[7] = std::numeric_limits<float>::infinity();
    Quality none(0, 0), all(0, 0), nan(0, 0), empty(0, 0);
    score->accumulate(perfect.data(), 50, 1, all);
    score->accumulate(far.data(), 50, 1, none);
    score->accumulate(undefined.data(), 50, 1, nan);
    score->accumulate(perfect.data(), 0, 1, empty);
    EXPECT_NEAR(0, all.cost, 1e-4);
    EXPECT_EQ(50, all.inliers);
    EXPECT_NEAR(50, none.cost, 1e-9);
    EXPECT_EQ(0, none.inliers);
    EXPECT_NEAR(50, nan.cost, 1e-9);
    EXPECT_EQ(0, empty.cost);
}

//! If all points coincide, there is no area for outliers. The cost of 20 points must nevertheless
//! be between 0 and 20.
TEST_P(Usac_Mlesac_Problem, noExtent)
{
    const Ptr<OwnPoints> points(spanning((ProblemType)GetParam(), 0, 1));
    const Ptr<Score> score = started(createMlesacScore(), points->view());
    for (float error = 0; error < 4; error += 0.1f)
    {
        std::vector<float> errors(20, error);
        Quality quality(0, 0);
        score->accumulate(errors.data(), 20, 1, quality);
        EXPECT_GE(quality.cost, 0);
        EXPECT_LE(quality.cost, 20);
    }
}

INSTANTIATE_TEST_CASE_P(All, Usac_Mlesac_Problem, testing::ValuesIn(TWO_VIEW_PROBLEMS));

}
}  // namespace
