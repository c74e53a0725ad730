// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"
#include "support/params_fields.hpp"

// Tests of a flag that is known only at run time: usacv20::findHomography, findFundamentalMat and
// findEssentialMat with an int, which is a flag of this module or of OpenCV. Results must equal,
// bit by bit, those of the overloads with a UsacV20Method or those of calib3d. Calls that must not
// compile are tested in misc/consumer.

namespace opencv_test {
namespace {

const UsacV20Method OURS[] = {USACV20,        USACV20_FAST,     USACV20_ACCURATE, USACV20_PROSAC,
                              USACV20_MAGSAC, USACV20_PARALLEL, USACV20_AUTO};
const int OUR_COUNT = 7;
//! OpenCV's flags without USAC_PARALLEL, which is not deterministic.
const int THEIRS[] = {0,         FM_7POINT,     FM_8POINT,    LMEDS,
                      RANSAC,    RHO,           USAC_DEFAULT, USAC_FM_8PTS,
                      USAC_FAST, USAC_ACCURATE, USAC_PROSAC,  USAC_MAGSAC};
const int THEIR_COUNT = 12;

//! The model and mask of a call, or the exception that it raised.
struct Answer
{
    template <class Call>
    explicit Answer(const Call& call)
    {
        try
        {
            model = call(mask);
        }
        catch (const cv::Exception& e)
        {
            error = e.err.empty() ? e.what() : e.err;
        }
    }

    bool operator==(const Answer& other) const
    {
        return error == other.error && sameBits(model, other.model) && sameBits(mask, other.mask);
    }

