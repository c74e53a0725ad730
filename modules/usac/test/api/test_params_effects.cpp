// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"
#include "support/scene_geometry.hpp"

#include <chrono>
#include <mutex>
#include <set>
#include <thread>

// A field of Params must have an effect when only this field is changed. This file tests the
// general fields and those of samples and scores; test_params_components.cpp tests other fields.

namespace opencv_test {
namespace {

typedef UsacProblem UsacEffects;
INSTANTIATE_TEST_CASE_P(/**/, UsacEffects, testing::ValuesIn(TWO_VIEW_PROBLEMS));

//! Parameters with uniform sampling, without local optimization, and with all `maxIterations`
//! samples.
Params plainParams()
{
    Params params = Params::ransac();
    params.quality = QUALITY_MSAC;
    params.termination = 0;
    params.maxIterations = 200;
    return params;
}

TEST_P(UsacEffects, maxIterations)
{
    const Scene scene = makeScene(problem(), 100, 200, 3);
    const int limits[] = {1, 17, 100, 1000};
    for (int i = 0; i < 4; ++i)
    {
        Params params = Params();
        params.termination = 0;
        params.maxIterations = limits[i];
        EXPECT_EQ(limits[i], reportOf(scene, params).iterations);
        params.sampler = SAMPLER_UNIFORM;
        EXPECT_EQ(limits[i], reportOf(scene, params).iterations);
    }
}

//! Records the samples that the given sampler draws, as row numbers of the input.
class SampleRecorder : public Sampler
{
public:
    explicit SampleRecorder(const Ptr<Sampler>& sampler_) : sampler(sampler_) {}

    void start(const Context& context) CV_OVERRIDE { sampler->start(context); }

    void sample(const Context& context, State& state, int* out) CV_OVERRIDE
    {
        sampler->sample(context, state, out);
        for (int k = 0; k < context.components.minimalSolver->sampleSize(); ++k)
            drawn.push_back(context.points.inputIndex[out[k]]);
    }

    Ptr<Sampler> sampler;
    std::vector<int> drawn;
};

//! Rows of the input in the first `iterations` samples.
std::vector<int> samplesOf(const Scene& scene, Params params, int iterations = 100)
{
    params.maxIterations = iterations;
    params.termination = 0;
    Ptr<Usac> usac = createUsac(scene, params);
    const Ptr<SampleRecorder> recorder = makePtr<SampleRecorder>(usac->components().sampler);
    usac->components().sampler = recorder;
    usac->run();
    recorder->drawn.resize(iterations * sampleSizeOf(scene.problem));
    return recorder->drawn;
}

//! Records the threads that call the solver. Until a second thread calls, each of the first 499
//! calls takes 1 ms longer, so that a fast thread cannot do all the work alone.
class ThreadRecorder : public MinimalSolver
{
public:
    explicit ThreadRecorder(const Ptr<MinimalSolver>& solver_) : solver(solver_), calls(0) {}

    int sampleSize() const CV_OVERRIDE { return solver->sampleSize(); }

    int solve(const Correspondences& points, const int* sample, Model* models) const CV_OVERRIDE
    {
        bool dally;
        {
            std::lock_guard<std::mutex> lock(mutex);
            threads.insert(std::this_thread::get_id());
            dally = threads.size() < 2 && ++calls < 500;
        }
        if (dally)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return solver->solve(points, sample, models);
    }

