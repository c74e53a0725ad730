// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/run_context.hpp"
#include "test_precomp.hpp"
#include "support/problem_objects.hpp"
#include "scoring/scores.hpp"
#include "numeric/chi_square.hpp"
#include "scoring/marginalized_weights.hpp"

namespace opencv_test {
namespace {

enum { SIDE = 300 };

//! Two points at opposite corners of a square of side SIDE in both images.
OwnPoints* spanning(ProblemType problem, double inlierThreshold)
{
    std::vector<Point2d> corners(1, Point2d(0, 0));
    corners.push_back(Point2d(SIDE, SIDE));
    return new OwnPoints(problem, corners, corners, inlierThreshold);
}

double costOf(const Score& score, double error, double inlierThreshold)
{
    float squared = (float)(error * error);
    Quality quality(0, 0);
    score.accumulate(&squared, 1, (float)(inlierThreshold * inlierThreshold), quality);
    return quality.cost;
}

/** The log-likelihood of a point, averaged over sigma in 0 .. sigma_max by the midpoint rule. If
the error is at most k sigma, the log-likelihood is that of an inlier with Gaussian noise in n
dimensions. Otherwise it is that of an outlier that is uniformly distributed in a square of side
SIDE (H, affine maps) or on a line segment of length SIDE (F, E). */
double meanLogLikelihood(double error, double sigmaMax, int degrees)
{
    const int STEPS = 20000;
    const double k = thresholdInSigmas(degrees);
    double sum = 0;
    for (int i = 0; i < STEPS; ++i)
    {
        const double sigma = sigmaMax * (i + 0.5) / STEPS;
        if (error <= k * sigma)
            sum += -degrees * std::log(std::sqrt(2 * CV_PI) * sigma) -
                   0.5 * error * error / (sigma * sigma);
        else
            sum += -degrees * std::log((double)SIDE);
    }
    return sum / STEPS;
}

typedef testing::TestWithParam<int> Usac_Magsac_Problem;

TEST_P(Usac_Magsac_Problem, magsacAgainstItsDefinition)
{
    const ProblemType problem = (ProblemType)GetParam();
    const int degrees = problemObject(problem).errorDimension();
    for (double inlierThreshold = 0.5; inlierThreshold < 9; inlierThreshold *= 4)
    {
        const double sigmaMax = inlierThreshold / thresholdInSigmas(degrees);
        const Ptr<OwnPoints> points(spanning(problem, inlierThreshold));
        const Ptr<Score> score = started(createMagsacScore(degrees, 1), points->view());
        EXPECT_FALSE(score->wholeModel());
        const double best = meanLogLikelihood(0, sigmaMax, degrees),
                     worst = meanLogLikelihood(1e9, sigmaMax, degrees);
        for (double u = 0; u < 1.2; u += 0.061)
        {
            const double expected = (best -
                                     meanLogLikelihood(u * inlierThreshold, sigmaMax, degrees)) /
                                    (best - worst);
            EXPECT_NEAR(expected, costOf(*score, u * inlierThreshold, inlierThreshold), 1e-3)
                << inlierThreshold << " " << u;
        }
    }
}

TEST_P(Usac_Magsac_Problem, magsacPlusPlusAgainstItsFormula)
{
    const ProblemType problem = (ProblemType)GetParam();
    const Ptr<Score> score = createMagsacPlusPlusScore(problemObject(problem).errorDimension(), 1);
    const MarginalizedWeights weights(problemObject(problem).errorDimension());
    EXPECT_FALSE(score->wholeModel());
    for (double u = 0; u < 1.2; u += 0.0123)
        EXPECT_NEAR(weights.loss(u * u), costOf(*score, 7 * u, 7), 1e-3) << u;
}

//! The cost must be 0 for an error of 0, 1 for an error of the threshold or more, and must not
//! decrease between these errors.
TEST_P(Usac_Magsac_Problem, bounds)
{
    const ProblemType problem = (ProblemType)GetParam();
    // the second threshold is larger than the extent of the points
    const double thresholds[] = {1, 1000};
    for (int t = 0; t < 2; ++t)
    {
        const Ptr<OwnPoints> points(spanning(problem, thresholds[t]));
        const Ptr<Score> scores[] = {
            started(createMagsacScore(problemObject(problem).errorDimension(), 1), points->view()),
            createMagsacPlusPlusScore(problemObject(problem).errorDimension(), 1)};
        for (int s = 0; s < 2; ++s)
        {
            EXPECT_EQ(0, costOf(*scores[s], 0, thresholds[t]));
            EXPECT_EQ(1, costOf(*scores[s], thresholds[t], thresholds[t]));
            EXPECT_EQ(1, costOf(*scores[s], 1e15, thresholds[t]));
            double last = 0;
            for (double u = 0.002; u < 1; u += 0.002)
            {
                const double cost = costOf(*scores[s], u * thresholds[t], thresholds[t]);
                ASSERT_GE(cost, last) << s << " " << u;
                ASSERT_LE(cost, 1);
                last = cost;
            }
            EXPECT_GT(last, 0.99);
        }
    }
}

TEST_P(Usac_Magsac_Problem, inliersAndUndefinedErrors)
{
    const ProblemType problem = (ProblemType)GetParam();
    const Ptr<OwnPoints> points(spanning(problem, 2));
    const Ptr<Score> scores[] = {
        started(createMagsacScore(problemObject(problem).errorDimension(), 1), points->view()),
        createMagsacPlusPlusScore(problemObject(problem).errorDimension(), 1)};
    for (int s = 0; s < 2; ++s)
    {
        float errors[] = {std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity(), 0, 4.f, std::nextafter(4.f, 5.f)};
        Quality quality(3, 2);  // accumulate() adds to these values
        scores[s]->accumulate(errors, 5, 4, quality);
        EXPECT_EQ(3 + 4, quality.cost);
        EXPECT_EQ(2 + 2, quality.inliers);
    }
}

//! Quality::inliers must count the inliers of the mask, that is, errors of at most 1, although the
//! cost uses a threshold of 2.
TEST_P(Usac_Magsac_Problem, inliersOfTheMask)
{
    const ProblemType problem = (ProblemType)GetParam();
    const Ptr<OwnPoints> points(spanning(problem, 2));
    const int degrees = problemObject(problem).errorDimension();
    const Ptr<Score> scores[] = {started(createMagsacScore(degrees, 2), points->view()),
                                 createMagsacPlusPlusScore(degrees, 2)};
    for (int s = 0; s < 2; ++s)
    {
        EXPECT_EQ(0.5, scores[s]->inlierPart());
        float errors[] = {0, 1.f, std::nextafter(1.f, 2.f), 3.9f, 4.1f};
        Quality quality(0, 0);
        scores[s]->accumulate(errors, 5, 4, quality);
        EXPECT_EQ(2, quality.inliers);
        EXPECT_GT(quality.cost, 1);
        EXPECT_LT(quality.cost, 4);
    }
}

INSTANTIATE_TEST_CASE_P(All, Usac_Magsac_Problem, testing::ValuesIn(TWO_VIEW_PROBLEMS));

}
}  // namespace
