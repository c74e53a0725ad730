// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/absolute_pose/pose_scenes.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"

// Tests of the functions that do not search (fitModel, refineModel and modelErrors), of
// estimateModel, of Report::sample and Report::inlierRatio, and of the argument order of Python.

namespace opencv_test {
namespace {

//! Matches of any problem, with their camera and distortion; `truth` is 1 for correct matches.
struct Matches
{
    explicit Matches(ProblemType problem_, double noise = 0, double inlierRatio = 1,
                     uint64 seed = 1)
        : problem(problem_)
    {
        params.threshold = problem == RIGID_3D || problem == SIMILARITY_3D ? 0.05 : 1.5;
        if (problem == ABSOLUTE_POSE)
        {
            PoseSceneOptions options;
            options.inlierRatio = inlierRatio;
            options.noise = noise;
            options.coefficients = 5;
            options.seed = seed;
            const PoseScene scene = makePoseScene(options);
            first = column(scene.object).clone();
            second = column(scene.image).clone();
            K = Mat(scene.K);
            lens = Mat(scene.distortion).clone();
            truth = scene.truth;
        }
        else if (problem == RIGID_3D || problem == SIMILARITY_3D)
        {
            RigidSceneOptions options;
            options.inlierRatio = inlierRatio;
            options.noise = noise / 50;
            options.seed = seed;
            options.modelScale = problem == SIMILARITY_3D ? 1.7 : 1;
            const RigidScene scene = makeRigidScene(options);
            first = column(scene.points1).clone();
            second = column(scene.points2).clone();
            truth = scene.truth;
        }
        else
        {
            SceneOptions options;
            options.setSize(200, inlierRatio);
            options.noise = noise;
            options.seed = seed;
            const Scene scene = makeScene(problem, options);
            first = column(scene.points1).clone();
            second = column(scene.points2).clone();
            truth = scene.truth;
            if (problem == ESSENTIAL)
                K = Mat(scene.K);
        }
    }

    Mat fit(Report& report, InputArray weights = noArray(), InputArray chosen = noArray(),
            OutputArray mask = noArray()) const
    {
        return fitModel(problem, first, second, params, mask, report, weights, chosen, K, noArray(),
                        lens);
    }
    Mat refine(InputArray model, Report& report, InputArray chosen = noArray(),
               OutputArray mask = noArray()) const
    {
        return refineModel(problem, model, first, second, params, mask, report, chosen, K,
                           noArray(), lens);
    }
    Mat errors(InputArray model) const
    {
        return modelErrors(problem, model, first, second, params, K, noArray(), lens);
    }
    Mat run(OutputArray mask, Report& report) const
    {
        return Usac::create(problem, first, second, params, K, noArray(), lens)->run(mask, &report);
    }

