// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"

// Tests of every form of estimateAffine2D and estimateAffinePartial2D: with a flag known at compile
// time, with any flag as an int, and with Params. Calls with OpenCV's flags must go to calib3d.

namespace opencv_test {
namespace {

const UsacV20Method AFFINE_FLAGS[] = {USACV20,        USACV20_FAST,   USACV20_ACCURATE,
                                      USACV20_PROSAC, USACV20_MAGSAC, USACV20_PARALLEL,
                                      USACV20_AUTO};

//! The functions of one problem under common names. `calib3d` is OpenCV's function, selected by its
//! type. Without this module, a call with an int as the method calls this function.
struct Functions
{
    typedef Mat (*Old)(InputArray, InputArray, OutputArray, int, double, size_t, double, size_t);
    typedef Mat (*Typed)(InputArray, InputArray, OutputArray, UsacV20Method, double, size_t, double,
                         size_t);

    Old calib3d, atRunTime;
    Typed typed;
};

Functions functionsOf(ProblemType problem)
{
    const Functions affine = {&cv::estimateAffine2D, &cv::usacv20::estimateAffine2D,
                              &cv::estimateAffine2D},
                    partial = {&cv::estimateAffinePartial2D, &cv::usacv20::estimateAffinePartial2D,
                               &cv::estimateAffinePartial2D};
    return problem == AFFINITY ? affine : partial;
}

//! A scene with so few inliers that each argument changes the result with at least one flag.
Scene hardAffineScene(ProblemType problem)
{
    SceneOptions options;
    options.inliers = 12;
    options.outliers = 60;
    options.noise = 1;
    options.seed = 7;
    return makeScene(problem, options);
}

Params paramsOf(UsacV20Method flag, double threshold, int maxIterations, double confidence,
                int steps)
{
    Params params = Params::fromMethod(flag);
    params.threshold = threshold;
    params.maxIterations = maxIterations;
    params.confidence = confidence;
    params.polishingSteps = std::min(params.polishingSteps, std::max(steps, 1));
    if (steps == 0)
        params.polishing = POLISHING_NONE;
    return params;
}

void expectSame(const Scene& scene, const Params& params, const Mat& model, const Mat& mask = Mat())
{
    Mat expectedMask;
    const Mat expected = estimate(scene, params, expectedMask);
    EXPECT_FALSE(expected.empty());
    EXPECT_TRUE(sameBits(expected, model)) << expected << model;
    EXPECT_TRUE(mask.empty() || sameBits(expectedMask, mask));
}

typedef UsacProblem Usac_FindAffine;
INSTANTIATE_TEST_CASE_P(/**/, Usac_FindAffine, testing::Values((int)AFFINITY, (int)SIMILARITY));

TEST_P(Usac_FindAffine, eachArgument)
{
    const Scene s = hardAffineScene(problem());
    const Functions call = functionsOf(problem());
    for (UsacV20Method flag : AFFINE_FLAGS)
    {
        SCOPED_TRACE(cv::format("flag %d", (int)flag));
        Mat mask;
        const double confidences[] = {0.98, 1e-15};
        for (int variant = 0; variant < 8; ++variant)
        {
            const double threshold = variant == 1 ? 1 : 2, confidence = confidences[variant == 2];
            const int most = variant == 3 ? 3 : 1000, steps = variant < 4 ? 10 : variant - 4;
            const Params params = paramsOf(flag, threshold, most, confidence, steps);
            const Mat model = call.typed(s.points1, s.points2, mask, flag, threshold, most,
                                         confidence, steps);
            Mat expectedMask, other;
            EXPECT_TRUE(sameBits(estimate(s, params, expectedMask), model)) << variant;
            EXPECT_TRUE(sameBits(expectedMask, mask)) << variant;
            EXPECT_TRUE(sameBits(model, call.atRunTime(s.points1, s.points2, other, (int)flag,
                                                       threshold, most, confidence, steps)));
            EXPECT_TRUE(sameBits(mask, other)) << variant;
        }
    }
}

//! The test eachArgument detects an ignored argument only if each argument changes the model with
//! at least one of the flags.
TEST_P(Usac_FindAffine, argumentsMatter)
{
    const Scene s = hardAffineScene(problem());
    bool matters[5] = {false};
    for (UsacV20Method flag : AFFINE_FLAGS)
    {
        const Mat model = estimate(s, paramsOf(flag, 2, 1000, 0.98, 10));
        const Params others[] = {paramsOf(flag, 1, 1000, 0.98, 10), paramsOf(flag, 2, 3, 0.98, 10),
                                 paramsOf(flag, 2, 1000, 1e-15, 10),
                                 paramsOf(flag, 2, 1000, 0.98, 1),
                                 paramsOf(flag, 2, 1000, 0.98, 0)};
        for (int i = 0; i < 5; ++i)
            matters[i] = matters[i] || !sameBits(model, estimate(s, others[i]));
    }
    for (int i = 0; i < 5; ++i)
        EXPECT_TRUE(matters[i]) << i;
}

TEST(Usac_FindAffine_Forms, defaults)
{
    const Scene a = makeScene(AFFINITY), s = makeScene(SIMILARITY);
    const std::vector<Point2d>&p = a.points1, &q = a.points2, &u = s.points1, &v = s.points2;
    const UsacV20Method flag = USACV20_ACCURATE;
    const int number = (int)flag;
    const Params wanted = paramsOf(flag, 3, 2000, 0.99, 10),
                 usual = paramsOf(USACV20, 3, 2000, 0.99, 10);
    Mat mask;
    Mat model = cv::estimateAffine2D(p, q, mask, flag);
    expectSame(a, wanted, model, mask);
    expectSame(a, wanted, cv::estimateAffine2D(p, q, noArray(), flag));
    expectSame(a, wanted, estimateAffine2D(p, q, noArray(), flag, 3));
    expectSame(a, wanted, usacv20::estimateAffine2D(p, q, noArray(), flag, 3, 2000, 0.99));
    expectSame(a, wanted, usacv20::estimateAffine2D(p, q, noArray(), number));
    expectSame(a, usual, usacv20::estimateAffine2D(p, q));
    expectSame(a, usual, usacv20::estimateAffine2D(p, q, mask), mask);
    model = cv::estimateAffinePartial2D(u, v, mask, flag);
    expectSame(s, wanted, model, mask);
    expectSame(s, wanted, cv::estimateAffinePartial2D(u, v, noArray(), flag));
    expectSame(s, wanted, estimateAffinePartial2D(u, v, noArray(), flag, 3));
    expectSame(s, wanted, usacv20::estimateAffinePartial2D(u, v, noArray(), flag, 3, 2000, 0.99));
    expectSame(s, wanted, usacv20::estimateAffinePartial2D(u, v, noArray(), number));
    expectSame(s, usual, usacv20::estimateAffinePartial2D(u, v));
    expectSame(s, usual, usacv20::estimateAffinePartial2D(u, v, mask), mask);
}

TEST(Usac_FindAffine_Forms, params)
{
    const Scene a = makeScene(AFFINITY), s = makeScene(SIMILARITY);
    Params params = Params::gcRansac();
    params.threshold = 1;
    Mat mask;
    Mat model = estimateAffine2D(a.points1, a.points2, mask, params);
    expectSame(a, params, model, mask);
    expectSame(a, params, cv::estimateAffine2D(a.points1, a.points2, noArray(), params));
    model = estimateAffinePartial2D(s.points1, s.points2, mask, params);
    expectSame(s, params, model, mask);
    const cv::UsacParams theirs;
    params = Params::fromUsacParams(theirs);
    expectSame(a, params, cv::estimateAffine2D(a.points1, a.points2, noArray(), params));
    EXPECT_FALSE(sameBits(cv::estimateAffine2D(a.points1, a.points2, noArray(), theirs), model));
}

TEST_P(Usac_FindAffine, whatIsOpenCVs)
{
    const Scene s = makeScene(problem());
    const Functions call = functionsOf(problem());
    int models = 0;
    // without USAC_PARALLEL, which is not deterministic
    for (int method : {0, (int)LMEDS, (int)RANSAC, (int)RHO, (int)USAC_DEFAULT, (int)USAC_FAST,
                       (int)USAC_ACCURATE, (int)USAC_PROSAC, (int)USAC_MAGSAC, 63})
    {
        Mat masks[2], found[2];
        std::string errors[2];
        for (int k = 0; k < 2; ++k)
        {
            theRNG().state = 5;
            try
            {
                found[k] = (k ? call.atRunTime : call.calib3d)(s.points1, s.points2, masks[k],
                                                               method, 2, 500, 0.9, 5);
            }
            catch (const cv::Exception& e)
            {
                errors[k] = e.what();
            }
        }
        EXPECT_EQ(errors[0], errors[1]);
        EXPECT_TRUE(sameBits(found[0], found[1])) << method;
        EXPECT_TRUE(!errors[0].empty() || sameBits(masks[0], masks[1])) << method;
        if (!found[0].empty())
        {
            Mat mask;
            const Mat model = call.typed(s.points1, s.points2, mask, USACV20, 2, 500, 0.9, 5);
            EXPECT_EQ(found[0].size(), model.size());
            EXPECT_EQ(found[0].type(), model.type());
            EXPECT_EQ(masks[0].size(), mask.size()) << method;
            EXPECT_EQ(masks[0].type(), mask.type()) << method;
            EXPECT_FALSE(sameBits(found[0], model));
            ++models;
        }
    }
    EXPECT_GE(models, 2);
    theRNG().state = 5;
    const Mat without = problem() == AFFINITY ? cv::estimateAffine2D(s.points1, s.points2)
                                              : cv::estimateAffinePartial2D(s.points1, s.points2);
    theRNG().state = 5;
    EXPECT_TRUE(sameBits(without,
                         call.calib3d(s.points1, s.points2, noArray(), RANSAC, 3, 2000, 0.99, 10)));
}

TEST_P(Usac_FindAffine, wrongArguments)
{
    const Scene s = makeScene(problem());
    const Functions call = functionsOf(problem());
    for (int method : {-1, 64, 0x3fff, (int)USACV20_AUTO + 1, INT_MAX, INT_MIN})
        expectException(
            [&]() { call.atRunTime(s.points1, s.points2, noArray(), method, 3, 2000, 0.99, 10); },
            cv::format("%d", method));
    for (size_t count : {(size_t)INT_MAX + 1, (size_t)-1, (size_t)-1000})
    {
        expectException(
            [&]() { call.typed(s.points1, s.points2, noArray(), USACV20, 3, count, 0.99, 10); },
            "maxIters");
        expectException(
            [&]() { call.typed(s.points1, s.points2, noArray(), USACV20, 3, 2000, 0.99, count); },
            "refineIters");
    }
    expectException([&]() { call.typed(s.points1, s.points2, noArray(), USACV20, 3, 0, 0.99, 10); },
                    "maxIters: ");
    expectException(
        [&]() { call.typed(s.points1, s.points2, noArray(), USACV20, 0, 10, 0.99, 10); },
        "ransacReprojThreshold: ");
    EXPECT_NO_THROW(call.typed(s.points1, s.points2, noArray(), USACV20, 3, 2000, 0.99, INT_MAX));
}

}  // namespace
}  // namespace opencv_test
