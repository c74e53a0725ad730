// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"

#include <functional>

// Tests of the flags and of every overload of findHomography, findFundamentalMat and
// findEssentialMat.

namespace opencv_test {
namespace {

typedef UsacProblem UsacFlags;
INSTANTIATE_TEST_CASE_P(/**/, UsacFlags, testing::ValuesIn(FLAG_PROBLEMS));

const UsacV20Method FLAGS[] = {USACV20,        USACV20_FAST,     USACV20_ACCURATE, USACV20_PROSAC,
                               USACV20_MAGSAC, USACV20_PARALLEL, USACV20_AUTO};
const int VALUES[] = {0x4000, 0x4001, 0x4002, 0x4003, 0x4004, 0x4005, 0x4006}, FLAG_COUNT = 7;
//! A confidence so low, and a number of iterations so small, that each of the two changes the
//! result.
const double LOW = 1e-15;
const int FEW = 20;

//! The preset that belongs to a flag according to the documentation.
Params presetOf(UsacV20Method flag)
{
    return flag == USACV20            ? Params::usacV20()
           : flag == USACV20_FAST     ? Params::fast()
           : flag == USACV20_ACCURATE ? Params::accurate()
           : flag == USACV20_PROSAC   ? Params::sorted()
           : flag == USACV20_MAGSAC   ? Params::magsacPlusPlus()
           : flag == USACV20_PARALLEL ? Params::parallel()
                                      : Params::automatic();
}

Params paramsOf(UsacV20Method flag, double pixels, double confidence, int maxIterations)
{
    Params params = presetOf(flag);
    params.threshold = pixels;
    params.confidence = confidence;
    params.maxIterations = maxIterations;
    return params;
}

//! There are few inliers, so that each argument changes the result. There are also so few points
//! that, by default (Params::significance), no F or E is rejected as possibly due to chance.
Scene hardScene(ProblemType problem)
{
    SceneOptions options;
    options.inliers = 10;
    options.outliers = problem == SIMILARITY ? 80 : 16;  // makes all-inlier two-point samples rare
    options.seed = problem == HOMOGRAPHY ? 3 : 2;
    return makeScene(problem, options);
}

//! The model and the mask that a call has to return.
struct Wanted
{
    Wanted(const Scene& scene, const Params& params)
    {
        model = estimate(scene, params, mask);
        EXPECT_FALSE(model.empty());
    }

    void same(const char* call, const Mat& otherModel) const
    {
        EXPECT_TRUE(sameBits(model, otherModel)) << call;
    }
    void same(const char* call, const Mat& otherModel, const Mat& otherMask) const
    {
        same(call, otherModel);
        EXPECT_TRUE(sameBits(mask, otherMask)) << call << ": mask";
    }