    Ptr<MinimalSolver> solver;
    mutable std::mutex mutex;
    mutable std::set<std::thread::id> threads;
    mutable int calls;
};

size_t threadsUsed(const Scene& scene, int threads)
{
    Params params = plainParams();
    params.threads = threads;
    params.maxIterations = 600;
    Ptr<Usac> usac = createUsac(scene, params);
    const Ptr<ThreadRecorder> recorder = makePtr<ThreadRecorder>(usac->components().minimalSolver);
    usac->components().minimalSolver = recorder;
    usac->run();
    return recorder->threads.size();
}

TEST_P(UsacEffects, threads)
{
    const int before = getNumThreads();
    setNumThreads(4);
    const bool parallel = getNumThreads() > 1;
    const Scene scene = makeScene(problem(), 100, 100, 3);
    const size_t one = threadsUsed(scene, 1), four = threadsUsed(scene, 4),
                 all = threadsUsed(scene, 0);
    setNumThreads(1);
    const size_t allOfOne = threadsUsed(scene, 0);
    setNumThreads(before);
    EXPECT_EQ((size_t)1, one);
    EXPECT_EQ((size_t)1, allOfOne);
    if (isAffine(problem()))
    {
        EXPECT_EQ((size_t)1, four) << "samples of affine maps take too little time for threads";
        EXPECT_EQ((size_t)1, all);
    }
    else if (parallel)  // otherwise OpenCV was built without threads
    {
        EXPECT_GT(four, (size_t)1);
        EXPECT_GT(all, (size_t)1);
    }
}

//! The points, `clean1`, `clean2` and `truth` of the scene, with the true matches moved to the
//! first rows. The other members, such as the scores, are not moved, because the tests do not use
//! them.
Scene sorted(const Scene& scene)
{
    Scene result = scene;
    int row = 0;
    for (int wanted = 1; wanted >= 0; --wanted)
        for (int i = 0; i < scene.size(); ++i)
            if (scene.truth[i] == wanted)
            {
                result.points1[row] = scene.points1[i];
                result.points2[row] = scene.points2[i];
                result.clean1[row] = scene.clean1[i];
                result.clean2[row] = scene.clean2[i];
                result.truth[row++] = scene.truth[i];
            }
    return result;
}

//! Fraction of the rows that are true matches.
double goodPart(const Scene& scene, const std::vector<int>& rows)
{
    double good = 0;
    for (size_t i = 0; i < rows.size(); ++i)
        good += scene.truth[rows[i]];
    return good / rows.size();
}

TEST_P(UsacEffects, sampler)
{
    const Scene scene = sorted(makeScene(problem(), 60, 240, 3));
    Params params;
    params.orderedEvery = 1;
    params.ordering = ORDERING_INPUT_ORDER;
    params.sampler = SAMPLER_PROSAC;
    const std::vector<int> prosac = samplesOf(scene, params, 50);
    params.sampler = SAMPLER_P_NAPSAC;
    const std::vector<int> pNapsac = samplesOf(scene, params, 50);
    params.sampler = SAMPLER_UNIFORM;
    const std::vector<int> uniform = samplesOf(scene, params, 50);
    EXPECT_EQ(1, goodPart(scene, prosac)) << "the first samples consist of the best points";
    EXPECT_NEAR(0.2, goodPart(scene, uniform), 0.1);
    EXPECT_EQ(sampleSizeOf(problem()) == 1, prosac == pNapsac)
        << "P-NAPSAC draws neighbors only if a sample has several points";
    EXPECT_GT(goodPart(scene, pNapsac), 0.4);
}

TEST_P(UsacEffects, scores_and_scoreOrder)
{
    const Scene scene = makeScene(problem(), 60, 240, 3);
    Params params, none;
    params.orderedEvery = none.orderedEvery = 1;
    params.sampler = none.sampler = SAMPLER_PROSAC;
    for (int i = 0; i < scene.size(); ++i)
        params.scores.push_back(scene.truth[i] ? 0.4f : 0.8f);
    EXPECT_EQ(1, goodPart(scene, samplesOf(scene, params, 50)));
    params.scoreOrder = SCORES_HIGHER_IS_BETTER;
    EXPECT_EQ(0, goodPart(scene, samplesOf(scene, params, 50)));
    EXPECT_NE(samplesOf(scene, params), samplesOf(scene, none));
    params.ordering = ORDERING_DENSITY;
    none.ordering = ORDERING_DENSITY;
    EXPECT_EQ(samplesOf(scene, none), samplesOf(scene, params))
        << "the ordering decides whether scores are used";
    params.ordering = ORDERING_AUTO;
    params.scoreOrder = SCORES_LOWER_IS_BETTER;
    for (int i = 0; i < scene.size(); i += 3)
        params.scores[i] = std::numeric_limits<float>::quiet_NaN();
    const std::vector<int> rows = samplesOf(scene, params, 20);
    for (size_t i = 0; i < rows.size(); ++i)
        EXPECT_NE(0, rows[i] % 3) << "a match whose score is NaN must come last";
}

//! If scores are given, they determine the order even for a preset whose ordering is
//! ORDERING_INPUT_ORDER.
TEST_P(UsacEffects, scores_beside_the_input_order)
{
    const Scene scene = makeScene(problem(), 60, 240, 3);
    const Params presets[] = {Params::sorted(), Params::prosac(), Params::usac2013(),
                              Params::fromMethod(USACV20_PROSAC)};
    for (const Params& preset : presets)
    {
        Params params = preset;
        params.degeneracy = Params().degeneracy;  // for some problems, DEGENSAC raises an exception
        params.orderedEvery = 1;
        EXPECT_EQ((int)ORDERING_INPUT_ORDER, params.ordering);
        EXPECT_LT(goodPart(scene, samplesOf(scene, params, 50)), 0.7) << "the rows are not sorted";
        for (int i = 0; i < scene.size(); ++i)
            params.scores.push_back(scene.truth[i] ? 0.4f : 0.8f);
        EXPECT_EQ(1, goodPart(scene, samplesOf(scene, params, 50)));
        const std::vector<int> rows = samplesOf(scene, params);
        params.ordering = ORDERING_AUTO;
        EXPECT_EQ(samplesOf(scene, params), rows);
    }
}

//! The points are in the order of the caller, true matches first. One sample in `orderedEvery` must
//! be from the first points, which are all true. The others must be uniform, as must the first 8
//! samples unless all samples follow the order.
TEST_P(UsacEffects, orderedEvery)
{
    const Scene scene = sorted(makeScene(problem(), 60, 240, 3));
    const int m = sampleSizeOf(problem());
    Params params;
    params.ordering = ORDERING_INPUT_ORDER;
    params.sampler = SAMPLER_PROSAC;
    for (params.orderedEvery = 1; params.orderedEvery <= 8; params.orderedEvery *= 2)
    {
        const std::vector<int> rows = samplesOf(scene, params, 40);
        int good = 0;
        for (int i = 0; i < 40; ++i)
            good += goodPart(scene, std::vector<int>(rows.begin() + i * m,
                                                     rows.begin() + (i + 1) * m)) == 1;
        const int ordered = (params.orderedEvery == 1 ? 40 : 32) / params.orderedEvery;
        const double chance = m == 1 ? 0.2 : 0;  // rough probability of a uniform all-inlier sample
        EXPECT_NEAR(ordered + (40 - ordered) * chance, good, m == 1 ? 6 : 2);
    }
}

//! Params::reach is the multiple of the threshold that the search uses. The mask must always use
//! `threshold` itself, but the model must change with `reach`.
TEST_P(UsacEffects, reach)
{
    const Scene scene = makeScene(problem(), 200, 100, 3);
    Params params = Params::magsacPlusPlus();
    // rounding can change this value if it is scaled to normalized coordinates, multiplied by 4,
    // and scaled back
    params.threshold = 1.3;
    Mat masks[2], models[2];
    for (int i = 0; i < 2; ++i)
    {
        params.reach = i == 0 ? 1 : 4;
        Report report;
        models[i] = estimate(scene, params, masks[i], &report);
        EXPECT_EQ(params.threshold, report.threshold);
        EXPECT_LT(modelError(scene, models[i]), 0.8);
        checkResult(scene, params.threshold, models[i], masks[i], report);
    }
    EXPECT_FALSE(sameBits(models[0], models[1]));
}

}  // namespace
}  // namespace opencv_test
