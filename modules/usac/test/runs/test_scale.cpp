// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"
#include "support/process_memory.hpp"

// Tests with many points and with many calls. Times are not tested, only printed with
// --test_debug=1.

namespace opencv_test {
namespace {

Scene largeScene(ProblemType problem, int size)
{
    SceneOptions options;
    options.setSize(size, 0.5);
    return makeScene(problem, options);
}

//! Time, memory and report of one estimation.
struct Cost
{
    Report report;
    double bytes, milliseconds;  //!< bytes: peak of the memory beyond that of the input
};

Cost costOf(const Scene& scene, const Params& params)
{
    Cost cost;
    Mat mask;
    const PeakMemory peak;
    const int64 start = getTickCount();
    const Mat model = estimate(scene, params, mask, &cost.report);
    cost.milliseconds = (getTickCount() - start) / getTickFrequency() * 1e3;
    cost.bytes = peak.bytes();
    EXPECT_LT(modelError(scene, model), 0.1);
    EXPECT_EQ(countNonZero(mask), cost.report.inliers);
    EXPECT_GT(cost.report.inliers, 0.44 * scene.size());
    if (cvtest::debugLevel > 0)
        printf("%s, %7d points: %8.1f ms (setup %.1f, search %.1f, local %.1f, end %.1f), %6.1f "
               "MB, %3.0f bytes a "
               "point, %d iterations\n",
               nameOf(scene.problem), scene.size(), cost.milliseconds, cost.report.setupMs,
               cost.report.searchMs, cost.report.localMs, cost.report.polishMs, cost.bytes / 1e6,
               cost.bytes / scene.size(), cost.report.iterations);
    return cost;
}

typedef UsacProblem UsacScale;
INSTANTIATE_TEST_CASE_P(/**/, UsacScale, testing::ValuesIn(TWO_VIEW_PROBLEMS));

TEST_P(UsacScale, million_points)
{
    const double BYTES = 300;  // per point; about 200 are needed
    const bool measurable = memoryIsMeasurable();
    int iterations = 0, localOptimizations = 0;
    for (int size = 10000; size <= 1000000; size *= 10)
    {
        SCOPED_TRACE(cv::format("%d points", size));
        const Cost cost = costOf(largeScene(problem(), size), Params());
        if (measurable && size >= 100000)
        {
            EXPECT_LE(cost.bytes, BYTES * size);
        }
        if (size == 10000)
        {
            iterations = cost.report.iterations;
            localOptimizations = cost.report.localOptimizations;
        }
        EXPECT_LE(cost.report.iterations, 2 * iterations + 100)
            << "the number of samples must not grow with the number of points";
        EXPECT_LE(cost.report.localOptimizations, 2 * localOptimizations + 10);
    }
}

//! Counts the points whose errors are computed. Fused kernels (loops that compute errors and scores
//! together) do not bypass this residual, because it is not a built-in one.
class CountingResidual : public Residual
{
public:
    explicit CountingResidual(const Ptr<Residual>& residual_) : count(0), residual(residual_) {}

    void squaredErrors(const Correspondences& points, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        count += end - begin;
        residual->squaredErrors(points, model, begin, end, errors);
    }

    void squaredErrors(const Model& model, const double* const* columns, int size,
                       double* errors) const CV_OVERRIDE
    {
        count += size;
        residual->squaredErrors(model, columns, size, errors);
    }

    mutable double count;

private:
    const Ptr<Residual> residual;
};

//! Counts the points that models are fitted to.
class CountingSolver : public NonMinimalSolver
{
public:
    explicit CountingSolver(const Ptr<NonMinimalSolver>& solver_) : count(0), solver(solver_) {}

    bool fit(const Correspondences& points, const int* indices, int size, const double* weights,
             Model& model, int iterations) const CV_OVERRIDE
    {
        count += size;
        return solver->fit(points, indices, size, weights, model, iterations);
    }