    ProblemType problem;
    Params params;
    Mat first, second, K, lens;
    std::vector<uchar> truth;
};

double sumOfSquares(const Mat& errors, const std::vector<uchar>& which)
{
    double sum = 0;
    for (int i = 0; i < errors.rows; ++i)
        sum += which[i] ? errors.at<double>(i) * errors.at<double>(i) : 0;
    return sum;
}

class UsacGiven : public testing::TestWithParam<int>
{
public:
    ProblemType problem() const { return (ProblemType)GetParam(); }
};
INSTANTIATE_TEST_CASE_P(/**/, UsacGiven, testing::ValuesIn(ALL_PROBLEMS));

//! estimateModel() must give the result of Usac::create and Usac::run. Its messages use the
//! argument names points1 and points2 for all problems.
TEST_P(UsacGiven, estimateModel)
{
    const Matches matches(problem(), 1, 0.6);
    Mat mask, other;
    Report report;
    const Mat model = estimateModel(problem(), matches.first, matches.second, matches.params, mask,
                                    report, matches.K, noArray(), matches.lens);
    const Mat expected = matches.run(other, report);
    ASSERT_FALSE(expected.empty());
    EXPECT_EQ(0, cvtest::norm(expected, model, NORM_INF));
    EXPECT_EQ(0, cvtest::norm(mask, other, NORM_INF));
    try
    {
        estimateModel(problem(), matches.first.rowRange(0, 20), matches.second, matches.params,
                      mask, report, matches.K, noArray(), matches.lens);
        FAIL();
    }
    catch (const cv::Exception& mistake)
    {
        EXPECT_EQ(0u, mistake.err.find("points1 and points2: ")) << mistake.err;
    }
}

//! Programs store the numbers of ProblemType in files. The table registry.inl.hpp, from which
//! ALL_PROBLEMS is generated, must therefore list all problems in the order of their numbers 0, 1,
//! 2, and so on. The next number must raise an exception.
TEST(Usac_Given, problemsAreNumberedInTheOrderOfTheTable)
{
    for (size_t i = 0; i < sizeof(ALL_PROBLEMS) / sizeof(ALL_PROBLEMS[0]); ++i)
        EXPECT_EQ((int)i, ALL_PROBLEMS[i]);
    EXPECT_THROW(Usac::create((ProblemType)(sizeof(ALL_PROBLEMS) / sizeof(ALL_PROBLEMS[0])),
                              std::vector<Point2f>(), std::vector<Point2f>()),
                 cv::Exception);
}

TEST_P(UsacGiven, exact_points)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        const Matches matches(problem(), 0, 1, seed);
        Report report;
        Mat mask;
        const Mat model = matches.fit(report, noArray(), noArray(), mask);
        ASSERT_FALSE(model.empty()) << seed;
        EXPECT_EQ((int)STOP_NO_SEARCH, report.stop);
        EXPECT_EQ(mask.rows, countNonZero(mask));
        EXPECT_EQ(1, report.inlierRatio);
        double largest;
        cv::minMaxIdx(matches.errors(model), 0, &largest);
        EXPECT_LT(largest, 1e-6) << seed;
        EXPECT_EQ(std::string::npos, std::string(report.describe()).find("no better than chance"))
            << report.describe();
    }
}

//! For run(), fit() and refine(), the mask must be 1 exactly where the error is at most the
//! threshold.
TEST_P(UsacGiven, errors_are_those_of_the_mask)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        Matches matches(problem(), 1, 0.6, seed);
        for (int kind = 0; kind < 3; ++kind)
        {
            Mat mask;
            Report report;
            const Mat model = matches.run(mask, report);
            ASSERT_FALSE(model.empty());
            const Mat used = kind == 0   ? model
                             : kind == 1 ? matches.fit(report, noArray(), mask.clone(), mask)
                                         : matches.refine(model, report, noArray(), mask);
            ASSERT_FALSE(used.empty());
            Mat errors = matches.errors(used);
            ASSERT_EQ(mask.rows, errors.rows);
            for (int i = 0; i < mask.rows; ++i)
                EXPECT_EQ(mask.at<uchar>(i) != 0, errors.at<double>(i) <= report.threshold) << i;
            // the threshold equals one of the errors, so that rounding could decide whether this
            // point is an inlier
            std::vector<double> sorted(errors.begin<double>(), errors.end<double>());
            std::sort(sorted.begin(), sorted.end());
            Matches same(matches);
            same.params.threshold = std::max(sorted[sorted.size() / 3], 1e-300);
            same.params.polishing = POLISHING_NONE;
            const Mat still = same.refine(used, report, noArray(), mask);
            errors = matches.errors(still);
            for (int i = 0; i < mask.rows; ++i)
                EXPECT_EQ(mask.at<uchar>(i) != 0, errors.at<double>(i) <= report.threshold) << i;
        }
    }
}

//! The fit must minimize the sum of squared errors: this sum must not be clearly smaller for any
//! model nearby, nor for the model that a search finds.
TEST_P(UsacGiven, fit_is_least_squares)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        const Matches matches(problem(), 2, 1, seed);
        Report report;
        Mat mask;
        const Mat fitted = matches.fit(report);
        ASSERT_FALSE(fitted.empty());
        const double least = sumOfSquares(matches.errors(fitted), matches.truth);
        const Mat found = matches.run(mask, report);
        EXPECT_LE(least, 1.0001 * sumOfSquares(matches.errors(found), matches.truth)) << seed;
        RNG rng(seed);
        for (int i = 0; i < 20; ++i)
        {
            Mat moved = fitted.clone();
            const int column = rng.uniform(0, moved.cols), row = rng.uniform(0, moved.rows);
            moved.at<double>(row, column) *= 1 + rng.uniform(-1e-4, 1e-4);
            // refining without fits only restores the constraints of the problem
            Matches none(matches);
            none.params.polishing = POLISHING_NONE;
            const Mat other = none.refine(moved, report);
            EXPECT_LE(least, (1 + 1e-7) * sumOfSquares(matches.errors(other), matches.truth))
                << seed;
        }
    }
}

