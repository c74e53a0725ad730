// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_contracts.hpp"

#include <functional>
#include <thread>

namespace opencv_test {

const char* nameOf(ProblemType problem)
{
    static const char* names[] = {"homography", "fundamental", "essential"};
    return names[problem];
}

Matx33d sceneCamera()
{
    return makeScene(ESSENTIAL).K;
}

Mat estimatePoints(ProblemType problem, InputArray points1, InputArray points2, const Params& params,
                   OutputArray mask, Report& report, InputArray K)
{
    if (problem == HOMOGRAPHY)
        return estimateHomography(points1, points2, params, mask, report);
    if (problem == FUNDAMENTAL)
        return estimateFundamental(points1, points2, params, mask, report);
    return estimateEssential(points1, points2, K, params, mask, report);
}

bool sameBits(const Mat& a, const Mat& b)
{
    if (a.empty() || b.empty())
        return a.empty() && b.empty();
    const Mat x = a.clone(), y = b.clone();  // continuous
    return x.type() == y.type() && x.size() == y.size() && std::memcmp(x.data, y.data, x.total() * x.elemSize()) == 0;
}

namespace {

bool isFinite(double value)
{
    return value == value && std::abs(value) <= std::numeric_limits<double>::max();
}

void checkNormalisation(ProblemType problem, const Matx33d& M)
{
    for (int k = 0; k < 9; ++k)
        ASSERT_TRUE(isFinite(M.val[k]));
    if (problem == HOMOGRAPHY)
    {
        EXPECT_TRUE(M(2, 2) == 1 || std::abs(cv::norm(M) - 1) < 1e-12) << "h33 = " << M(2, 2) << ", norm " << cv::norm(M);
        EXPECT_NE(0, determinant(M));
        return;
    }
    Mat w;
    SVD::compute(Mat(M), w, SVD::NO_UV);
    EXPECT_NEAR(1, cv::norm(M), 1e-12);
    EXPECT_LE(w.at<double>(2), 1e-10) << "rank";
    if (problem == ESSENTIAL)
    {
        EXPECT_NEAR(w.at<double>(0), w.at<double>(1), 1e-10) << "singular values";
    }
    else
    {
        EXPECT_GT(w.at<double>(1), 0) << "rank";
    }
}

//! Written anew, with other operations than the module's.
double independentError(ProblemType problem, const Matx33d& M, const Point2d& p1, const Point2d& p2)
{
    const Vec3d x1(p1.x, p1.y, 1), x2(p2.x, p2.y, 1), y = M * x1;
    if (problem == HOMOGRAPHY)
        return std::hypot(y[0] / y[2] - p2.x, y[1] / y[2] - p2.y);
    const Vec3d z = M.t() * x2;
    return std::abs(x2.dot(y)) / std::hypot(std::hypot(y[0], y[1]), std::hypot(z[0], z[1]));
}

Point2d normalised(const Matx33d& K, const Point2d& p)
{
    const Vec3d x = K.inv() * Vec3d(p.x, p.y, 1);
    return Point2d(x[0] / x[2], x[1] / x[2]);
}

//! mask == (error <= threshold); only where rounding decides both are right.
void checkMask(ProblemType problem, const std::vector<Point2d>& points1, const std::vector<Point2d>& points2,
               double pixels, const Matx33d& M, const Mat& mask, const Matx33d& K)
{
    const bool essential = problem == ESSENTIAL;
    const double limit = essential ? pixels / (0.5 * (std::abs(K(0, 0)) + std::abs(K(1, 1)))) : pixels;
    int wrong = 0, row = -1;
    for (int i = 0; i < mask.rows; ++i)
    {
        const Point2d p1 = essential ? normalised(K, points1[i]) : points1[i];
        const Point2d p2 = essential ? normalised(K, points2[i]) : points2[i];
        const double error = independentError(problem, M, p1, p2);
        ASSERT_LE(mask.at<uchar>(i), 1);
        if (std::abs(error - limit) > 1e-7 * limit && (mask.at<uchar>(i) != 0) != (error <= limit))
        {
            ++wrong;
            row = i;
        }
    }
    EXPECT_EQ(0, wrong) << "rows of the mask, one of them " << row;
}

} // namespace

void checkResult(ProblemType problem, const std::vector<Point2d>& points1, const std::vector<Point2d>& points2,
                 double pixels, const Mat& model, const Mat& mask, const Report& report, const Matx33d& K)
{
    const int count = (int)points1.size();
    ASSERT_EQ(count, mask.rows);
    ASSERT_TRUE(count == 0 || mask.cols == 1);
    ASSERT_TRUE(count == 0 || mask.type() == CV_8UC1);
    EXPECT_FALSE(report.describe().empty());
    const int inliers = count ? countNonZero(mask) : 0;
    EXPECT_EQ(inliers, report.inliers);
    if (model.empty())
    {
        EXPECT_EQ(0, inliers);
        EXPECT_TRUE(report.stop == STOP_TOO_FEW_POINTS || report.stop == STOP_NO_MODEL) << report.stop;
        return;
    }
    EXPECT_GE(report.stop, STOP_MAX_ITERATIONS);
    EXPECT_GT(inliers, 0);
    EXPECT_GE(report.cost, 0);
    EXPECT_LE(report.cost, 1);
    ASSERT_EQ(Size(3, 3), model.size());
    ASSERT_EQ(CV_64FC1, model.type());
    const Matx33d M(model.ptr<double>());
    checkNormalisation(problem, M);
    checkMask(problem, points1, points2, pixels, M, mask, K);
}

void checkResult(const Scene& scene, double pixels, const Mat& model, const Mat& mask, const Report& report)
{
    checkResult(scene.problem, scene.points1, scene.points2, pixels, model, mask, report, scene.K);
}

namespace {

typedef UsacProblem UsacContracts;
INSTANTIATE_TEST_CASE_P(/**/, UsacContracts, testing::Values((int)HOMOGRAPHY, (int)FUNDAMENTAL, (int)ESSENTIAL));

std::vector<Params> allPresets()
{
    const Params presets[] = {Params::usacV20(), Params::fast(), Params::accurate(), Params::sorted(), Params::ransac(),
                              Params::parallel()};
    return std::vector<Params>(presets, presets + 6);
}

TEST_P(UsacContracts, mask_and_normalisation_of_every_preset)
{
    const double thresholds[] = {0.5, 1.5, 4};
    for (uint64 seed = 1; seed <= 6; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.outliers = (int)seed * 50 - 50;
        const Scene scene = makeScene(problem(), options);
        const std::vector<Params> presets = allPresets();
        for (size_t i = 0; i < presets.size(); ++i)
        {
            SCOPED_TRACE(cv::format("seed %d, preset %d", (int)seed, (int)i));
            Params params = presets[i];
            params.threshold = thresholds[seed % 3];
            Mat mask;
            Report report;
            const Mat model = estimate(scene, params, mask, &report);
            ASSERT_FALSE(model.empty());
            checkResult(scene, params.threshold, model, mask, report);
        }
    }
}

TEST_P(UsacContracts, mask_without_polishing_and_local_optimisation)
{
    Params params;
    params.polishing = POLISHING_NONE;
    params.localOptimization = LOCAL_OPTIMIZATION_NONE;
    const Scene scene = makeScene(problem());
    Mat mask;
    Report report;
    const Mat model = estimate(scene, params, mask, &report);
    ASSERT_FALSE(model.empty());
    checkResult(scene, params.threshold, model, mask, report);
}

TEST_P(UsacContracts, true_matches_are_found)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        const Scene scene = makeScene(problem(), options);
        Mat mask;
        const Mat model = estimate(scene, Params(), mask);
        EXPECT_LT(modelError(scene, model), 0.6) << "seed " << seed;
        int found = 0, within = 0;  // the threshold, under the true model
        for (int i = 0; i < scene.size(); ++i)
        {
            found += scene.truth[i] && mask.at<uchar>(i);
            within += scene.truth[i] &&
                      pixelError(scene, scene.model, scene.points1[i], scene.points2[i]) <= Params().threshold;
        }
        EXPECT_GT(found, 0.95 * within) << "seed " << seed;
    }
}

