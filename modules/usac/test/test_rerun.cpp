// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "test_contracts.hpp"

// An object that is run again gives what a new one gives.

namespace opencv_test {
namespace {

void expectSame(const Mat& a, const Mat& maskA, const Report& reportA, const Mat& b, const Mat& maskB,
                const Report& reportB)
{
    ASSERT_EQ(a.empty(), b.empty());
    if (!a.empty())
    {
        EXPECT_EQ(0, cv::norm(a, b, NORM_INF));
    }
    EXPECT_EQ(0, cv::norm(maskA, maskB, NORM_INF));
    EXPECT_EQ(reportA.iterations, reportB.iterations);
    EXPECT_EQ(reportA.cost, reportB.cost);
    EXPECT_EQ(reportA.threshold, reportB.threshold);
    EXPECT_EQ(reportA.stop, reportB.stop);
    EXPECT_EQ(reportA.models, reportB.models);
}

typedef testing::TestWithParam<int> Usac_Rerun;

TEST_P(Usac_Rerun, givesTheSame)
{
    const ProblemType problem = (ProblemType)GetParam();
    const std::vector<NamedPreset> presets = allPresets();
    SceneOptions options;
    options.outliers = 60;
    const Scene scene = makeScene(problem, options);
    for (size_t p = 0; p < presets.size(); ++p)
    {
        Params params = presets[p].params;
        params.maxIterations = std::min(params.maxIterations, 500);
        params.threshold = 0.3;  // below the noise, so that presets that may change it do
        const Ptr<Usac> usac = createUsac(scene, params);
        Mat masks[3], models[3];
        Report reports[3];
        for (int i = 0; i < 3; ++i)
            models[i] = usac->run(masks[i], &reports[i]);
        for (int i = 1; i < 3; ++i)
            expectSame(models[0], masks[0], reports[0], models[i], masks[i], reports[i]);
    }
}

//! Other points, more and fewer, none, and the first again.
TEST_P(Usac_Rerun, withOtherPoints)
{
    const ProblemType problem = (ProblemType)GetParam();
    const int sizes[] = {100, 300, 20, 3, 100};
    const Ptr<Usac> usac = createUsac(makeScene(problem), Params());
    for (int i = 0; i < 5; ++i)
    {
        SceneOptions options;
        options.setSize(sizes[i], 0.7);
        options.seed = 1 + i % 4;
        const Scene scene = makeScene(problem, options);
        Mat masks[2];
        Report reports[2];
        usac->setPoints(scene.points1, scene.points2);
        EXPECT_EQ(sizes[i], usac->points().size);
        const Mat again = usac->run(masks[0], &reports[0]),
                  once = createUsac(scene, Params())->run(masks[1], &reports[1]);
        expectSame(again, masks[0], reports[0], once, masks[1], reports[1]);
    }
    EXPECT_THROW(usac->setPoints(std::vector<Point2d>(3), std::vector<Point2d>(4)), cv::Exception);
}

INSTANTIATE_TEST_CASE_P(All, Usac_Rerun, testing::Values(0, 1, 2));

}
}  // namespace
