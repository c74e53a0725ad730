// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include "test_precomp.hpp"
#include "opencv2/usac/batch.hpp"

// Tests of runs that end early, by Params::maxTime or a ProgressScope.

namespace opencv_test {
namespace {

typedef std::chrono::steady_clock Clock;

double millisecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

//! Allowed delay of the end of a run in milliseconds. It is so long because a busy machine can
//! suspend the process.
const double SLACK = 400;

//! A scene with 5 % inliers. With the parameters endless(), the search for F would take minutes.
Scene hardScene(ProblemType problem, int size = 2000)
{
    SceneOptions options;
    options.setSize(size, 0.05);
    return makeScene(problem, options);
}

Params endless(ProblemType problem)
{
    Params params;
    params.maxIterations = INT_MAX;
    params.confidence = 1 - 1e-15;
    params.persistence = 100;
    if (problem != FUNDAMENTAL && problem != ESSENTIAL)
        params.termination = 0;  // no criterion ends the search before maxIterations
    return params;
}

bool sameResult(const Mat& a, const Mat& b)
{
    return a.size() == b.size() && (a.empty() || cv::norm(a, b, NORM_INF) == 0);
}

class UsacStop : public testing::TestWithParam<int>
{
public:
    ProblemType problem() const { return (ProblemType)GetParam(); }
};
INSTANTIATE_TEST_CASE_P(/**/, UsacStop, testing::ValuesIn(TWO_VIEW_PROBLEMS));

TEST_P(UsacStop, time_limit_holds)
{
    for (int threads : {1, 3})
    {
        const Scene scene = hardScene(problem());
        Params params = endless(problem());
        params.threads = threads;
        params.maxTime = 50;
        Mat mask;
        Report report;
        const Clock::time_point start = Clock::now();
        const Mat model = estimate(scene, params, mask, &report);
        const double time = millisecondsSince(start);
        EXPECT_EQ((int)STOP_TIME, report.stop) << report.describe();
        EXPECT_GE(time, 50);
        EXPECT_LE(time, 50 + SLACK);
        EXPECT_GT(report.iterations, 0);
        EXPECT_EQ(report.inliers, countNonZero(mask));
        EXPECT_EQ(model.empty(), report.inliers == 0);
    }
}

TEST_P(UsacStop, what_is_found_by_then_is_returned)
{
    SceneOptions options;
    options.setSize(1000, 0.7);
    const Scene scene = makeScene(problem(), options);
    Params params = endless(problem());
    params.termination = 0;  // with so many inliers, the criteria would soon end the search
    params.maxTime = 100;
    Report report;
    const Mat model = estimate(scene, params, noArray(), &report);
    EXPECT_EQ((int)STOP_TIME, report.stop) << report.describe();
    ASSERT_FALSE(model.empty());
    EXPECT_LT(modelError(scene, model), 0.5);
}

TEST_P(UsacStop, callback_sees_the_search_go_on)
{
    const Scene scene = hardScene(problem());
    std::vector<Report> seen;
    Report report;
    {
        const ProgressScope scope([&](const Report& now) {
            seen.push_back(now);
            return seen.size() < 10;
        });
        estimate(scene, endless(problem()), noArray(), &report);
    }
    EXPECT_EQ((int)STOP_CANCELLED, report.stop) << report.describe();
    ASSERT_EQ(10u, seen.size());
    for (size_t i = 0; i < seen.size(); ++i)
    {
        EXPECT_EQ((int)STOP_NOT_RUN, seen[i].stop);
        EXPECT_TRUE(seen[i].cost >= 0 && seen[i].cost <= 1) << seen[i].cost;
        EXPECT_TRUE(seen[i].inlierRatio >= 0 && seen[i].inlierRatio <= 1) << seen[i].inlierRatio;
        EXPECT_TRUE(seen[i].searchMs >= 5) << seen[i].searchMs;
        EXPECT_TRUE(seen[i].localMs >= 0) << seen[i].localMs;
        EXPECT_FALSE(i > 0 && seen[i].iterations < seen[i - 1].iterations);
    }
    EXPECT_GT(seen.back().iterations, seen.front().iterations);
}

TEST_P(UsacStop, exception_of_the_callback_comes_out)
{
    const Scene scene = hardScene(problem());
    Params params = endless(problem());
    const Ptr<Usac> usac = createUsac(scene, params);
    for (int i = 0; i < 2; ++i)
    {
        const ProgressScope scope(
            [](const Report&) -> bool { throw std::runtime_error("enough"); });
        EXPECT_THROW(usac->run(), std::runtime_error);
    }
    params.maxIterations = 200;
    params.persistence = 1;
    const Ptr<Usac> other = createUsac(scene, params);
    Mat mask, expectedMask;
    const Mat expected = other->run(expectedMask);
    EXPECT_THROW(
        {
            const ProgressScope scope([](const Report&) -> bool { throw 1; });
            usac->run();
        },
        int);
    EXPECT_TRUE(sameResult(expected, other->run(mask)));
    EXPECT_TRUE(sameResult(expectedMask, mask));
    Report report;
    const ProgressScope scope([](const Report&) { return false; });
    // `usac`, whose run was ended by the exception, must be usable again
    EXPECT_NO_THROW(usac->run(mask, &report));
    EXPECT_EQ((int)STOP_CANCELLED, report.stop);
}

//! A time limit that is not reached and a progress function that always returns true must not
//! change any bit of the result.
TEST_P(UsacStop, same_bits_when_it_goes_on)
{
    for (int threads : {1, 3})
        for (int size : {100, 3000})
        {
            SceneOptions options;
            options.setSize(size, 0.3);
            const Scene scene = makeScene(problem(), options);
            Params params;
            params.threads = threads;
            Mat mask, watchedMask;
            Report report, watched;
            const Mat model = estimate(scene, params, mask, &report);
            params.maxTime = 1e9;
            int asked = 0;
            const ProgressScope scope([&](const Report&) { return ++asked > 0; });
            const Mat same = estimate(scene, params, watchedMask, &watched);
            EXPECT_TRUE(sameResult(model, same));
            EXPECT_TRUE(sameResult(mask, watchedMask));
            EXPECT_EQ(report.iterations, watched.iterations);
            EXPECT_EQ(report.stop, watched.stop);
            EXPECT_EQ(report.chance, watched.chance);
        }
}

TEST(Usac_Stop, another_thread_cancels)
{
    for (int threads : {1, 2})
    {
        const Scene scene = hardScene(FUNDAMENTAL);
        Params params = endless(FUNDAMENTAL);
        params.threads = threads;
        std::atomic<bool> cancelled(false);
        std::thread other([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(30));
            cancelled = true;
        });
        const Clock::time_point start = Clock::now();
        Report report;
        {
            const ProgressScope scope([&](const Report&) { return !cancelled; });
            estimate(scene, params, noArray(), &report);
        }
        other.join();
        EXPECT_EQ((int)STOP_CANCELLED, report.stop);
        EXPECT_LE(millisecondsSince(start), 30 + SLACK);
    }
}

//! Scopes can end in any order. The functions of those that remain must still be called, the
//! innermost first.
TEST(Usac_Stop, scopesEndInAnyOrder)
{
    const Scene scene = hardScene(HOMOGRAPHY);
    Params params = endless(HOMOGRAPHY);
    params.maxTime = 30;
    int order[] = {0, 1, 2};
    do
    {
        std::string called;
        std::unique_ptr<ProgressScope> scopes[3];
        for (int k = 0; k < 3; ++k)
            scopes[k].reset(new ProgressScope([&called, k](const Report&) {
                called += (char)('0' + k);
                return true;
            }));
        std::string expected = "210";
        for (int left = 3; left >= 0; --left)
        {
            called.clear();
            estimate(scene, params);
            EXPECT_EQ(expected, called.substr(0, left)) << order[0] << order[1] << order[2];
            EXPECT_EQ(expected.empty(), called.empty());
            if (left == 0)
                break;
            const int ended = order[3 - left];
            scopes[ended].reset();
            expected.erase(expected.find((char)('0' + ended)), 1);
        }
    } while (std::next_permutation(order, order + 3));
}

//! Ends a scope when the first sample is drawn.
class EndingSampler : public Sampler
{
public:
    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        scope.reset();
        state.rng.distinct(context.points.size, 4, sample);
    }

