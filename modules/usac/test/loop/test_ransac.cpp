// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

namespace opencv_test {
namespace {

//! The result of an estimation.
struct Answer
{
    Mat model, mask;
    Report report;
};

Answer answer(const Scene& scene, const Params& params)
{
    Answer result;
    result.model = estimate(scene, params, result.mask, &result.report);
    return result;
}

Scene sceneWith(ProblemType problem, double inlierRatio, uint64 seed, int size = 400)
{
    SceneOptions options;
    options.inliers = cvRound(inlierRatio * size);
    options.outliers = size - options.inliers;
    options.seed = seed;
    return makeScene(problem, options);
}

std::vector<Params> variants()
{
    std::vector<Params> result;
    result.push_back(Params());
    result.push_back(Params::fast());
    result.push_back(Params::accurate());
    result.push_back(Params::ransac());
    Params params;
    params.termination = 0;
    params.maxIterations = 700;
    result.push_back(params);
    params.sampler = SAMPLER_PROSAC;
    params.verification = VERIFICATION_NONE;
    result.push_back(params);
    return result;
}

typedef testing::TestWithParam<int> Usac_Ransac;

TEST_P(Usac_Ransac, reportIsConsistent)
{
    const std::vector<Params> all = variants();
    for (size_t v = 0; v < all.size(); ++v)
        for (uint64 seed = 1; seed <= 5; ++seed)
        {
            SCOPED_TRACE(cv::format("variant %d seed %d", (int)v, (int)seed));
            const Scene scene = sceneWith((ProblemType)GetParam(), 0.5, seed);
            Params params = all[v];
            params.maxIterations = std::min(params.maxIterations, 1000);
            const Answer found = answer(scene, params);
            const Report& r = found.report;
            EXPECT_GE(r.iterations, 1);
            EXPECT_LE(r.iterations, params.maxIterations);
            EXPECT_LE(r.rejectedSamples, r.iterations);
            EXPECT_LE(r.models, (r.iterations - r.rejectedSamples) * (int)MAX_MODELS);
            EXPECT_GE(r.models, r.iterations - r.rejectedSamples - r.degenerateSamples);
            EXPECT_LE(r.rejectedSamples + r.degenerateSamples, r.iterations);
            EXPECT_LE(r.rejectedModels + r.refusedModels + r.droppedModels, r.models);
            if (params.verification == VERIFICATION_NONE ||
                // for affine maps, whose samples are small, the verifier might reject no model
                GetParam() <= ESSENTIAL)
            {
                EXPECT_EQ(params.verification == VERIFICATION_NONE, r.refusedModels == 0);
            }
            EXPECT_LE(r.localImprovements, r.localOptimizations);
            // at most one local optimization per model that is neither rejected nor dropped, two
            // per runner-up, and one more per improvement
            EXPECT_LE(r.localOptimizations, r.models - r.rejectedModels - r.droppedModels +
                                                2 * params.runnersUp + r.localImprovements);
            EXPECT_EQ(params.localOptimization == LOCAL_OPTIMIZATION_NONE,
                      r.localOptimizations == 0);
            EXPECT_EQ(countNonZero(found.mask), r.inliers);
            EXPECT_TRUE(r.cost >= 0 && r.cost <= 1);
            EXPECT_EQ(params.threshold, r.threshold);
            EXPECT_TRUE(r.independentInliers > 0 && r.independentInliers <= r.inliers &&
                        r.chance <= 1e-6);
            EXPECT_TRUE(r.setupMs >= 0 && r.searchMs >= 0 && r.localMs >= 0 && r.polishMs >= 0);
            EXPECT_FALSE(r.describe().empty());
        }
}

TEST_P(Usac_Ransac, recoversTheModel)
{
    const ProblemType problem = (ProblemType)GetParam();
    const double ratios[] = {0.3, 0.5, 0.7, 0.9};
    const int SCENES = 15;
    for (int k = 0; k < 4; ++k)
    {
        int recovered = 0;
        double inliersFound = 0, inliers = 0;
        for (uint64 seed = 1; seed <= SCENES; ++seed)
        {
            const Scene scene = sceneWith(problem, ratios[k], seed);
            Params params;
            params.confidence = 0.999;
            params.maxIterations = 30000;
            const Answer found = answer(scene, params);
            const double error = modelError(scene, found.model);
            recovered += error < 1;
            for (int i = 0; error < 1 && i < scene.size(); ++i)
            {
                inliers += scene.truth[i];
                inliersFound += scene.truth[i] && found.mask.at<uchar>(i);
            }
        }
        EXPECT_GE(recovered, SCENES * 9 / 10) << "inlier ratio " << ratios[k];
        EXPECT_GT(inliersFound, 0.85 * inliers) << "inlier ratio " << ratios[k];
    }
}

//! Without noise, and with a threshold so small that hardly any wrong match is an inlier, the
//! errors of the models must be below 1e-3 pixels.
TEST_P(Usac_Ransac, exactWithoutNoise)
{
    for (uint64 seed = 1; seed <= 15; ++seed)
    {
        SceneOptions options;
        options.noise = 0;
        options.seed = seed;
        const Scene scene = makeScene((ProblemType)GetParam(), options);
        Params params;
        params.threshold = 0.01;
        EXPECT_LT(modelError(scene, answer(scene, params).model), 1e-3) << "seed " << seed;
    }
}

INSTANTIATE_TEST_CASE_P(All, Usac_Ransac, testing::ValuesIn(TWO_VIEW_PROBLEMS));

Params stopBy(int termination)
{
    Params params;
    params.termination = termination;
    params.maxIterations = 50000;
    return params;
}

TEST(Usac_Ransac_Stop, reasons)
{
    const Scene scene = sceneWith(HOMOGRAPHY, 0.6, 1);
    EXPECT_EQ((int)STOP_STANDARD, answer(scene, stopBy(TERMINATION_STANDARD)).report.stop);
    EXPECT_EQ((int)STOP_SPRT, answer(scene, stopBy(TERMINATION_SPRT)).report.stop);
    EXPECT_EQ((int)STOP_P_NAPSAC, answer(scene, stopBy(TERMINATION_P_NAPSAC)).report.stop);
    Params params = stopBy(0);
    params.maxIterations = 321;
    const Report report = answer(scene, params).report;
    EXPECT_EQ((int)STOP_MAX_ITERATIONS, report.stop);
    EXPECT_EQ(321, report.iterations);
}

//! With two criteria, the search must end when the first of them is fulfilled.
TEST(Usac_Ransac_Stop, firstOfTwo)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        const Scene scene = sceneWith(FUNDAMENTAL, 0.5, seed);
        const int both = answer(scene, stopBy(TERMINATION_SPRT | TERMINATION_P_NAPSAC))
                             .report.iterations;
        const int sprt = answer(scene, stopBy(TERMINATION_SPRT)).report.iterations;
        const int relaxed = answer(scene, stopBy(TERMINATION_P_NAPSAC)).report.iterations;
        EXPECT_EQ(std::min(sprt, relaxed), both) << "seed " << seed;
    }
}

