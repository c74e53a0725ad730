// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"

// Parameters at the limits of their ranges must not cause exceptions or wrong results, with any
// preset or flag.

namespace opencv_test {
namespace {

typedef UsacProblem UsacExtremes;
INSTANTIATE_TEST_CASE_P(/**/, UsacExtremes, testing::ValuesIn(TWO_VIEW_PROBLEMS));

//! The squares of most of these thresholds are out of the range of float, some also out of the
//! range of double.
TEST_P(UsacExtremes, thresholds)
{
    const double thresholds[] = {1e-320, 1e-300, 1e-160, 1e-25, 1e-9,
                                 1e9,    1e25,   1e160,  1e300, 1.7e308};
    SceneOptions options;
    options.inliers = 60;
    options.outliers = 40;
    for (int t = 0; t < 10; ++t)
        for (int exact = 0; exact < 2; ++exact)
        {
            SCOPED_TRACE(cv::format("threshold %g, %s", thresholds[t], exact ? "exact" : "noisy"));
            options.noise = exact ? 0 : 0.5;
            Scene scene = makeScene(problem(), options);
            Matx33d K = scene.K;
            if (exact)
            {
                // with focal lengths below 1, the threshold in normalized coordinates (for E) is
                // larger than the given threshold
                const double scale = 1e-3;
                K = Matx33d(scale * K(0, 0), 0, scale * K(0, 2), 0, scale * K(1, 1),
                            scale * K(1, 2), 0, 0, 1);
                for (int i = 0; i < scene.size(); ++i)
                {
                    scene.points1[i] *= scale;
                    scene.points2[i] *= scale;
                }
            }
            const std::vector<Mat> models = checkEveryWay(problem(), scene.points1, scene.points2,
                                                          thresholds[t], 30, K);
            for (size_t i = 0; i < models.size(); ++i)
                EXPECT_TRUE(thresholds[t] < 1 || !models[i].empty()) << allPresets()[i].name;
        }
}

TEST_P(UsacExtremes, confidences_and_single_samples)
{
    const double confidences[] = {1e-300, 1e-16, 1 - 1e-16};
    const Scene scene = makeScene(problem());
    const std::vector<NamedPreset> presets = allPresets(problem());
    for (int c = 0; c < 3; ++c)
        for (size_t i = 0; i < presets.size(); ++i)
        {
            SCOPED_TRACE(cv::format("confidence %g, preset %s", confidences[c], presets[i].name));
            Params params = presets[i].params;
            params.confidence = confidences[c];
            params.maxIterations = 100;
            Mat mask;
            Report report;
            const Mat model = estimate(scene, params, mask, &report);
            checkResult(scene, report.threshold, model, mask, report);
            // with THRESHOLD_ESTIMATED, the search starts from a model, so that 0 iterations are
            // possible
            EXPECT_TRUE(report.iterations >= (findsThreshold(params) ? 0 : 1) &&
                        report.iterations <= 100)
                << report.iterations;
        }
    checkEveryWay(problem(), scene.points1, scene.points2, 1.5, 1);
}

/** With maxIterations = INT_MAX, a run must not go on forever if its termination criterion cannot
be fulfilled. The run must end when all possible samples have been drawn, or when none of the first
million samples yields a model. */
TEST_P(UsacExtremes, all_iterations_without_a_model)
{
    RNG rng(11);
    std::vector<Point2d> points1, points2;
    for (int i = 0; i < 9; ++i)
    {
        points1.push_back(uniformPoint(rng, 0., 640., 0., 480.));
        points2.push_back(uniformPoint(rng, 0., 640., 0., 480.));
    }
    checkEveryWay(problem(), points1, points2, 1e-3, INT_MAX);
    if (sampleSizeOf(problem()) == 1)  // identical matches determine a translation
        return;
    const std::vector<Point2d> same(1000, Point2d(3, 4));
    Params params = Params::prosac();
    params.maxIterations = INT_MAX;
    Mat mask;
    Report report;
    EXPECT_TRUE(estimatePoints(problem(), same, same, params, mask, report).empty());
    EXPECT_LE(report.iterations, 1000000);
    EXPECT_EQ((int)STOP_NO_MODEL, report.stop);
}

}  // namespace
}  // namespace opencv_test
