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

void expectSameBits(const Answer& a, const Answer& b)
{
    ASSERT_EQ(a.model.size(), b.model.size());
    if (!a.model.empty())
    {
        EXPECT_EQ(0, memcmp(a.model.data, b.model.data, a.model.total() * sizeof(double)));
    }
    EXPECT_EQ(0, cvtest::norm(a.mask, b.mask, NORM_INF));
    EXPECT_EQ(a.report.stop, b.report.stop);
    EXPECT_EQ(a.report.iterations, b.report.iterations);
    EXPECT_EQ(a.report.inliers, b.report.inliers);
    EXPECT_EQ(a.report.cost, b.report.cost);
    EXPECT_EQ(a.report.rejectedSamples, b.report.rejectedSamples);
    EXPECT_EQ(a.report.localOptimizations, b.report.localOptimizations);
    EXPECT_EQ(a.report.localImprovements, b.report.localImprovements);
    EXPECT_EQ(a.report.degenerate, b.report.degenerate);
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

TEST_P(Usac_Ransac, sameBitsWithAnyNumberOfThreads)
{
    const std::vector<Params> all = variants();
    for (size_t v = 0; v < all.size(); ++v)
        for (uint64 seed = 1; seed <= 4; ++seed)
        {
            const Scene scene = sceneWith((ProblemType)GetParam(), 0.25 + 0.15 * seed, seed);
            Params params = all[v];
            params.seed = (int)seed;
            params.maxIterations = std::min(params.maxIterations, 1000);
            const Answer one = answer(scene, params);
            const int threads[] = {2, 8, 0};
            for (int k = 0; k < 3; ++k)
            {
                SCOPED_TRACE(
                    cv::format("variant %d seed %d threads %d", (int)v, (int)seed, threads[k]));
                params.threads = threads[k];
                expectSameBits(one, answer(scene, params));
            }
        }
}

//! OpenCV's global random generator must not change the result, but the seed must.
TEST_P(Usac_Ransac, repeatable)
{
    const Scene scene = sceneWith((ProblemType)GetParam(), 0.4, 7);
    Params params;
    const Answer first = answer(scene, params);
    theRNG().next();
    estimate(sceneWith(HOMOGRAPHY, 0.5, 3), params);
    expectSameBits(first, answer(scene, params));
    params.termination = 0;
    params.maxIterations = 20;
    params.polishing = POLISHING_NONE;
    params.localOptimization = LOCAL_OPTIMIZATION_NONE;
    const Answer a = answer(scene, params);
    int different = 0;
    for (int seed = 1; seed <= 5; ++seed)
    {
        params.seed = seed;
        const Answer b = answer(scene, params);
        different += b.model.size() != a.model.size() || cvtest::norm(a.mask, b.mask, NORM_INF) > 0;
    }
    EXPECT_GT(different, 0);
}

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

TEST_P(Usac_Ransac, maskBelongsToTheModel)
{
    for (uint64 seed = 1; seed <= 20; ++seed)
    {
        const Scene scene = sceneWith((ProblemType)GetParam(), 0.5, seed);
        Params params;
        params.threshold = 0.5 + 0.1 * seed;
        const Answer found = answer(scene, params);
        ASSERT_FALSE(found.model.empty());
        const Matx33d model = squareModel(found.model);
        for (int i = 0; i < scene.size(); ++i)
        {
            const double error = pixelError(scene, model, scene.points1[i], scene.points2[i]);
            if (std::abs(error - params.threshold) > 1e-7)
            {
                ASSERT_EQ(error < params.threshold, found.mask.at<uchar>(i) != 0)
                    << "row " << i << " error " << error;
            }
        }
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

TEST_P(Usac_Ransac, duplicates)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        SceneOptions options;
        options.duplicates = 150;
        options.seed = seed;
        const Scene scene = makeScene((ProblemType)GetParam(), options);
        EXPECT_LT(modelError(scene, answer(scene, Params()).model), 2) << "seed " << seed;
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

TEST(Usac_Ransac_Stop, withoutAModel)
{
    Scene scene = sceneWith(FUNDAMENTAL, 0.6, 1, 20);
    scene.points1.resize(6);
    scene.points2.resize(6);
    const Answer few = answer(scene, Params());
    EXPECT_EQ((int)STOP_TOO_FEW_POINTS, few.report.stop);
    EXPECT_EQ(0, few.report.iterations);
    EXPECT_TRUE(few.model.empty());
    EXPECT_EQ(Size(1, 6), few.mask.size());
    EXPECT_EQ(0, countNonZero(few.mask));
    scene.points1.assign(50, Point2d(5, 7));
    scene.points2.assign(50, Point2d(3, 4));
    const Answer equal = answer(scene, Params());
    EXPECT_EQ((int)STOP_TOO_FEW_POINTS, equal.report.stop);
    EXPECT_TRUE(equal.model.empty());
    EXPECT_EQ(0, countNonZero(equal.mask));
}

//! The number of samples must be at least that of the standard criterion for the final number of
//! inliers, within 5 %. It is larger if the best model was found late, but must be equal (within
//! 5 %) for most seeds.
TEST(Usac_Ransac_Stop, standardNumberOfSamples)
{
    Params params = Params::ransac();
    params.confidence = 0.95;
    params.maxIterations = 1000000;
    params.polishing = POLISHING_NONE;
    for (int withoutRepetition = 0; withoutRepetition < 2; ++withoutRepetition)
    {
        params.termination = TERMINATION_STANDARD | (withoutRepetition ? TERMINATION_EXACT : 0);
        int exact = 0;
        for (uint64 seed = 1; seed <= 20; ++seed)
        {
            const Scene scene = sceneWith(HOMOGRAPHY, 0.3, seed);
            const Report report = answer(scene, params).report;
            EXPECT_EQ((int)STOP_STANDARD, report.stop);
            double good = 1;
            for (int i = 0; i < 4; ++i)
                good *= (report.inliers - i * withoutRepetition) /
                        (double)(scene.size() - i * withoutRepetition);
            const double needed = std::ceil(std::log(0.05) / std::log1p(-good));
            EXPECT_GE(report.iterations, 0.95 * needed) << "seed " << seed;
            exact += std::abs(report.iterations - needed) <= 0.05 * needed;
        }
        EXPECT_GE(exact, 12);
    }
}

//! For random matches, the false-alarm probability (Report::chance) must exceed 0.01. Copies of a
//! match must count as one independent inlier.
TEST(Usac_Ransac_Report, nonRandomness)
{
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        SceneOptions options;
        options.inliers = 1;
        options.outliers = 200;
        const Answer random = answer(makeScene((ProblemType)problem, options), Params());
        EXPECT_GT(random.report.chance, 0.01) << problem;
        options.inliers = 30;
        options.outliers = 0;
        Scene repeated = makeScene((ProblemType)problem, options);
        for (int k = 0; k < 20; ++k)
        {
            repeated.points1.push_back(repeated.points1[0]);
            repeated.points2.push_back(repeated.points2[0]);
        }
        Params params;
        params.threshold = 3;
        const Report report = answer(repeated, params).report;
        EXPECT_GE(report.inliers, 45) << problem;
        EXPECT_LE(report.independentInliers, 30) << problem;
        EXPECT_GE(report.independentInliers, 20) << problem;
    }
}

//! LMedS estimates its threshold, and the mask must use this threshold.
TEST(Usac_Ransac_Report, thresholdOfLmeds)
{
    const Scene scene = sceneWith(HOMOGRAPHY, 0.7, 1);
    Params params = Params::lmeds();
    params.threshold = 1e-3;
    const Answer found = answer(scene, params);
    EXPECT_GT(found.report.threshold, 0.5);
    EXPECT_LT(found.report.threshold, 8);
    const Matx33d H(found.model.ptr<double>());
    for (int i = 0; i < scene.size(); ++i)
        EXPECT_EQ(pixelError(scene, H, scene.points1[i], scene.points2[i]) <=
                      found.report.threshold,
                  found.mask.at<uchar>(i) != 0);
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