//! A point of weight 0 must have no effect, like a point that is not in `chosen`. A weight of 2
//! must have the effect of two copies of the point.
TEST_P(UsacGiven, weights_and_chosen_points)
{
    Matches matches(problem(), 1, 0.7);
    matches.params.threshold *= 4;
    const int size = (int)matches.truth.size();
    Report report;
    std::vector<float> weights(size);
    std::vector<double> doubled(size);
    for (int i = 0; i < size; ++i)
    {
        weights[i] = matches.truth[i];
        doubled[i] = matches.truth[i] ? 1 + i % 2 : 0;
    }
    const Mat weighted = matches.fit(report, weights),
              chosen = matches.fit(report, noArray(), matches.truth);
    ASSERT_FALSE(weighted.empty());
    EXPECT_EQ(0, cv::norm(weighted, chosen, NORM_INF));
#ifdef CV_Bool  // exists since OpenCV 5
    Mat truth;
    column(matches.truth).convertTo(truth, CV_Bool);
    EXPECT_EQ(0, cv::norm(matches.fit(report, noArray(), truth), chosen, NORM_INF));
#endif
    EXPECT_LT(std::abs(report.inlierRatio - 0.7), 0.1);

    Matches twice(matches);
    for (int i = 0; i < size; ++i)
        if (matches.truth[i] && i % 2)
        {
            twice.first.push_back(matches.first.row(i));
            twice.second.push_back(matches.second.row(i));
            twice.truth.push_back(1);
        }
    const Mat a = matches.fit(report, doubled), b = twice.fit(report, noArray(), twice.truth);
    EXPECT_LT(std::min(cv::norm(a, b, NORM_INF), cv::norm(a, -b, NORM_INF)),
              1e-5 * cv::norm(a, NORM_INF));
    EXPECT_GT(cv::norm(a, chosen, NORM_INF), 0);
}

TEST_P(UsacGiven, refine_reaches_the_fit)
{
    const Matches matches(problem(), 1, 0.6);
    Mat mask;
    Report report, polished;
    const Mat model = matches.run(mask, report);
    ASSERT_FALSE(model.empty());
    const Mat fitted = matches.fit(report, noArray(), mask);
    const Mat refined = matches.refine(model, report, mask);
    std::vector<uchar> inliers(mask.begin<uchar>(), mask.end<uchar>());
    const double least = sumOfSquares(matches.errors(fitted), inliers);
    EXPECT_NEAR(least, sumOfSquares(matches.errors(refined), inliers), 1e-4 * least);
    EXPECT_EQ((int)STOP_NO_SEARCH, report.stop);
    const Mat again = matches.refine(model, polished);
    Mat single;
    model.convertTo(single, CV_32F);
    EXPECT_FALSE(matches.refine(single, report).empty());
    EXPECT_LE(polished.cost, report.cost * 1.01);
    EXPECT_GE(polished.inliers, countNonZero(mask) * 0.95);
}

TEST_P(UsacGiven, too_few_points)
{
    Matches matches(problem());
    const int m = Usac::create(problem(), matches.first, matches.second, matches.params, matches.K)
                      ->components()
                      .minimalSolver->sampleSize();
    for (int count = 0; count <= m; ++count)
    {
        Report report;
        Mat mask;
        std::vector<int> chosen(matches.truth.size());
        std::fill(chosen.begin(), chosen.begin() + count, 1);
        const Mat model = matches.fit(report, noArray(), chosen, mask);
        if (count < m)
        {
            EXPECT_TRUE(model.empty());
            EXPECT_EQ(0, countNonZero(mask));
            EXPECT_EQ((int)STOP_TOO_FEW_POINTS, report.stop);
        }
        else
        {
            ASSERT_FALSE(model.empty()) << m;
            EXPECT_GE(report.inliers, m);
        }
    }
}