TEST_P(UsacContracts, same_bits_on_repeat_and_after_use_of_theRNG)
{
    const Scene scene = makeScene(problem());
    Mat mask, again;
    const Mat model = estimate(scene, Params(), mask);
    ASSERT_FALSE(model.empty());
    for (int i = 0; i < 10; ++i)
    {
        theRNG().state = 12345 + 77 * i;
        theRNG().next();
        const Mat other = estimate(scene, Params(), again);
        EXPECT_TRUE(sameBits(model, other) && sameBits(mask, again)) << "repeat " << i;
    }
    setRNGSeed(99);
    EXPECT_TRUE(sameBits(model, estimate(scene, Params(), again)));
}

TEST_P(UsacContracts, theRNG_is_not_used)
{
    const uint64 before = theRNG().state;
    estimate(makeScene(problem()), Params());
    EXPECT_EQ(before, theRNG().state);
}

struct Job
{
    void operator()() { model = estimate(*scene, params, mask); }

    const Scene* scene;
    Params params;
    Mat model, mask;
};

TEST_P(UsacContracts, same_bits_in_several_threads_at_once)
{
    SceneOptions hard;
    hard.outliers = 300;
    hard.seed = 2;
    const Scene scenes[2] = {makeScene(problem()), makeScene(problem(), hard)};
    Mat masks[2], models[2];
    for (int k = 0; k < 2; ++k)
        models[k] = estimate(scenes[k], Params(), masks[k]);
    std::vector<Job> jobs(8);
    std::vector<std::thread> threads;
    for (size_t i = 0; i < jobs.size(); ++i)
    {
        jobs[i].scene = &scenes[i % 2];
        threads.push_back(std::thread(std::ref(jobs[i])));
    }
    for (size_t i = 0; i < jobs.size(); ++i)
        threads[i].join();
    for (size_t i = 0; i < jobs.size(); ++i)
        EXPECT_TRUE(sameBits(models[i % 2], jobs[i].model) && sameBits(masks[i % 2], jobs[i].mask)) << "thread " << i;
}

