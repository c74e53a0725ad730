// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include <functional>
#include <set>

// Tests of many pairs in one call, of invalid arguments, and of the number of samples.

namespace opencv_test {
namespace {

//! Pairs of all kinds: with and without cameras, of a plane, without overlap, and with few matches.
std::vector<TwoViewPair> mixedPairs()
{
    std::vector<TwoViewPair> pairs;
    for (uint64 seed = 1; seed <= 24; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.inliers = seed % 5 ? 20 + 15 * (int)(seed % 7) : 0;
        options.outliers = 80;
        options.planeFraction = seed % 4 == 0;
        const Scene scene = makeScene(ESSENTIAL, options);
        const Mat K = seed % 3 ? Mat(scene.K).clone() : Mat();
        pairs.push_back(
            TwoViewPair(column(scene.points1).clone(), column(scene.points2).clone(), K, K));
    }
    pairs.push_back(TwoViewPair(Mat::zeros(3, 2, CV_64F), Mat::zeros(3, 2, CV_64F)));
    return pairs;
}

bool sameBits(const Mat& a, const Mat& b)
{
    return a.size() == b.size() && (a.empty() || cv::norm(a, b, NORM_INF) == 0);
}

TEST(Usac_TwoViewBatch, any_number_of_threads)
{
    const std::vector<TwoViewPair> pairs = mixedPairs();
    std::set<int> configurations;
    for (int threads : {1, 2, 4, 0})
    {
        const std::vector<TwoViewGeometry> found = estimateTwoViewGeometries(
            pairs, Params(), TwoViewRules(), threads);
        ASSERT_EQ(pairs.size(), found.size());
        for (size_t i = 0; i < pairs.size(); ++i)
        {
            const TwoViewGeometry alone = estimateTwoViewGeometry(pairs[i]);
            configurations.insert(alone.configuration);
            EXPECT_EQ(alone.configuration, found[i].configuration) << i;
            EXPECT_EQ(alone.reason, found[i].reason) << i;
            EXPECT_EQ(alone.iterations, found[i].iterations) << i;
            EXPECT_EQ(alone.inliers, found[i].inliers) << i;
            EXPECT_EQ(alone.report.chance, found[i].report.chance) << i;
            EXPECT_TRUE(sameBits(alone.mask, found[i].mask) && sameBits(alone.F, found[i].F)) << i;
            EXPECT_TRUE(sameBits(alone.E, found[i].E) && sameBits(alone.H, found[i].H)) << i;
            EXPECT_TRUE(sameBits(alone.R, found[i].R) && sameBits(alone.t, found[i].t)) << i;
            EXPECT_TRUE(sameBits(alone.rotations, found[i].rotations)) << i;
        }
    }
    EXPECT_GE(configurations.size(), 4u);
    EXPECT_TRUE(estimateTwoViewGeometries(std::vector<TwoViewPair>()).empty());
}

TEST(Usac_TwoViewBatch, a_mistake_is_that_of_its_pair)
{
    std::vector<TwoViewPair> pairs = mixedPairs();
    pairs[1].points2 = pairs[1].points2.rowRange(1, pairs[1].points2.rows);
    pairs[2].cameraMatrix1 = Mat::zeros(3, 3, CV_64F);
    const std::vector<TwoViewGeometry> found = estimateTwoViewGeometries(pairs);
    EXPECT_NE(String::npos, found[1].error.find("points1 and points2: ")) << found[1].error;
    EXPECT_NE(String::npos, found[2].error.find("cameraMatrix1: ")) << found[2].error;
    EXPECT_EQ((int)TWO_VIEW_UNDEFINED, found[1].configuration);
    EXPECT_EQ("", found[0].error);
    EXPECT_EQ("", found[3].error);
}

//! Whenever a pair is canceled, the result must say so. A progress function that never returns
//! false must change no bit.
TEST(Usac_TwoViewBatch, cancelled_at_any_time)
{
    SceneOptions options;
    options.inliers = 40000;
    options.outliers = 20000;
    options.planeFraction = 1;
    const Scene scene = makeScene(ESSENTIAL, options);
    const Mat K(scene.K);
    const TwoViewPair pair(column(scene.points1).clone(), column(scene.points2).clone(), K, K);
    const TwoViewGeometry whole = estimateTwoViewGeometry(pair);
    ASSERT_EQ((int)TWO_VIEW_PLANAR, whole.configuration);
    int cancelled = 0;
    for (int last = 1; last < 40; ++last)
    {
        int asked = 0;
        // the progress function returns false only in call number `last`
        const ProgressScope scope([&asked, last](const Report&) { return ++asked != last; });
        const TwoViewGeometry found = estimateTwoViewGeometry(pair);
        if (found.configuration == TWO_VIEW_UNDEFINED)
        {
            EXPECT_EQ("canceled", found.reason);
            EXPECT_EQ((int)STOP_CANCELLED, found.report.stop) << last;
            EXPECT_EQ(0, found.report.iterations) << last;
            ++cancelled;
            continue;
        }
        EXPECT_GT(last, asked);
        EXPECT_EQ(whole.configuration, found.configuration);
        EXPECT_TRUE(sameBits(whole.mask, found.mask) && sameBits(whole.H, found.H));
        break;
    }
    // the run must be canceled if the first call of the progress function returns false
    EXPECT_GT(cancelled, 0);
}

TEST(Usac_TwoViewBatch, cancelled)
{
    int asked = 0;
    const ProgressScope scope([&asked](const Report&) { return ++asked < 2; });
    const std::vector<TwoViewPair> pairs = mixedPairs();
    int undefined = 0;
    for (const TwoViewGeometry& found :
         estimateTwoViewGeometries(pairs, Params(), TwoViewRules(), 1))
        if (found.configuration == TWO_VIEW_UNDEFINED)
        {
            EXPECT_EQ("canceled", found.reason);
            EXPECT_EQ((int)STOP_CANCELLED, found.report.stop);
            EXPECT_EQ(0, found.inliers);
            ++undefined;
        }
    EXPECT_GT(undefined, 10);
}

//! The message of the exception that a call raises; empty if there is none.
template <class Call>
String raisedBy(const Call& call)
{
    try
    {
        call();
    }
    catch (const Exception& mistake)
    {
        return mistake.err;
    }
    return String();
}

void expectRefused(const char* named, const TwoViewPair& pair, const Params& params,
                   const TwoViewRules& rules)
{
    const String said = raisedBy([&] { estimateTwoViewGeometry(pair, params, rules); });
    EXPECT_EQ(0u, said.find(String(named) + ": ")) << named << " is not named: " << said;
}

TEST(Usac_TwoViewBatch, mistakes_are_named)
{
    const TwoViewPair right = mixedPairs()[0];
    const auto pair = [&](const char* named, const std::function<void(TwoViewPair&)>& spoil) {
        TwoViewPair wrong = right;
        spoil(wrong);
        expectRefused(named, wrong, Params(), TwoViewRules());
    };
    pair("points1", [](TwoViewPair& p) { p.points1 = Mat::zeros(5, 1, CV_64F); });
    pair("cameraMatrix2", [](TwoViewPair& p) { p.cameraMatrix2 = Mat::eye(2, 2, CV_64F); });
    pair("distCoeffs1", [](TwoViewPair& p) { p.distCoeffs1 = Mat::zeros(3, 1, CV_64F); });
    pair("distCoeffs2", [](TwoViewPair& p) {
        p.cameraMatrix2.release();
        p.distCoeffs2 = Mat::zeros(4, 1, CV_64F);
    });
    pair("taken1", [](TwoViewPair& p) { p.taken1 = Mat::zeros(3, 2, CV_64F); });
    pair("scores", [](TwoViewPair& p) { p.scores.assign(3, 1.f); });
    const auto rule = [&](const char* named, const std::function<void(TwoViewRules&)>& spoil) {
        TwoViewRules wrong;
        spoil(wrong);
        expectRefused(named, right, Params(), wrong);
        EXPECT_EQ(0u, raisedBy([&] { wrong.check(); }).find(named));
    };
    rule("minInliers", [](TwoViewRules& r) { r.minInliers = 0; });
    rule("inlierRatio", [](TwoViewRules& r) { r.inlierRatio = NAN; });
    rule("planarRatio", [](TwoViewRules& r) { r.planarRatio = 1.5; });
    rule("calibrationRatio", [](TwoViewRules& r) { r.calibrationRatio = -0.1; });
    rule("ratios", [](TwoViewRules& r) { r.ratios.push_back(0); });
    Params params;
    params.initialModel.assign(9, 1.);
    expectRefused("initialModel", right, params, TwoViewRules());
    params = Params();
    params.threshold = 0;
    EXPECT_NE(String::npos,
              raisedBy([&] { estimateTwoViewGeometry(right, params); }).find("threshold"));
    expectRefused("quality", right, Params::lmeds(), TwoViewRules());
    EXPECT_NE("",
              raisedBy([&] { estimateTwoViewGeometries({right}, Params(), TwoViewRules(), -1); }));
}

//! Probability that a sample without replacement has only true matches.
double rightSamples(int sampleSize, int matches, int right)
{
    double part = 1;
    for (int i = 0; i < sampleSize; ++i)
        part *= (double)(right - i) / (matches - i);
    return part;
}

TEST(Usac_TwoViewRules, samples)
{
    // for fast(), the number of samples is that of the standard formula. For E and F, the default
    // search (`usual`) needs fewer samples: one sample counts as 4 for F and, with n inliers, as
    // (n / 11.5)^2, at least 1 and at most 4, for E (measured, see two_view/rules.cpp).
    Params params = Params::fast();
    params.confidence = 0.999;
    params.maxIterations = 7070;
    const TwoViewRules rules;
    const double right = rightSamples(5, 75, 19),
                 expected = std::ceil(std::log(0.001) / std::log1p(-right));
    EXPECT_EQ(expected, rules.samples(params, 5, 75));
    EXPECT_NEAR(1 - std::pow(1 - right, 7070), rules.reached(params, 5, 75), 1e-12);
    // at least 15 inliers (minInliers) are assumed, here all matches: the minimum of 500 samples
    EXPECT_EQ(500, rules.samples(params, 7, 15));
    EXPECT_EQ(1, rules.reached(params, 7, 15));
    EXPECT_GT(rules.samples(params, 7, 1000000000), 1e5);
    Params usual;
    usual.confidence = 0.999;
    EXPECT_NEAR(std::log(0.001) / std::log1p(-rightSamples(5, 200, 50)) / 4,
                rules.samples(usual, 5, 200), 1);
    EXPECT_NEAR(std::log(0.001) / std::log1p(-rightSamples(5, 60, 15)) / std::pow(15 / 11.5, 2),
                rules.samples(usual, 5, 60), 1);
    EXPECT_NEAR(std::log(0.001) / std::log1p(-rightSamples(7, 200, 50)) / 4,
                rules.samples(usual, 7, 200), 1);
    EXPECT_NEAR(std::log(0.001) / std::log1p(-rightSamples(4, 200, 50)),
                rules.samples(usual, 4, 200), 1);
}

//! If the inlier ratios of other pairs of the collection are known, fewer samples must be asked
//! for: the smallest number with which the expected fraction of missed pairs, over these pairs and
//! one more pair with a lower ratio, is at most 1 - confidence.
TEST(Usac_TwoViewRules, samples_of_a_collection)
{
    Params params = Params::fast();
    params.confidence = 0.999;
    TwoViewRules rules;
    const double plain = rules.samples(params, 5, 80);
    rules.ratios.assign(40, 0.45);
    const double known = rules.samples(params, 5, 80);
    EXPECT_LT(known, 0.8 * plain);
    for (double samples : {known, known - 1})
    {
        double lost = 0;
        for (int k = -1; k < 8; ++k)  // -1: the pairs with known ratios; otherwise a pair with a
                                      // ratio between 0.25 and the known one
        {
            const double ratio = k < 0 ? 0.45 : 0.25 + 0.2 * (k + 0.5) / 8;
            const double part = rightSamples(5, 80, std::max((int)std::ceil(ratio * 80), 15));
            lost += (k < 0 ? 40. : 1. / 8) / 41 * std::pow(1 - part, samples);
        }
        EXPECT_EQ(samples == known, lost <= 0.001) << lost;
    }
}

//! The expected number of inliers is the inlier ratio times the number of matches, rounded up. In
//! double precision, 0.07 times 100 is a little more than 7. The number must nevertheless be 7.
TEST(Usac_TwoViewRules, rounding_of_the_inlier_ratio)
{
    Params params = Params::fast();
    params.confidence = 0.999;
    TwoViewRules rules;
    rules.inlierRatio = 0.07;
    rules.minInliers = 1;
    const double seven = std::log(0.001) / std::log1p(-rightSamples(4, 100, 7)),
                 eight = std::log(0.001) / std::log1p(-rightSamples(4, 100, 8));
    EXPECT_NEAR(seven, rules.samples(params, 4, 100), 1 + 1e-6 * seven);
    rules.inlierRatio = 0.0701;
    EXPECT_NEAR(eight, rules.samples(params, 4, 100), 1 + 1e-6 * eight);
}

}  // namespace
}  // namespace opencv_test