//! Except for translations, copies of one match determine no model; a fit must either fail or
//! return finite numbers.
TEST_P(UsacGiven, degenerate_points)
{
    Matches matches(problem());
    for (int i = 1; i < matches.first.rows; ++i)
    {
        matches.first.row(0).copyTo(matches.first.row(i));
        matches.second.row(0).copyTo(matches.second.row(i));
    }
    Report report;
    const Mat model = matches.fit(report);
    EXPECT_TRUE(model.empty() || checkRange(model));
    EXPECT_EQ(model.empty() ? (int)STOP_NO_MODEL : (int)STOP_NO_SEARCH, report.stop);
}

template <class Call>
void expectMistake(const Call& call, const char* name)
{
    try
    {
        call();
        ADD_FAILURE() << name;
    }
    catch (const cv::Exception& mistake)
    {
        EXPECT_NE(std::string::npos, mistake.err.find(name)) << mistake.err;
    }
}

TEST_P(UsacGiven, mistakes)
{
    const Matches matches(problem());
    Report report;
    const std::vector<double> few(3, 1), negative(matches.truth.size(), -1),
        wrong(matches.truth.size(), NAN);
    expectMistake([&] { matches.fit(report, few); }, "weights");
    expectMistake([&] { matches.fit(report, negative); }, "weights");
    expectMistake([&] { matches.fit(report, wrong); }, "weights");
    expectMistake([&] { matches.fit(report, noArray(), few); }, "chosen");
    const Mat model = matches.fit(report);
    expectMistake([&] { matches.refine(model, report, few); }, "chosen");
    expectMistake([&] { matches.refine(Mat(), report); }, "model");
    expectMistake([&] { matches.errors(Mat()); }, "model");
    expectMistake([&] { matches.errors(Mat::eye(4, 4, CV_64F)); }, "model");
    expectMistake([&] { matches.errors(model.t()(Rect(0, 0, 2, 2))); }, "model");
    Mat infinite = model.clone();
    infinite.at<double>(0, 0) = NAN;
    expectMistake([&] { matches.errors(infinite); }, "model");
}

TEST(Usac_Given, sample_of_the_report)
{
    for (int problem : ALL_PROBLEMS)
    {
        const Matches matches((ProblemType)problem, 0.5, 0.6);
        Mat mask;
        Report report;
        ASSERT_FALSE(matches.run(mask, report).empty());
        const size_t m = Usac::create((ProblemType)problem, matches.first, matches.second,
                                      matches.params, matches.K)
                             ->components()
                             .minimalSolver->sampleSize();
        ASSERT_EQ(m, report.sample.size()) << problem;
        int right = 0;
        for (size_t i = 0; i < m; ++i)
        {
            ASSERT_TRUE(report.sample[i] >= 0 && report.sample[i] < mask.rows);
            right += matches.truth[report.sample[i]];
            for (size_t k = 0; k < i; ++k)
                EXPECT_NE(report.sample[i], report.sample[k]);
        }
        EXPECT_GE(right, (int)m - 1) << problem;
        EXPECT_EQ((double)report.inliers / mask.rows, report.inlierRatio);
    }
    Report none;
    const Scene scene = makeScene(HOMOGRAPHY);
    Params params;
    const std::vector<Point2d> few(scene.points1.begin(), scene.points1.begin() + 3);
    Mat mask;
    estimateHomography(few, few, params, mask, none);
    EXPECT_TRUE(none.sample.empty());
    EXPECT_EQ(0, none.inlierRatio);
}

TEST(Usac_Given, order_of_arguments_of_Python)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    Params params;
    Mat mask, expected;
    const Mat H = cv::findHomography(scene.points1, scene.points2, params, mask);
    EXPECT_EQ(0, cv::norm(H, cv::findHomography(scene.points1, scene.points2, expected, params),
                          NORM_INF));
    EXPECT_EQ(0, cv::norm(mask, expected, NORM_INF));
    EXPECT_FALSE(cv::findHomography(scene.points1, scene.points2, params).empty());
    EXPECT_FALSE(cv::findFundamentalMat(scene.points1, scene.points2, params, mask).empty());
    EXPECT_FALSE(cv::findEssentialMat(scene.points1, scene.points2, scene.K, scene.K, noArray(),
                                      noArray(), params, mask)
                     .empty());
    EXPECT_FALSE(cv::estimateAffine2D(scene.points1, scene.points2, params, mask).empty());
    cv::estimateAffinePartial2D(scene.points1, scene.points2, params, mask);
}

}  // namespace
}  // namespace opencv_test