    Mat model, mask;
    std::string error;
};

//! For every flag, compares the answer of the overload whose flag is an int with another answer:
//! for flags of this module, that of the overload whose flag is a UsacV20Method; for OpenCV's
//! flags, that of calib3d. For E, the USAC flags of OpenCV are left out.
template <class AtRunTime, class Typed, class Calib3d>
void checkForm(const std::string& form, const AtRunTime& atRunTime, const Typed& typed,
               const Calib3d& calib3d)
{
    SCOPED_TRACE(form.c_str());
    const bool forE = form.find("findEssentialMat") ==
                      0;  // calib3d's USAC is not deterministic for E
    int models = 0, theirCount = 0;
    for (int i = 0; i < OUR_COUNT; ++i)
    {
        const Answer answer([&](Mat& mask) { return atRunTime((int)OURS[i], mask); });
        const Answer expected([&](Mat& mask) { return typed(OURS[i], mask); });
        EXPECT_TRUE(answer == expected) << "flag " << i;
        EXPECT_FALSE(answer.model.empty()) << "flag " << i << ": " << answer.error;
        const Answer lost([&](Mat& mask) { return calib3d((int)OURS[i], mask); });
        EXPECT_FALSE(answer == lost) << "flag " << i << ": calib3d gives the same result";
    }
    for (int i = 0; i < THEIR_COUNT; ++i)
    {
        if (forE && THEIRS[i] >= USAC_DEFAULT)
            continue;
        const Answer answer([&](Mat& mask) { return atRunTime(THEIRS[i], mask); });
        const Answer expected([&](Mat& mask) { return calib3d(THEIRS[i], mask); });
        EXPECT_TRUE(answer == expected)
            << "OpenCV's flag " << THEIRS[i] << ": " << answer.error << " / " << expected.error;
        models += !answer.model.empty();
        ++theirCount;
    }
    EXPECT_GT(models, theirCount / 2)
        << "more than half of OpenCV's flags must give a model, not an exception";
}

//! Replacements for the forms of cv::findEssentialMat with a mask but without `maxIters`, which do
//! not exist in OpenCV 5. The replacements pass the default of `maxIters`.
Mat essentialOfDefaultIterations(const std::vector<Point2d>& a, const std::vector<Point2d>& b,
                                 const Matx33d& K, int method, double prob, double threshold,
                                 Mat& mask)
{
    return cv::findEssentialMat(a, b, K, method, prob, threshold, 1000, mask);
}

Mat essentialOfDefaultIterations(const std::vector<Point2d>& a, const std::vector<Point2d>& b,
                                 double focal, Point2d pp, int method, double prob,
                                 double threshold, Mat& mask)
{
    return cv::findEssentialMat(a, b, focal, pp, method, prob, threshold, 1000, mask);
}

//! Checks one form of a call of `function`. The variables `method` (the flag) and `mask` can be
//! used in the arguments.
#define CHECK_FORM(function, ...) CHECK_FORM_LIKE(cv::function, function, __VA_ARGS__)
#define CHECK_FORM_LIKE(theirs, function, ...)                                                     \
    checkForm(                                                                                     \
        #function "(" #__VA_ARGS__ ")",                                                            \
        [&](int method, Mat& mask) {                                                               \
            (void)mask;                                                                            \
            return usacv20::function(__VA_ARGS__);                                                 \
        },                                                                                         \
        [&](UsacV20Method method, Mat& mask) {                                                     \
            (void)mask;                                                                            \
            return cv::function(__VA_ARGS__);                                                      \
        },                                                                                         \
        [&](int method, Mat& mask) {                                                               \
            (void)mask;                                                                            \
            return theirs(__VA_ARGS__);                                                            \
        })

TEST(Usac_FlagsAtRunTime, every_form_of_findHomography)
{
    const Scene s = makeScene(HOMOGRAPHY);
    const std::vector<Point2d>&a = s.points1, &b = s.points2;
    CHECK_FORM(findHomography, a, b, method);
    CHECK_FORM(findHomography, a, b, method, 2);
    CHECK_FORM(findHomography, a, b, method, 2, mask);
    CHECK_FORM(findHomography, a, b, method, 2, mask, 500);
    CHECK_FORM(findHomography, a, b, method, 2, mask, 500, 0.9);
    CHECK_FORM(findHomography, a, b, mask, method);
    CHECK_FORM(findHomography, a, b, mask, method, 2);
}

TEST(Usac_FlagsAtRunTime, every_form_of_findFundamentalMat)
{
    const Scene s = makeScene(FUNDAMENTAL);
    const std::vector<Point2d>&a = s.points1, &b = s.points2;
    CHECK_FORM(findFundamentalMat, a, b, method);
    CHECK_FORM(findFundamentalMat, a, b, method, 2);
    CHECK_FORM(findFundamentalMat, a, b, method, 2, 0.9);
    CHECK_FORM(findFundamentalMat, a, b, method, 2, 0.9, mask);
    CHECK_FORM(findFundamentalMat, a, b, method, 2, 0.9, 500);
    CHECK_FORM(findFundamentalMat, a, b, method, 2, 0.9, 500, mask);
    CHECK_FORM(findFundamentalMat, a, b, mask, method);
    CHECK_FORM(findFundamentalMat, a, b, mask, method, 2);
    CHECK_FORM(findFundamentalMat, a, b, mask, method, 2, 0.9);
}

TEST(Usac_FlagsAtRunTime, every_form_of_findEssentialMat)
{
    const Scene s = makeScene(ESSENTIAL);
    const std::vector<Point2d>&a = s.points1, &b = s.points2;
    const Matx33d K = s.K;
    const Point2d pp(K(0, 2), K(1, 2));
    const double f = K(0, 0);
    CHECK_FORM(findEssentialMat, a, b, K, method);
    CHECK_FORM(findEssentialMat, a, b, K, method, 0.9);
    CHECK_FORM(findEssentialMat, a, b, K, method, 0.9, 2);
    CHECK_FORM_LIKE(essentialOfDefaultIterations, findEssentialMat, a, b, K, method, 0.9, 2, mask);
    CHECK_FORM(findEssentialMat, a, b, K, method, 0.9, 2, 500);
    CHECK_FORM(findEssentialMat, a, b, K, method, 0.9, 2, 500, mask);
    CHECK_FORM(findEssentialMat, a, b, f, pp, method);
    CHECK_FORM(findEssentialMat, a, b, f, pp, method, 0.9);
    CHECK_FORM(findEssentialMat, a, b, f, pp, method, 0.9, 2);
    CHECK_FORM_LIKE(essentialOfDefaultIterations, findEssentialMat, a, b, f, pp, method, 0.9, 2,
                    mask);
    CHECK_FORM(findEssentialMat, a, b, f, pp, method, 0.9, 2, 500);
    CHECK_FORM(findEssentialMat, a, b, f, pp, method, 0.9, 2, 500, mask);
    CHECK_FORM(findEssentialMat, a, b, K, noArray(), K, noArray(), method);
    CHECK_FORM(findEssentialMat, a, b, K, noArray(), K, noArray(), method, 0.9);
    CHECK_FORM(findEssentialMat, a, b, K, noArray(), K, noArray(), method, 0.9, 2);
    CHECK_FORM(findEssentialMat, a, b, K, noArray(), K, noArray(), method, 0.9, 2, mask);
}

TEST(Usac_FlagsAtRunTime, without_a_flag)
{
    const Scene h = makeScene(HOMOGRAPHY), f = makeScene(FUNDAMENTAL), e = makeScene(ESSENTIAL);
    Mat mask, expected;
    EXPECT_TRUE(sameBits(cv::findHomography(h.points1, h.points2, USACV20),
                         usacv20::findHomography(h.points1, h.points2)));
    EXPECT_TRUE(sameBits(cv::findHomography(h.points1, h.points2, expected, USACV20),
                         usacv20::findHomography(h.points1, h.points2, mask)));
    EXPECT_TRUE(sameBits(expected, mask));
    EXPECT_TRUE(sameBits(cv::findFundamentalMat(f.points1, f.points2, expected, USACV20),
                         usacv20::findFundamentalMat(f.points1, f.points2, mask)));
    EXPECT_TRUE(sameBits(expected, mask));
    EXPECT_TRUE(sameBits(cv::findFundamentalMat(f.points1, f.points2, USACV20),
                         usacv20::findFundamentalMat(f.points1, f.points2)));
    const Mat E = cv::findEssentialMat(e.points1, e.points2, e.K, USACV20);
    const Point2d pp(e.K(0, 2), e.K(1, 2));
    EXPECT_TRUE(sameBits(E, usacv20::findEssentialMat(e.points1, e.points2, e.K)));
    EXPECT_TRUE(sameBits(E, usacv20::findEssentialMat(e.points1, e.points2, e.K(0, 0), pp)));
    EXPECT_TRUE(sameBits(
        E, usacv20::findEssentialMat(e.points1, e.points2, e.K, noArray(), e.K, noArray())));
    EXPECT_TRUE(sameBits(cv::findEssentialMat(e.points1, e.points2, 1., Point2d(), USACV20),
                         usacv20::findEssentialMat(e.points1, e.points2)));
}

TEST(Usac_FlagsAtRunTime, numbers_of_nobody_are_refused)
{
    const Scene h = makeScene(HOMOGRAPHY), f = makeScene(FUNDAMENTAL), e = makeScene(ESSENTIAL);
    const int others[] = {
        -1, INT_MIN, INT_MAX, 64, 0x3fff, (int)USACV20_AUTO + 1, (int)USACV20 << 1};
    for (size_t i = 0; i < sizeof(others) / sizeof(others[0]); ++i)
    {
        const int method = others[i];
        expectException([&]() { usacv20::findHomography(h.points1, h.points2, method); }, "method");
        expectException([&]() { usacv20::findHomography(h.points1, h.points2, noArray(), method); },
                        "method");
        expectException([&]() { usacv20::findFundamentalMat(f.points1, f.points2, method); },
                        cv::format("%d", method));
        expectException(
            [&]() { usacv20::findFundamentalMat(f.points1, f.points2, method, 1, 0.99, 100); },
            "method");
        expectException([&]() { usacv20::findEssentialMat(e.points1, e.points2, e.K, method); },
                        "method");
        expectException(
            [&]() { usacv20::findEssentialMat(e.points1, e.points2, 1., Point2d(), method); },
            "method");
        expectException(
            [&]() {
                usacv20::findEssentialMat(e.points1, e.points2, e.K, noArray(), e.K, noArray(),
                                          method);
            },
            "method");
    }
}

}  // namespace
}  // namespace opencv_test
