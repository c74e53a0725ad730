// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"

// Wrong arguments must raise a cv::Exception that names the argument.

namespace opencv_test {
namespace {

typedef UsacProblem UsacArguments;
INSTANTIATE_TEST_CASE_P(/**/, UsacArguments, testing::ValuesIn(TWO_VIEW_PROBLEMS));

const double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
const double INFINITE = std::numeric_limits<double>::infinity();

//! A call of the estimate function. Tests make one of its arguments wrong. (The names of the
//! arguments of calib3d's functions are tested in api/test_argument_names.cpp.)
struct WrongCall
{
    WrongCall(ProblemType problem_, const Mat& points1_, const Mat& points2_)
        : problem(problem_), points1(points1_), points2(points2_), K(sceneCamera())
    {}

    void operator()() const
    {
        Mat mask;
        Report report;
        estimatePoints(problem, points1, points2, params, mask, report, K);
    }

    void expect(const std::string& words) const { expectException(*this, words); }

    ProblemType problem;
    Mat points1, points2, K;
    Params params;
};

class Arguments
{
public:
    explicit Arguments(ProblemType problem_)
        : scene(makeScene(problem_)), points1(column(scene.points1).clone()),
          points2(column(scene.points2).clone())
    {}

    WrongCall call() const { return call(points1, points2); }
    WrongCall call(const Mat& a, const Mat& b) const { return WrongCall(scene.problem, a, b); }

