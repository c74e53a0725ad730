// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"

// Apart from the effect of noise, the result must depend on the points but not on their order. The
// caller's arrays must not change.

namespace opencv_test {
namespace {

typedef UsacProblem UsacTruth;
INSTANTIATE_TEST_CASE_P(/**/, UsacTruth, testing::ValuesIn(TWO_VIEW_PROBLEMS));

//! The scene with shuffled points and scores: row i of the result is row order[i] of `scene`. The
//! other members are not shuffled.
Scene permuted(const Scene& scene, uint64 seed, std::vector<int>& order)
{
    Scene result = scene;
    RNG rng(seed);
    order.resize(scene.size());
    for (int i = 0; i < scene.size(); ++i)
        order[i] = i;
    for (int i = scene.size() - 1; i > 0; --i)
        std::swap(order[i], order[rng.uniform(0, i + 1)]);
    for (int i = 0; i < scene.size(); ++i)
    {
        result.points1[i] = scene.points1[order[i]];
        result.points2[i] = scene.points2[order[i]];
        result.scores[i] = scene.scores[order[i]];
    }
    return result;
}

/** Runs the scene and a permutation of it. Samples are drawn by position in a pseudo-random order
that depends only on the number of points. After a permutation, the samples therefore consist of
other points. With noise, the models then differ slightly, and the masks can differ where an error
is near the threshold. With exact points, every all-inlier sample gives the same model, so
that the mask must be permuted like the points. @return number of matches whose mask differs */
int rowsThatDiffer(const Scene& scene, Params params, uint64 seed)
{
    std::vector<int> order;
    const Scene other = permuted(scene, seed, order);
    Mat mask, otherMask;
    if (!params.scores.empty())
        params.scores = scene.scores;
    const Mat model = estimate(scene, params, mask);
    if (!params.scores.empty())
        params.scores = other.scores;
    EXPECT_FALSE(model.empty());
    EXPECT_FALSE(estimate(other, params, otherMask).empty());
    int different = 0;
    for (int i = 0; i < scene.size(); ++i)
        different += otherMask.at<uchar>(i) != mask.at<uchar>(order[i]);
    return different;
}

TEST_P(UsacTruth, permuting_exact_points_permutes_the_mask)
{
    SceneOptions options;
    options.noise = 0;
    options.outliers = 60;
    options.scoreInformation = 0.8;
    const Scene scene = makeScene(problem(), options);
    const std::vector<NamedPreset> presets = allPresets(problem());
    for (size_t i = 0; i < presets.size(); ++i)
    {
        Params params = presets[i].params;
        params.threshold = 0.5;
        // instead of the order of the rows, which a permutation changes, use that of the scores
        if (params.ordering == ORDERING_INPUT_ORDER)
        {
            params.ordering = ORDERING_AUTO;
            params.scores = scene.scores;
        }
        for (uint64 seed = 1; seed <= 3; ++seed)
            EXPECT_EQ(0, rowsThatDiffer(scene, params, seed))
                << presets[i].name << ", seed " << seed;
    }
}

TEST_P(UsacTruth, mask_of_the_symmetric_residual)
{
    for (uint64 seed = 1; seed <= 5; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        const Scene scene = makeScene(problem(), options);
        Params params;
        params.residual = RESIDUAL_SYMMETRIC;
        Mat mask;
        Report report;
        const Mat model = estimate(scene, params, mask, &report);
        ASSERT_FALSE(model.empty());
        EXPECT_EQ("", brokenResult(callOf(scene, params), model, mask, report)) << "seed " << seed;
        params.residual = RESIDUAL_STANDARD;
        EXPECT_NE("", brokenResult(callOf(scene, params), model, mask, report))
            << "seed " << seed << ": the mask is the same with both residuals";
    }
}

//! The caller's arrays and the elements next to them in memory must not change.
TEST_P(UsacTruth, all_input_is_unchanged_to_the_bit)
{
    const Scene scene = makeScene(problem());
    const int count = scene.size();
    const int depths[] = {CV_16S, CV_32S, CV_32F, CV_64F};
    for (int d = 0; d < 4; ++d)
    {
        Mat wide(count, 6, depths[d], Scalar(7)), points1 = wide.colRange(1, 3),
                                                  points2 = wide.colRange(3, 5);
        column(scene.points1).reshape(1).convertTo(points1, depths[d]);
        column(scene.points2).reshape(1).convertTo(points2, depths[d]);
        Mat K(4, 5, CV_32F, Scalar(3)), view = K(Rect(1, 1, 3, 3)),
                                        distortion(5, 1, CV_64F, Scalar(1e-5));
        Mat(scene.K).convertTo(view, CV_32F);
        const Mat wideBefore = wide.clone(), KBefore = K.clone(),
                  distortionBefore = distortion.clone();
        const std::vector<NamedPreset> presets = allPresets(problem());
        for (size_t i = 0; i < presets.size(); ++i)
        {
            Params params = presets[i].params;
            params.maxIterations = 100;
            params.scores = scene.scores;
            Mat mask;
            Report report;
            if (problem() == ESSENTIAL)
                estimateEssential(points1, points2, view, view, distortion, distortion, params,
                                  mask, report);
            else
                estimatePoints(problem(), points1, points2, params, mask, report);
            EXPECT_EQ(scene.scores, params.scores);
        }
        EXPECT_TRUE(sameBits(wideBefore, wide)) << "depth " << depths[d];
        EXPECT_TRUE(sameBits(KBefore, K));
        EXPECT_TRUE(sameBits(distortionBefore, distortion));
    }
}

}  // namespace
}  // namespace opencv_test