    std::unique_ptr<ProgressScope> scope;
};

//! A component can end a scope of its own run. The run must then go on without the scope.
TEST(Usac_Stop, scopeEndsDuringTheRun)
{
    Params params = endless(HOMOGRAPHY);
    params.maxTime = 50;
    const Ptr<Usac> usac = createUsac(hardScene(HOMOGRAPHY), params);
    const Ptr<EndingSampler> sampler = makePtr<EndingSampler>();
    usac->components().sampler = sampler;
    int calls = 0;
    sampler->scope.reset(new ProgressScope([&calls](const Report&) { return ++calls < 0; }));
    Report report;
    usac->run(noArray(), &report);
    EXPECT_EQ((int)STOP_TIME, report.stop);
    EXPECT_EQ(0, calls);
}

//! With many points, the search uses only a random subset. The inlier ratio and the cost that the
//! progress function gets must refer to this subset, not to the number of all points.
TEST(Usac_Stop, progressOfManyPoints)
{
    SceneOptions options;
    options.setSize(200000, 0.9);
    const Scene scene = makeScene(ESSENTIAL, options);
    int models = 0;
    const ProgressScope scope([&](const Report& report) {
        if (report.inliers == 0)
            return true;
        ++models;
        EXPECT_GT(report.inlierRatio, 0.6);
        EXPECT_LT(report.cost, 0.8);
        return true;
    });
    // repeated, because a run can end before the function is called with a model
    for (int run = 0; run < 20 && models == 0; ++run)
        EXPECT_FALSE(estimate(scene, Params()).empty());
    EXPECT_GT(models, 0);
}

