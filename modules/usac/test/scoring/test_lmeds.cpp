// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/run_context.hpp"
#include "test_precomp.hpp"
#include "support/problem_objects.hpp"
#include "support/given_residual.hpp"
#include "scoring/scores.hpp"

namespace opencv_test {
namespace {

//! The simplest search, which does not depend on the threshold.
Params searchParams()
{
    Params params;
    params.quality = QUALITY_LMEDS;
    params.sampler = SAMPLER_UNIFORM;
    params.verification = VERIFICATION_NONE;
    params.localOptimization = LOCAL_OPTIMIZATION_NONE;
    params.termination = TERMINATION_STANDARD;
    params.degeneracy = DEGENERACY_ORIENTATION;
    params.polishing = POLISHING_NONE;
    return params;
}

typedef testing::TestWithParam<int> Usac_Lmeds_Problem;

TEST_P(Usac_Lmeds_Problem, medianAndThreshold)
{
    const ProblemType problem = (ProblemType)GetParam();
    const int m = sampleSizeOf(problem);
    // For n matches and samples of m matches, the threshold is q c (1 + 5 / (n - m)) times the
    // median error, with q = 2.5 and c = 1.4826 for F and E. For maps, the errors are lengths of
    // Gaussian vectors in the plane; their p-quantile is sqrt(-2 log(1 - p)) sigma. Then q sigma is
    // the quantile for the fraction of errors that 2.5 sigma includes for F and E, and sigma / c is
    // the median.
    const double outside = std::erfc(2.5 / std::sqrt(2.));
    const double constant = mapsPoints(problem) ? std::sqrt(std::log(outside) / std::log(0.5))
                                                : 2.5 * 1.482602;
    const double side = 100;
    RNG rng(11);
    for (int count = 2; count < 200; count += 7)
    {
        std::vector<Point2d> corners(count, Point2d(0, 0));
        corners.back() = Point2d(side, side);
        const OwnPoints points(problem, corners, corners);
        const Ptr<Score> score = started(createLmedsScore(), points.view());
        EXPECT_TRUE(score->wholeModel());
        Components parts;
        const Ptr<GivenResidual> residual = makePtr<GivenResidual>();
        parts.residual = residual;
        parts.minimalSolver = problemObject(problem).createMinimalSolver();
        const Params params;
        Arena arena;
        const Context context(points.view(), parts, params, arena);
        for (int i = 0; i < count; ++i)
            residual->given.push_back((float)rng.uniform(0., 9.));
        std::vector<float> sorted = residual->given, errors = sorted;
        std::sort(sorted.begin(), sorted.end());
        const double root = std::sqrt((double)sorted[count / 2]);
        const double limit = constant * (1 + 5. / std::max(count - m, 1)) * root;
        Quality quality(0, 0);
        score->accumulate(errors.data(), count, 1e-6f, quality);
        EXPECT_NEAR(count * root / (root + side), quality.cost, 1e-9 * count);
        EXPECT_NEAR(limit, score->threshold(context, Matx33d::eye()), 1e-4 * limit);
        EXPECT_EQ(count / 2 + 1, quality.inliers);
    }
}

TEST_P(Usac_Lmeds_Problem, undefinedErrors)
{
    const ProblemType problem = (ProblemType)GetParam();
    std::vector<Point2d> corners(1, Point2d(0, 0));
    corners.push_back(Point2d(1, 1));
    const OwnPoints points(problem, corners, corners);
    const Ptr<Score> score = started(createLmedsScore(), points.view());
    std::vector<float> most(21, std::numeric_limits<float>::quiet_NaN()), some(21, 0.25f),
        zero(21, 0.f);
    std::fill(most.begin(), most.begin() + 10, 0.25f);
    std::fill(some.begin(), some.begin() + 10, std::numeric_limits<float>::quiet_NaN());
    Quality bad(0, 0), good(0, 0), perfect(0, 0), empty(0, 0);
    score->accumulate(most.data(), 21, 1, bad);
    score->accumulate(some.data(), 21, 1, good);
    score->accumulate(zero.data(), 21, 1, perfect);
    score->accumulate(zero.data(), 0, 1, empty);
    EXPECT_EQ(21, bad.cost);
    EXPECT_EQ(0, bad.inliers);
    EXPECT_NEAR(21 * 0.5 / 1.5, good.cost, 1e-9);
    EXPECT_EQ(11, good.inliers);
    EXPECT_EQ(0, perfect.cost);
    EXPECT_EQ(21, perfect.inliers);
    EXPECT_EQ(0, empty.cost);
}

//! An undefined error must count as infinite, wherever the point is in the list.
TEST_P(Usac_Lmeds_Problem, someUndefinedErrors)
{
    const ProblemType problem = (ProblemType)GetParam();
    const int COUNT = 101;
    std::vector<Point2d> corners(COUNT, Point2d(0, 0));
    corners.back() = Point2d(1, 1);
    const OwnPoints points(problem, corners, corners);
    const Ptr<Score> score = started(createLmedsScore(), points.view());
    const Ptr<GivenResidual> residual = makePtr<GivenResidual>();
    Components parts;
    parts.residual = residual;
    parts.minimalSolver = problemObject(problem).createMinimalSolver();
    const Params params;
    Arena arena;
    const Context context(points.view(), parts, params, arena);
    RNG rng(12);
    for (int trial = 0; trial < 500; ++trial)
    {
        std::vector<float> errors(COUNT), sorted;
        for (int i = 0; i < COUNT; ++i)
            errors[i] = (float)rng.uniform(0., 9.);
        sorted = errors;
        for (int k = 0; k < 1 + trial % 5; ++k)
        {
            const int undefined = rng.uniform(0, COUNT);
            errors[undefined] = std::numeric_limits<float>::quiet_NaN();
            sorted[undefined] = std::numeric_limits<float>::infinity();
        }
        residual->given = errors;
        std::sort(sorted.begin(), sorted.end());
        const double root = std::sqrt((double)sorted[COUNT / 2]);
        Quality quality(0, 0);
        score->accumulate(errors.data(), COUNT, 1, quality);
        ASSERT_NEAR(COUNT * root / (root + 1), quality.cost, 1e-9 * COUNT) << trial;
        ASSERT_EQ(COUNT / 2 + 1, quality.inliers) << trial;
        const double constant = score->threshold(context, Matx33d::eye()) / root;
        residual->given = sorted;  // NaN replaced by infinity
        ASSERT_NEAR(score->threshold(context, Matx33d::eye()) / root, constant, 1e-9) << trial;
    }
}

//! With a threshold that is far too large and 49 % outliers, LMedS must find the correct model,
//! although MSAC does not find it.
TEST_P(Usac_Lmeds_Problem, breakdown)
{
    const ProblemType problem = (ProblemType)GetParam();
    int right = 0, withoutMedian = 0;
    for (int trial = 0; trial < 5; ++trial)
    {
        SceneOptions options;
        options.inliers = 306;
        options.outliers = 294;  // 49 %
        options.seed = 1 + trial;
        const Scene scene = makeScene(problem, options);
        Params params = searchParams();
        params.threshold = 1e4;
        params.polishing = POLISHING_REWEIGHTED;  // uses the estimated threshold
        params.seed = trial;
        right += modelError(scene, estimate(scene, params)) <
                 (problem == SIMILARITY ? 1 : 0.5);  // a model of two points is less accurate
        params.quality = QUALITY_MSAC;
        withoutMedian += modelError(scene, estimate(scene, params)) < 1;
    }
    EXPECT_EQ(5, right);
    // a sample of one point can lead to the model by chance
    EXPECT_LE(withoutMedian, sampleSizeOf(problem) == 1 ? 1 : 0);
}

TEST_P(Usac_Lmeds_Problem, noPoints)
{
    const OwnPoints none((ProblemType)GetParam(), std::vector<Point2d>(), std::vector<Point2d>());
    const Ptr<Score> score = started(createLmedsScore(), none.view());
    const Components parts;
    const Params params;
    Quality quality(0, 0);
    score->accumulate(0, 0, 1, quality);
    EXPECT_EQ(0, quality.cost);
    EXPECT_EQ(0, score->threshold(RunContext(none.view(), parts, params), Matx33d::eye()));
}

INSTANTIATE_TEST_CASE_P(All, Usac_Lmeds_Problem, testing::ValuesIn(TWO_VIEW_PROBLEMS));

}
}  // namespace