    const Scene scene;
    const Mat points1, points2;
};

TEST_P(UsacArguments, lists_of_different_lengths)
{
    const Arguments right(problem());
    right.call(right.points1.rowRange(0, 299), right.points2).expect("points1 and points2");
    right.call(right.points1, right.points2.rowRange(1, 300)).expect("299");
    right.call(right.points1, Mat()).expect("300");
    right.call(Mat(), right.points2).expect("points2");
}

TEST_P(UsacArguments, points_of_a_wrong_shape)
{
    const Arguments right(problem());
    const int thick[] = {300, 2, 2}, narrow[] = {300, 1, 1}, wide[] = {300, 1, 4},
              four[] = {300, 1, 1, 2};
    const Mat wrong[] = {Mat::zeros(300, 1, CV_64F),
                         Mat::zeros(1, 300, CV_32F),
                         Mat::zeros(4, 1, CV_8U),
                         Mat::zeros(1, 1, CV_64F),
                         Mat(3, thick, CV_64F, Scalar(0)),
                         Mat(3, narrow, CV_64F, Scalar(0)),
                         Mat(3, narrow, CV_64FC2, Scalar(0)),
                         Mat(3, wide, CV_64F, Scalar(0)),
                         Mat(4, four, CV_64F, Scalar(0))};
    for (int i = 0; i < 9; ++i)
    {
        SCOPED_TRACE(cv::format("shape %d", i));
        right.call(wrong[i], right.points2).expect("points1");
        right.call(right.points1, wrong[i]).expect("points2");
    }
}

TEST_P(UsacArguments, lists_of_lists)
{
    const Scene scene = makeScene(problem());
    const std::vector<std::vector<Point2d>> lists(2, scene.points1);
    Mat mask;
    Report report;
    EXPECT_THROW(estimatePoints(problem(), lists, scene.points2, Params(), mask, report),
                 cv::Exception);
    EXPECT_THROW(estimatePoints(problem(), scene.points1, lists, Params(), mask, report),
                 cv::Exception);
}

TEST_P(UsacArguments, scores_of_a_wrong_length)
{
    WrongCall call = Arguments(problem()).call();
    call.params.scores.assign(299, 1.f);
    expectException(call, "scores");
}

TEST(Usac_Arguments, camera_matrices)
{
    const Arguments right(ESSENTIAL);
    Mat wrong[11];
    for (int i = 0; i < 7; ++i)
        wrong[i] = Mat(right.scene.K).clone();
    wrong[0].setTo(0);
    wrong[1].at<double>(0, 0) = 0;
    wrong[2].at<double>(1, 1) = 0;
    wrong[3].at<double>(0, 2) = NOT_A_NUMBER;
    wrong[4].at<double>(2, 2) = 0;
    wrong[5].at<double>(0, 0) = INFINITE;
    wrong[6].at<double>(2, 1) = 0.5;
    wrong[7] = Mat::eye(2, 3, CV_64F);
    wrong[8] = Mat::eye(3, 3, CV_64FC2);
    wrong[9] = Mat::eye(4, 4, CV_32F);
    wrong[10] = Mat::eye(3, 4, CV_64F);
    for (int i = 0; i < 11; ++i)
    {
        SCOPED_TRACE(cv::format("camera %d", i));
        WrongCall call = right.call();
        call.K = wrong[i];
        call.expect("cameraMatrix: ");
        Mat mask;
        Report report;
        const std::vector<Point2d>&points1 = right.scene.points1, &points2 = right.scene.points2;
        const Matx33d K = right.scene.K;
        const Mat& bad = wrong[i];
        expectException(
            [&]() {
                estimateEssential(points1, points2, K, bad, noArray(), noArray(), Params(), mask,
                                  report);
            },
            "cameraMatrix2");
        expectException(
            [&]() { findEssentialMat(points1, points2, K, noArray(), bad, noArray(), USACV20); },
            "cameraMatrix2");
    }
    WrongCall call = right.call();
    call.K = Mat();
    call.expect("cameraMatrix: ");
    expectException(
        [&]() { findEssentialMat(right.points1, right.points2, 0., Point2d(320, 240), USACV20); },
        "focal, pp: ");
}

TEST(Usac_Arguments, distortion)
{
    const Scene scene = makeScene(ESSENTIAL);
    Mat mask;
    Report report;
    const Mat wrong[] = {Mat::ones(3, 1, CV_64F),
                         Mat::ones(1, 6, CV_64F),
                         Mat::ones(15, 1, CV_64F),
                         Mat::ones(2, 4, CV_64F),
                         Mat(1, 5, CV_64F, Scalar(NOT_A_NUMBER)),
                         Mat(4, 1, CV_32F, Scalar(INFINITE))};
    for (int i = 0; i < 6; ++i)
    {
        SCOPED_TRACE(cv::format("coefficients %d", i));
        const Mat& bad = wrong[i];
        expectException(
            [&]() {
                estimateEssential(scene.points1, scene.points2, scene.K, noArray(), bad, noArray(),
                                  Params(), mask, report);
            },
            "distCoeffs");
        expectException(
            [&]() {
                estimateEssential(scene.points1, scene.points2, scene.K, noArray(), noArray(), bad,
                                  Params(), mask, report);
            },
            "distCoeffs");
    }
}

TEST(Usac_Arguments, arrays_of_three_dimensions)
{
    const Scene scene = makeScene(ESSENTIAL);
    Mat mask;
    Report report;
    const int cube[] = {3, 3, 1}, four[] = {1, 2, 2};
    const Mat K(3, cube, CV_64F, Scalar(1)), distortion(3, four, CV_64F, Scalar(0.1));
    expectException(
        [&]() { estimateEssential(scene.points1, scene.points2, K, Params(), mask, report); },
        "cameraMatrix: ");
    expectException(
        [&]() {
            estimateEssential(scene.points1, scene.points2, scene.K, noArray(), distortion,
                              noArray(), Params(), mask, report);
        },
        "distCoeffs1");
}

//! Affinities and similarities have no check for a dominant plane, so that DEGENSAC must be
//! refused. Of the sets that contain this flag, only the default (all bits) is accepted, because it
//! means all checks that the problem has.
TEST(Usac_Arguments, degeneracies_of_maps_of_points)
{
    const int right[] = {0, DEGENERACY_ORIENTATION, DEGENERACY_REPEATED,
                         DEGENERACY_ORIENTATION | DEGENERACY_REPEATED, Params().degeneracy};
    const int wrong[] = {DEGENERACY_DEGENSAC, Params::usac2013().degeneracy,
                         DEGENERACY_DEGENSAC | DEGENERACY_REPEATED};
    for (ProblemType problem : {AFFINITY, SIMILARITY})
    {
        WrongCall call = Arguments(problem).call();
        for (int degeneracy : right)
        {
            call.params.degeneracy = degeneracy;
            EXPECT_NO_THROW(call()) << degeneracy;
        }
        for (int degeneracy : wrong)
        {
            call.params.degeneracy = degeneracy;
            expectException(call, "degeneracy");
            expectException(call, nameOf(problem));
        }
        call.params = Params::usac2013();
        expectException(call, "DEGENERACY_DEGENSAC");
    }
}

TEST(Usac_Arguments, problem)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    expectException([&]() { Usac::create((ProblemType)15, scene.points1, scene.points2); },
                    "problem: one of ProblemType is expected");
}

}  // namespace
}  // namespace opencv_test