TEST(Usac_Stop, batches)
{
    const Scene hard = hardScene(FUNDAMENTAL, 500);
    for (int threads : {1, 2, 0})
    {
        std::vector<Task> tasks;
        for (int i = 0; i < 6; ++i)
            tasks.push_back(
                Task(FUNDAMENTAL, Mat(hard.points1), Mat(hard.points2), endless(FUNDAMENTAL)));
        const Clock::time_point start = Clock::now();
        std::vector<Estimate> found;
        const std::thread::id caller = std::this_thread::get_id();
        bool elsewhere = false;
        {
            const ProgressScope scope([&](const Report&) {
                elsewhere = elsewhere || std::this_thread::get_id() != caller;
                return millisecondsSince(start) < 30;
            });
            found = estimateBatch(tasks, threads);
        }
        EXPECT_LE(millisecondsSince(start), 30 + SLACK);
        EXPECT_FALSE(elsewhere);
        ASSERT_EQ(tasks.size(), found.size());
        for (const Estimate& one : found)
            EXPECT_EQ((int)STOP_CANCELLED, one.report.stop) << one.error;
        const ProgressScope scope(
            [](const Report&) -> bool { throw std::runtime_error("enough"); });
        EXPECT_THROW(estimateBatch(tasks, threads), std::runtime_error);
    }
}

//! Each task takes less time than passes between two calls of the progress function. A batch must
//! nevertheless call this function, and must end after the third call, which returns false.
TEST(Usac_Stop, batches_of_short_tasks)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    std::vector<Task> tasks(20000,
                            Task(HOMOGRAPHY, Mat(scene.points1), Mat(scene.points2), Params()));
    int asked = 0;
    const ProgressScope scope([&](const Report& report) {
        EXPECT_EQ(report.inliers == 0, report.cost == 1) << "without a model, the cost must be 1";
        return ++asked < 3;
    });
    const std::vector<Estimate> found = estimateBatch(tasks, 1);
    EXPECT_EQ(3, asked);
    EXPECT_FALSE(found.front().model.empty());
    EXPECT_TRUE(found.back().model.empty());
    EXPECT_EQ((int)STOP_CANCELLED, found.back().report.stop);
}

TEST(Usac_Stop, what_the_caller_does_before_does_not_count)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    Params params;
    params.maxTime = 1000;
    const Ptr<Usac> usac = createUsac(scene, params);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    Report report;
    EXPECT_FALSE(usac->run(noArray(), &report).empty());
    EXPECT_NE((int)STOP_TIME, report.stop);
    EXPECT_LT(report.setupMs, 1000);
}

TEST(Usac_Stop, time_over_before_the_first_sample)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    Params params;
    params.maxTime = 1e-6;
    Mat mask;
    Report report;
    EXPECT_NO_THROW(estimate(scene, params, mask, &report));
    EXPECT_EQ(report.inliers, countNonZero(mask));
    EXPECT_EQ(scene.size(), mask.rows);
    for (double wrong : {-1., 2e9, (double)NAN})
    {
        params.maxTime = wrong;
        try
        {
            params.check();
            ADD_FAILURE() << wrong;
        }
        catch (const cv::Exception& mistake)
        {
            EXPECT_NE(std::string::npos, mistake.err.find("maxTime")) << mistake.err;
        }
    }
}

}  // namespace
}  // namespace opencv_test
