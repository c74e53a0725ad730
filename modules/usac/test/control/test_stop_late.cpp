// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include <ctime>
#include "test_precomp.hpp"
#include "control/watch.hpp"

// Tests of how long a run of a million points continues after Params::maxTime or after the progress
// function (ProgressScope) has returned false.

namespace opencv_test {
namespace {

//! Milliseconds of processor time, which other programs hardly affect. LATE is the longest delay
//! allowed, in milliseconds: 100 ms are documented, and the factor of 2 allows for caches shared
//! with other programs.
double processorTime() { return 1e3 * std::clock() / CLOCKS_PER_SEC; }
const double LATE = 200;

Params presetOfMany(int preset)
{
    return preset == 0   ? Params()
           : preset == 1 ? Params::gcRansac()
           : preset == 2 ? Params::usac2013()
                         : Params::magsac();
}

//! For a million points, each of these steps can take longer than the documented delay of 100 ms:
//! the neighborhoods, the order of the points, PROSAC's termination criterion, Report::chance and
//! the independent inliers. The run must nevertheless end in time.
TEST(Usac_StopLate, a_million_points)
{
    for (int problem : {(int)HOMOGRAPHY, (int)FUNDAMENTAL, (int)ESSENTIAL})
        for (double ratio : {0.5, 0.})
        {
            SceneOptions options;
            options.setSize(1000000, ratio);
            const Scene scene = makeScene((ProblemType)problem, options);
            for (int preset = 0; preset < 4; ++preset)
            {
                SCOPED_TRACE(
                    cv::format("problem %d, preset %d, %g right matches", problem, preset, ratio));
                Params params = presetOfMany(preset);
                params.maxIterations = INT_MAX;
                params.maxTime = 400;
                const Ptr<Usac> usac = createUsac(scene, params);
                const double start = processorTime();
                Mat mask;
                Report report;
                const Mat model = usac->run(mask, &report);
                EXPECT_LE(processorTime() - start, params.maxTime + LATE) << report.describe();
                EXPECT_EQ(report.inliers, countNonZero(mask));
                EXPECT_EQ(model.empty(), report.inliers == 0);
                EXPECT_TRUE(!model.empty() || report.stop == (int)STOP_TIME) << report.describe();
            }
        }
}

//! A table of the cells of a million points on an integer grid must not have long clusters, since
//! counting the independent inliers is not interrupted.
TEST(Usac_StopLate, a_million_points_on_a_grid)
{
    std::vector<Point2d> points1, points2;
    for (int i = 0; i < 1000000; ++i)
    {
        points1.push_back(Point2d(i % 1000, i / 1000));
        points2.push_back(points1.back() + Point2d(20, 30));
    }
    Params params;
    params.maxTime = 1000;
    const Ptr<Usac> usac = Usac::create(TRANSLATION_2D, points1, points2, params);
    const double start = processorTime();
    Report report;
    usac->run(noArray(), &report);
    EXPECT_LE(processorTime() - start, params.maxTime + LATE) << report.describe();
    EXPECT_EQ(1000000, report.inliers);
}

class CountingOrder : public Ordering
{
public:
    CountingOrder() : calls(0) {}
    void sort(const Context&, int*) CV_OVERRIDE { ++calls; }

    int calls;
};

//! Sorting a million points takes 130 ms. If less time is left, this step must be skipped, but the
//! run must not end, because it has time for other steps.
TEST(Usac_StopLate, no_time_for_the_order)
{
    Correspondences points = Correspondences();
    points.size = 1000000;
    const Ptr<CountingOrder> order = makePtr<CountingOrder>();
    Components parts;
    parts.ordering = order;
    const Params params;
    Arena arena;
    for (int enough = 0; enough < 2; ++enough)
    {
        Watch watch(enough ? 1e6 : 100, 0);
        State state;
        const Context context(points, parts, params, arena, &watch);
        const int* const sorted = state.bestFirst(context);
        EXPECT_EQ(enough, order->calls);
        EXPECT_EQ(999999, sorted[999999]);
        EXPECT_FALSE(watch.stopped());
    }
}

//! The same test as `a_million_points`, but the progress function ends the run by returning false.
//! This cannot be foreseen, so that the run cannot skip long steps as it does with a time limit.
TEST(Usac_StopLate, a_million_points_cancelled)
{
    for (int problem : {(int)HOMOGRAPHY, (int)FUNDAMENTAL})
    {
        SceneOptions options;
        options.setSize(1000000, 0.5);
        const Scene scene = makeScene((ProblemType)problem, options);
        for (int preset = 0; preset < 4; ++preset)
        {
            Params params = presetOfMany(preset);
            params.maxIterations = INT_MAX;
            params.termination = 0;
            const Ptr<Usac> usac = createUsac(scene, params);
            double said = 0;
            const ProgressScope scope([&](const Report& now) {
                said = processorTime();
                return now.localOptimizations == 0 && now.iterations < 50;
            });
            Report report;
            usac->run(noArray(), &report);
            EXPECT_EQ((int)STOP_CANCELLED, report.stop);
            EXPECT_LE(processorTime() - said, LATE) << problem << " " << preset;
        }
    }
}

//! Fits and refinements of a million points must end in time, too, with the best model so far.
TEST(Usac_StopLate, aMillionPointsWithoutASearch)
{
    for (int problem : {(int)HOMOGRAPHY, (int)FUNDAMENTAL, (int)ESSENTIAL})
    {
        SceneOptions options;
        options.setSize(1000000, 0.5);
        const Scene scene = makeScene((ProblemType)problem, options);
        Params params;
        const Mat known = estimate(scene, params), all = Mat::ones(1000000, 1, CV_8U);
        for (int limited = 0; limited < 2; ++limited)
            for (int method = 0; method < 3; ++method)
            {
                SCOPED_TRACE(cv::format("problem %d, %d, %d", problem, limited, method));
                params.maxTime = limited ? 1 : 0;
                const Ptr<Usac> usac = createUsac(scene, params);
                double said = processorTime();
                const ProgressScope scope([&](const Report&) {
                    said = processorTime();
                    return limited > 0;
                });
                Report report;
                const Mat model = method == 0 ? usac->fit(noArray(), noArray(), noArray(), &report)
                                              : usac->refine(known, method == 1 ? all : Mat(),
                                                             noArray(), &report);
                EXPECT_EQ(limited ? (int)STOP_TIME : (int)STOP_CANCELLED, report.stop);
                EXPECT_LE(processorTime() - said, LATE);
                EXPECT_FALSE(model.empty());
            }
    }
}

}  // namespace
}  // namespace opencv_test