    Mat model, mask;
};

TEST(Usac_Flags, values_are_none_of_OpenCV)
{
    for (int i = 0; i < FLAG_COUNT; ++i)
    {
        EXPECT_EQ(VALUES[i], (int)FLAGS[i]);
        EXPECT_GT((int)FLAGS[i], 63);
        EXPECT_NE(8, (int)FLAGS[i] & ~3);
        EXPECT_TRUE(isUsacV20Method((int)FLAGS[i]));
        EXPECT_TRUE(FLAGS[i] == methodFromInt((int)FLAGS[i]));
    }
}

//! A cast can convert any number to a flag, for example a flag of OpenCV. Such a value must raise
//! an exception instead of running as USACV20.
TEST(Usac_Flags, casts_of_other_ints_are_refused)
{
    const int others[] = {77, RANSAC, 0, -1, 0x3fff, (int)USACV20_AUTO + 1};
    const Scene s = makeScene(HOMOGRAPHY, SceneOptions());
    const std::vector<Point3d> space(s.points1.size(), Point3d(1, 2, 3));
    const Mat K = Mat::eye(3, 3, CV_64F);
    for (int number : others)
    {
        const UsacV20Method flag = (UsacV20Method)number;
        const std::string value = cv::format("%d", number);
        Mat mask, rvec, tvec;
        std::vector<std::function<void()>> calls;
        calls.push_back([&]() { Params::fromMethod(flag); });
        calls.push_back([&]() { findHomography(s.points1, s.points2, flag); });
        calls.push_back([&]() { findHomography(s.points1, s.points2, mask, flag); });
        calls.push_back([&]() { findFundamentalMat(s.points1, s.points2, flag, 3, 0.99, 100); });
        calls.push_back([&]() { findFundamentalMat(s.points1, s.points2, flag, 3, 0.99, mask); });
        calls.push_back([&]() { findFundamentalMat(s.points1, s.points2, mask, flag); });
        calls.push_back([&]() { findEssentialMat(s.points1, s.points2, K, flag, 0.99, 1, 100); });
        calls.push_back([&]() { findEssentialMat(s.points1, s.points2, K, flag, 0.99, 1, mask); });
        calls.push_back(
            [&]() { findEssentialMat(s.points1, s.points2, 1, Point2d(), flag, 0.99, 1, 100); });
        calls.push_back(
            [&]() { findEssentialMat(s.points1, s.points2, 1, Point2d(), flag, 0.99, 1, mask); });
        calls.push_back(
            [&]() { findEssentialMat(s.points1, s.points2, K, Mat(), K, Mat(), flag, 0.99, 1); });
        calls.push_back([&]() { cv::estimateAffine2D(s.points1, s.points2, mask, flag); });
        calls.push_back([&]() { cv::estimateAffinePartial2D(s.points1, s.points2, mask, flag); });
        for (const std::function<void()>& call : calls)
        {
            expectException(call, "method:");
            expectException(call, value);
        }
        const std::function<void()> pose = [&]() {
            cv::solvePnPRansac(space, s.points2, K, Mat(), rvec, tvec, false, 100, 8, 0.99, mask,
                               flag);
        };
        expectException(pose, "flags:");
        expectException(pose, value);
    }
}

//! The tests of the overloads detect an ignored argument only if each argument changes the model of
//! their scene, hardScene().
TEST_P(UsacFlags, arguments_matter_in_the_scene_of_these_tests)
{
    const Scene scene = hardScene(problem());
    const UsacV20Method flag = USACV20_ACCURATE;
    const Wanted wanted(scene, paramsOf(flag, 2, 0.98, 1000));
    const Params others[] = {paramsOf(flag, 1, 0.98, 1000), paramsOf(flag, 2, LOW, 1000),
                             paramsOf(flag, 2, 0.98, FEW), paramsOf(USACV20_MAGSAC, 2, 0.98, 1000)};
    for (int i = 0; i < 4; ++i)
        EXPECT_FALSE(sameBits(wanted.model, estimate(scene, others[i]))) << "change " << i;
}

TEST(Usac_Flags, every_overload_of_findHomography)
{
    const Scene s = hardScene(HOMOGRAPHY);
    const UsacV20Method flag = USACV20_ACCURATE;
    Mat mask;
    // defaults: 3 pixels, 2000 iterations, confidence 0.995
    Wanted(s, paramsOf(flag, 3, 0.995, 2000))
        .same("flag", findHomography(s.points1, s.points2, flag));
    Wanted(s, paramsOf(flag, 2, 0.995, 2000))
        .same("threshold", findHomography(s.points1, s.points2, flag, 2));
    const Mat a = findHomography(s.points1, s.points2, flag, 2, mask);
    Wanted(s, paramsOf(flag, 2, 0.995, 2000)).same("mask", a, mask);
    const Mat b = findHomography(s.points1, s.points2, flag, 2, mask, FEW);
    Wanted(s, paramsOf(flag, 2, 0.995, FEW)).same("maxIters", b, mask);
    const Mat c = findHomography(s.points1, s.points2, flag, 2, mask, 1000, LOW);
    Wanted(s, paramsOf(flag, 2, LOW, 1000)).same("confidence", c, mask);
    const Mat d = findHomography(s.points1, s.points2, mask, flag);
    Wanted(s, paramsOf(flag, 3, 0.995, 2000)).same("mask third", d, mask);
    const Mat e = findHomography(s.points1, s.points2, mask, flag, 2);
    Wanted(s, paramsOf(flag, 2, 0.995, 2000)).same("mask third, threshold", e, mask);
    const Params params = paramsOf(USACV20_FAST, 1.25, LOW, 1000);
    const Mat f = findHomography(s.points1, s.points2, mask, params);
    Wanted(s, params).same("params", f, mask);
    Wanted(s, params).same("params, no mask",
                           findHomography(s.points1, s.points2, noArray(), params));
}

TEST(Usac_Flags, every_overload_of_findFundamentalMat)
{
    const Scene s = hardScene(FUNDAMENTAL);
    const UsacV20Method flag = USACV20_ACCURATE;
    Mat mask;
    // defaults: 3 pixels, confidence 0.99; 1000 iterations as in OpenCV
    const Wanted plain(s, paramsOf(flag, 3, 0.99, 1000)), coarse(s, paramsOf(flag, 2, 0.99, 1000)),
        low(s, paramsOf(flag, 2, LOW, 1000)), few(s, paramsOf(flag, 2, 0.98, FEW));
    plain.same("flag", findFundamentalMat(s.points1, s.points2, flag));
    coarse.same("threshold", findFundamentalMat(s.points1, s.points2, flag, 2));
    low.same("confidence", findFundamentalMat(s.points1, s.points2, flag, 2, LOW));
    const Mat a = findFundamentalMat(s.points1, s.points2, flag, 2, LOW, mask);
    low.same("mask", a, mask);
    few.same("maxIters", findFundamentalMat(s.points1, s.points2, flag, 2, 0.98, FEW));
    const Mat b = findFundamentalMat(s.points1, s.points2, flag, 2, 0.98, FEW, mask);
    few.same("maxIters, mask", b, mask);
    const Mat c = findFundamentalMat(s.points1, s.points2, mask, flag);
    plain.same("mask third", c, mask);
    const Mat d = findFundamentalMat(s.points1, s.points2, mask, flag, 2);
    coarse.same("mask third, threshold", d, mask);
    const Mat e = findFundamentalMat(s.points1, s.points2, mask, flag, 2, LOW);
    low.same("mask third, confidence", e, mask);
    const Params params = paramsOf(USACV20_FAST, 1.25, LOW, 1000);
    const Mat f = findFundamentalMat(s.points1, s.points2, mask, params);
    Wanted(s, params).same("params", f, mask);
}

TEST(Usac_Flags, every_overload_of_findEssentialMat)
{
    const Scene s = hardScene(ESSENTIAL);
    const UsacV20Method flag = USACV20_ACCURATE;
    const Point2d pp(s.K(0, 2), s.K(1, 2));
    const double focal = s.K(0, 0);
    Mat mask;
    // defaults: confidence 0.999, 1 pixel, 1000 iterations
    const Wanted plain(s, paramsOf(flag, 1, 0.999, 1000)), low(s, paramsOf(flag, 1, LOW, 1000)),
        coarse(s, paramsOf(flag, 2, LOW, 1000)), few(s, paramsOf(flag, 2, 0.98, FEW));
    plain.same("flag", findEssentialMat(s.points1, s.points2, s.K, flag));
    low.same("prob", findEssentialMat(s.points1, s.points2, s.K, flag, LOW));
    coarse.same("threshold", findEssentialMat(s.points1, s.points2, s.K, flag, LOW, 2));
    few.same("maxIters", findEssentialMat(s.points1, s.points2, s.K, flag, 0.98, 2, FEW));
    const Mat a = findEssentialMat(s.points1, s.points2, s.K, flag, 0.98, 2, FEW, mask);
    few.same("maxIters, mask", a, mask);
    const Mat b = findEssentialMat(s.points1, s.points2, s.K, flag, LOW, 2, mask);
    coarse.same("mask", b, mask);
    plain.same("focal", findEssentialMat(s.points1, s.points2, focal, pp, flag));
    low.same("focal, prob", findEssentialMat(s.points1, s.points2, focal, pp, flag, LOW));
    few.same("focal, maxIters",
             findEssentialMat(s.points1, s.points2, focal, pp, flag, 0.98, 2, FEW));
    const Mat c = findEssentialMat(s.points1, s.points2, focal, pp, flag, 0.98, 2, FEW, mask);
    few.same("focal, maxIters, mask", c, mask);
    const Mat d = findEssentialMat(s.points1, s.points2, focal, pp, flag, LOW, 2, mask);
    coarse.same("focal, mask", d, mask);
    plain.same("two cameras",
               findEssentialMat(s.points1, s.points2, s.K, noArray(), s.K, noArray(), flag));
    const Mat e = findEssentialMat(s.points1, s.points2, s.K, Mat::zeros(5, 1, CV_64F), s.K,
                                   noArray(), flag, LOW, 2, mask);
    coarse.same("two cameras, mask", e, mask);
    const Params params = paramsOf(USACV20_FAST, 1.25, LOW, 1000);
    const Mat f = findEssentialMat(s.points1, s.points2, s.K, s.K, noArray(), noArray(), mask,
                                   params);
    Wanted(s, params).same("params", f, mask);
}

//! With a flag, calib3d has the argument order K1, dist1, K2, dist2, but with cv::UsacParams K1,
//! K2, dist1, dist2. The overloads of this module must have the same orders.
TEST(Usac_Flags, order_of_two_cameras)
{
    const Scene s = makeScene(ESSENTIAL);
    const Matx33d K2(650, 0, 300, 0, 640, 250, 0, 0, 1);
    const Vec<double, 5> d1(-0.1, 0.02, 0, 0, 0), d2(0.05, -0.01, 0, 0, 0);
    const Params params = paramsOf(USACV20, 2, 0.999, 1000);
    Report report;
    Mat mask, other;
    const Mat E = estimateEssential(s.points1, s.points2, s.K, K2, d1, d2, params, mask, report);
    ASSERT_FALSE(E.empty());
    EXPECT_TRUE(sameBits(
        E, findEssentialMat(s.points1, s.points2, s.K, d1, K2, d2, USACV20, 0.999, 2, other)));
    EXPECT_TRUE(sameBits(mask, other));
    EXPECT_TRUE(
        sameBits(E, findEssentialMat(s.points1, s.points2, s.K, K2, d1, d2, other, params)));
    EXPECT_TRUE(sameBits(mask, other));
    EXPECT_FALSE(sameBits(
        E, findEssentialMat(s.points1, s.points2, s.K, d2, K2, d1, USACV20, 0.999, 2, other)));
}

//! OpenCV's functions, selected by their types. Without this module, a call with an int as the
//! method calls these functions.
typedef Mat (*OldHomography)(InputArray, InputArray, int, double, OutputArray, const int,
                             const double);
typedef Mat (*OldFundamental)(InputArray, InputArray, int, double, double, int, OutputArray);
typedef Mat (*OldEssential)(InputArray, InputArray, InputArray, int, double, double, int,
                            OutputArray);
//! Calls without a flag, with a flag of OpenCV or with cv::UsacParams must reach calib3d. (Its USAC
//! is not deterministic for E.)
TEST(Usac_Flags, calls_of_calib3d_stay)
{
    typedef Mat (*Homography)(InputArray, InputArray, int, double, OutputArray, const int,
                              const double);
    typedef Mat (*Fundamental)(InputArray, InputArray, int, double, double, int, OutputArray);
    typedef Mat (*Essential)(InputArray, InputArray, InputArray, int, double, double, int,
                             OutputArray);
    const Homography findH = &cv::findHomography;
    const Fundamental findF = &cv::findFundamentalMat;
    const Essential findE = &cv::findEssentialMat;
    const Scene h = makeScene(HOMOGRAPHY), f = makeScene(FUNDAMENTAL), e = makeScene(ESSENTIAL);
    Mat mask;
    const Mat H = findH(h.points1, h.points2, 0, 3, noArray(), 2000, 0.995),
              F = findF(f.points1, f.points2, FM_RANSAC, 3, 0.99, 1000, noArray()),
              E = findE(e.points1, e.points2, e.K, RANSAC, 0.999, 1, 1000, noArray());
    EXPECT_TRUE(sameBits(H, cv::findHomography(h.points1, h.points2)));
    EXPECT_TRUE(sameBits(H, cv::findHomography(h.points1, h.points2, mask)));
    EXPECT_TRUE(sameBits(findH(h.points1, h.points2, RANSAC, 3, noArray(), 2000, 0.995),
                         cv::findHomography(h.points1, h.points2, RANSAC)));
    EXPECT_TRUE(sameBits(F, cv::findFundamentalMat(f.points1, f.points2)));
    EXPECT_TRUE(sameBits(F, cv::findFundamentalMat(f.points1, f.points2, mask)));
    EXPECT_TRUE(sameBits(E, cv::findEssentialMat(e.points1, e.points2, e.K)));
    EXPECT_TRUE(sameBits(
        E, cv::findEssentialMat(e.points1, e.points2, e.K(0, 0), Point2d(e.K(0, 2), e.K(1, 2)))));
    const cv::UsacParams theirs;
    EXPECT_FALSE(
        sameBits(cv::findHomography(h.points1, h.points2, mask, theirs),
                 cv::findHomography(h.points1, h.points2, mask, Params::fromUsacParams(theirs))));
    EXPECT_FALSE(sameBits(
        cv::findFundamentalMat(f.points1, f.points2, mask, theirs),
        cv::findFundamentalMat(f.points1, f.points2, mask, Params::fromUsacParams(theirs))));
}

}  // namespace
}  // namespace opencv_test