    mutable double count;

private:
    const Ptr<NonMinimalSolver> solver;
};

//! How many times each point is rated, plus how many times it is used in fits, on average. The
//! number varies with the seed.
double workPerPoint(ProblemType problem, const NamedPreset& preset, int size, uint64 seed)
{
    Params params = preset.params;
    params.threads = 1;
    params.seed = seed;
    const Scene scene = largeScene(problem, size);
    const Ptr<Usac> usac = createUsac(scene, params);
    const Ptr<CountingResidual> residual = makePtr<CountingResidual>(usac->components().residual);
    const Ptr<CountingSolver> solver = makePtr<CountingSolver>(usac->components().nonMinimalSolver);
    usac->components().residual = residual;
    usac->components().nonMinimalSolver = solver;
    EXPECT_FALSE(usac->run().empty());
    if (cvtest::debugLevel > 0)
        printf("%s, %s, %d points: each is rated %.1f times and used in %.1f fits\n",
               nameOf(problem), preset.name, size, residual->count / size, solver->count / size);
    return (residual->count + solver->count) / size;
}

TEST_P(UsacScale, work_is_linear)
{
    const std::vector<NamedPreset> presets = allPresets(problem());
    for (size_t p = 0; p < presets.size(); ++p)
    {
        if (presets[p].params.termination & TERMINATION_PROSAC)
            continue;  // PROSAC's criterion waits until its subset has grown, so that the number of
                       // samples depends on N
        double few = 0, many = 0;
        for (uint64 seed = 0; seed < 5; ++seed)
        {
            few += workPerPoint(problem(), presets[p], 1000, seed);
            many += workPerPoint(problem(), presets[p], 10000, seed);
        }
        EXPECT_LT(many, 3 * few) << presets[p].name;
    }
}

//! Memory must be at most 600 bytes per point with every neighborhood, even if thousands of points
//! are within the largest radius (that of the coarsest layer) around a point.
TEST_P(UsacScale, memory_of_every_neighborhood)
{
    if (!memoryIsMeasurable())
        USAC_SKIP("the memory of the process is not measurable");
    const Scene scene = largeScene(problem(), 30000);
    for (NeighborhoodType type : {NEIGHBORHOOD_GRID, NEIGHBORHOOD_KNN, NEIGHBORHOOD_RADIUS})
    {
        SCOPED_TRACE(cv::format("neighborhood %d", type));
        Params params;
        params.neighborhood = type;
        EXPECT_LE(costOf(scene, params).bytes, 600. * scene.size());
    }
}

//! Memory must grow by at most 1 MB over many calls with all two-view problems and all presets.
void manyCalls(int count)
{
    if (!memoryIsMeasurable())
        USAC_SKIP("the memory of the process is not measurable");
    std::vector<Scene> scenes;
    SceneOptions options;
    options.inliers = 40;
    options.outliers = 10;
    for (int problem : TWO_VIEW_PROBLEMS)
        scenes.push_back(makeScene((ProblemType)problem, options));
    const std::vector<NamedPreset> presets = allPresets(AFFINITY);  // valid for all problems
    const int warmUp = 500;
    double before = 0;
    for (int i = 0; i < warmUp + count; ++i)
    {
        if (i == warmUp)
            before = residentBytes();
        Params params = presets[i % presets.size()].params;
        params.maxIterations = 50;
        params.seed = i;
        Mat mask;
        estimate(scenes[i % scenes.size()], params, mask);
    }
    const double growth = residentBytes() - before;
    if (cvtest::debugLevel > 0)
        printf("%d calls: memory has grown by %.0f bytes from %.1f MB\n", count, growth,
               before / 1e6);
    EXPECT_LE(growth, 1e6);
}

TEST(Usac_Scale, five_thousand_calls) { manyCalls(5000); }

//! Run with --gtest_filter=*hundred_thousand_calls* --test_tag_enable=verylong.
TEST(Usac_Scale, hundred_thousand_calls)
{
    applyTestTag(CV_TEST_TAG_VERYLONG);
    manyCalls(100000);
}

}
}  // namespace