class StopAt : public Termination
{
public:
    explicit StopAt(int samples_) : samples(samples_) {}
    int iterations(const Context&, const State&) const CV_OVERRIDE { return samples; }

private:
    const int samples;
};

TEST(Usac_Ransac_Stop, custom)
{
    const Scene scene = sceneWith(HOMOGRAPHY, 0.5, 1);
    Params params = stopBy(0);
    // otherwise, samples drawn from the outliers of the best model would count as iterations, too
    params.runnersUp = 0;
    Report report;
    const Ptr<Usac> usac = createUsac(scene, params);
    usac->components().terminations.push_back(makePtr<StopAt>(123));
    EXPECT_FALSE(usac->run(noArray(), &report).empty());
    EXPECT_EQ((int)STOP_CUSTOM, report.stop);
    EXPECT_EQ(123, report.iterations);
}

//! A run must also work without an ordering, a verifier, a local optimizer, a polisher and
//! degeneracy checks, and with only one termination criterion, which the caller has written.
TEST(Usac_Ransac_Parts, withoutOptionalComponents)
{
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        const Scene scene = sceneWith((ProblemType)problem, 0.7, 2);
        const Ptr<Usac> usac = createUsac(scene, stopBy(0));
        Components& parts = usac->components();
        parts.ordering.release();
        parts.verifier.release();
        parts.localOptimizer.release();
        parts.polisher.release();
        parts.degeneracies.clear();
        parts.terminations.clear();
        parts.terminations.push_back(makePtr<StopAt>(500));
        Report report;
        const Mat model = usac->run(noArray(), &report);
        EXPECT_LT(modelError(scene, model), 5);
        EXPECT_EQ(0, report.localOptimizations);
        EXPECT_EQ(0, report.rejectedModels);
    }
}

}  // namespace
}  // namespace opencv_test