TEST_P(UsacContracts, same_bits_with_any_number_of_threads)
{
    const int before = getNumThreads();
    for (uint64 seed = 1; seed <= 3; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.outliers = 250;
        const Scene scene = makeScene(problem(), options);
        Mat mask, other;
        Report report, otherReport;
        const Mat model = estimate(scene, Params(), mask, &report);
        const int threads[] = {0, 2, 3, 8};
        for (int i = 0; i < 4; ++i)
        {
            SCOPED_TRACE(cv::format("seed %d, %d threads", (int)seed, threads[i]));
            Params params;
            params.threads = threads[i];
            setNumThreads(i == 0 ? 2 : 4);
            EXPECT_TRUE(sameBits(model, estimate(scene, params, other, &otherReport)));
            EXPECT_TRUE(sameBits(mask, other));
            EXPECT_EQ(report.iterations, otherReport.iterations);
            EXPECT_EQ(report.stop, otherReport.stop);
        }
    }
    setNumThreads(before);
}

TEST_P(UsacContracts, input_is_not_modified)
{
    const Scene scene = makeScene(problem());
    const Mat points1 = Mat(scene.points1).clone(), points2 = Mat(scene.points2).clone();
    Mat used1 = points1.clone(), used2 = points2.clone(), K = Mat(sceneCamera()), mask;
    Report report;
    Params params;
    params.scores.assign(scene.size(), 1.f);
    estimatePoints(problem(), used1, used2, params, mask, report, K);
    EXPECT_TRUE(sameBits(points1, used1));
    EXPECT_TRUE(sameBits(points2, used2));
    EXPECT_TRUE(sameBits(Mat(sceneCamera()), K));
}

TEST(Usac_Contracts, homography_with_h33_zero)
{
    // x1 = 0 goes to infinity: a valid homography whose h33 is 0
    const Matx33d H(200, 30, 1e5, -20, 250, 8e4, 1, 0.2, 0);
    RNG rng(3);
    std::vector<Point2d> points1, points2;
    for (int i = 0; i < 100; ++i)
    {
        const Vec3d x(rng.uniform(100., 600.), rng.uniform(0., 480.), 1), y = H * x;
        points1.push_back(Point2d(x[0], x[1]));
        points2.push_back(Point2d(y[0] / y[2], y[1] / y[2]));
    }
    Mat mask;
    Report report;
    const Mat model = estimateHomography(points1, points2, Params(), mask, report);
    ASSERT_FALSE(model.empty());
    checkResult(HOMOGRAPHY, points1, points2, Params().threshold, model, mask, report);
    EXPECT_EQ(100, countNonZero(mask));
}

TEST(Usac_Contracts, essential_of_two_cameras_with_distortion)
{
    const Scene scene = makeScene(ESSENTIAL);
    const Matx33d K2(700, 0, 300, 0, 720, 250, 0, 0, 1);
    const Vec<double, 5> d1(-0.1, 0.02, 0.001, 0, 0), d2(0.05, -0.01, 0, 0.001, 0);
    std::vector<Point2d> points1(scene.points1.size()), points2(points1.size()), plane1, plane2;
    undistortPoints(scene.points1, plane1, scene.K, noArray());
    undistortPoints(scene.points2, plane2, scene.K, noArray());
    std::vector<Point3d> rays1, rays2;
    convertPointsToHomogeneous(plane1, rays1);
    convertPointsToHomogeneous(plane2, rays2);
    projectPoints(rays1, Vec3d(), Vec3d(), scene.K, d1, points1);
    projectPoints(rays2, Vec3d(), Vec3d(), K2, d2, points2);
    Mat mask;
    Report report;
    const Mat E = estimateEssential(points1, points2, scene.K, K2, d1, d2, Params(), mask, report);
    EXPECT_LT(modelError(scene, E), 0.6);
    // the mask is that of the undistorted points, with the mean of the four focal lengths
    undistortPoints(points1, plane1, scene.K, d1);
    undistortPoints(points2, plane2, K2, d2);
    const double mean = (600 + 600 + 700 + 720) / 4.;
    checkResult(ESSENTIAL, plane1, plane2, Params().threshold / mean, E, mask, report, Matx33d::eye());
    EXPECT_GT(countNonZero(mask), 150);
}

}} // namespace
