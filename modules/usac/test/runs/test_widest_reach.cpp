// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"

namespace opencv_test {
namespace {

typedef testing::TestWithParam<int> Usac_WidestReach;
INSTANTIATE_TEST_CASE_P(/**/, Usac_WidestReach, testing::ValuesIn(TWO_VIEW_PROBLEMS));

//! Mean error over six scenes in pixels; the masks are checked, too.
double meanError(int problem, Params params, double pixels)
{
    const int SCENES = 6;
    params.threshold = pixels;
    double sum = 0;
    for (int seed = 1; seed <= SCENES; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        const Scene scene = makeScene((ProblemType)problem, options);
        Report report;
        Mat mask;
        const Mat model = estimate(scene, params, mask, &report);
        EXPECT_EQ(pixels, report.threshold);
        if (!model.empty())
            checkResult(scene, pixels, model, mask, report, params.widestReach);
        sum += modelError(scene, model) / SCENES;
    }
    return sum;
}

//! The noise is 0.5 pixels. With thresholds of 0.005 to 0.6 pixels, errors must be at most 1.3
//! times those with 1.5 pixels. They must be larger if `widestReach`, the largest multiple of the
//! threshold to which the search can widen it, is too small.
TEST_P(Usac_WidestReach, thresholdsBelowTheNoise)
{
    const double usual = meanError(GetParam(), Params::magsacPlusPlus(), 1.5);
    const double thresholds[] = {0.005, 0.05, 0.3, 0.6};
    for (int i = 0; i < 4; ++i)
        EXPECT_LT(meanError(GetParam(), Params::magsacPlusPlus(), thresholds[i]), 1.3 * usual)
            << thresholds[i];
    EXPECT_LT(meanError(GetParam(), Params::magsac(), 0.1), 1.3 * usual);
    Params narrow = Params::magsacPlusPlus();
    narrow.widestReach = 1;
    EXPECT_GT(meanError(GetParam(), narrow, 0.1), 2 * usual);
    narrow.widestReach = 5;  // at most a fifth of the reach that suits the noise
    const double between = meanError(GetParam(), narrow, 0.1);
    EXPECT_GT(between, 1.1 * usual);
}

//! If the noise is not larger than the threshold allows for, `widestReach` must change no bit of
//! the model. If the noise is larger, `widestReach` must change the model. In both cases, the
//! number of threads must change no bit.
TEST_P(Usac_WidestReach, bits)
{
    const Scene scene = makeScene((ProblemType)GetParam());
    for (int below = 0; below < 2; ++below)
    {
        Params params = Params::magsacPlusPlus();
        params.threshold = below ? 0.1 : 2;
        Mat masks[3], models[3];
        for (int i = 0; i < 3; ++i)
        {
            params.threads = i == 1 ? 3 : 1;
            params.widestReach = i == 2 ? 1 : 1000;
            models[i] = estimate(scene, params, masks[i]);
        }
        EXPECT_TRUE(sameBits(models[0], models[1]));
        EXPECT_TRUE(sameBits(masks[0], masks[1]));
        EXPECT_EQ(below == 0, sameBits(models[0], models[2]));
    }
}

//! A correct model can have no inliers at all, because the mask uses the small threshold. Such a
//! model must be returned.
TEST(Usac_WidestReach_Mask, mayBeEmpty)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    Params params = Params::magsacPlusPlus();
    params.threshold = 1e-4;
    params.widestReach = 1e6;
    Mat mask;
    Report report;
    const Mat model = estimate(scene, params, mask, &report);
    EXPECT_LT(modelError(scene, model), 0.3);
    EXPECT_EQ(scene.size(), (int)mask.total());
    EXPECT_EQ(0, countNonZero(mask));
    EXPECT_EQ(0, report.inliers);
    EXPECT_NE((int)STOP_NO_MODEL, report.stop);
}

//! A check that becomes active when the internal threshold has grown (if `wider` is true) or has
//! shrunk (otherwise). If `wider` is true, the active check rejects models that have most of their
//! inliers in the first group of points; otherwise it rejects all models.
class RefusesGroup : public Degeneracy
{
public:
    RefusesGroup(int points_, bool wider_)
        : points(points_), wider(wider_), last(0), active(false), refused(0)
    {}

    void start(const Context& context) CV_OVERRIDE
    {
        last = context.points.threshold;
        active = false;
    }

    bool recover(const Context& context, State&, const int*, Model& model, Quality&) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        active |= wider ? p.threshold > last : p.threshold < last;
        last = p.threshold;
        std::vector<float> errors(p.size);
        context.components.residual->squaredErrors(p, model, 0, p.size, errors.data());
        int first = 0, others = 0;
        for (int i = 0; i < p.size; ++i)
            if (errors[i] <= p.threshold * p.threshold)
                ++(p.inputIndex[i] < points ? first : others);
        const bool refuses = active && (!wider || first > others);
        refused += refuses;
        return !refuses;
    }

    const int points;
    const bool wider;
    double last;
    bool active;
    int refused;
};

//! Two groups of points, each with a homography of its own, and a RefusesGroup check.
struct TwoGroups
{
    TwoGroups(int seed, double noise, int others, int outliers, bool wider)
    {
        SceneOptions options;
        options.seed = seed;
        options.noise = noise;
        options.inliers = 90;
        options.outliers = outliers;
        first = both = makeScene(HOMOGRAPHY, options);
        options.inliers = others;
        options.outliers = 0;
        options.seed = 1000 + seed;
        second = makeScene(HOMOGRAPHY, options);
        both.points1.insert(both.points1.end(), second.points1.begin(), second.points1.end());
        both.points2.insert(both.points2.end(), second.points2.begin(), second.points2.end());
        check = makePtr<RefusesGroup>(90, wider);
    }

    Mat run(const Params& params)
    {
        const Ptr<Usac> usac = createUsac(both, params);
        usac->components().degeneracies.push_back(check);
        return usac->run();
    }

    Scene first, second, both;
    Ptr<RefusesGroup> check;
};

//! If a check rejects the best model after the reach has grown, this model must not be returned.
//! The model of the other group must be found in at least four of five scenes.
TEST(Usac_WidestReach_Checks, refused_models_do_not_stay_best)
{
    int found = 0;
    for (int seed = 1; seed <= 5; ++seed)
    {
        TwoGroups groups(seed, 0.5, 60, 0, true);
        Params params = Params::magsacPlusPlus();
        params.threshold = 0.1;
        params.maxIterations = 1000;
        params.termination = 0;
        const Mat model = groups.run(params);
        EXPECT_GT(groups.check->refused, 0) << seed;
        found += !model.empty();
        EXPECT_TRUE(model.empty() || modelError(groups.second, model) < 3) << seed;
    }
    EXPECT_GE(found, 4);  // it would be 0 if the reach grew only after the last sample
}

//! A rejected model must not be returned either if the reach first grows because of a poor model,
//! found with few samples, and then shrinks again at the end. The check then rejects all models, so
//! that the run must return no model. This must happen in at least two of the 200 scenes.
TEST(Usac_WidestReach_Checks, refused_models_do_not_stay_best_at_the_end)
{
    int refusals = 0;
    for (int seed = 1; seed <= 200; ++seed)
    {
        TwoGroups groups(seed, 0.02, 20, 180, false);
        Params params = Params::magsac();
        params.threshold = 0.005;
        params.maxIterations = 200;
        params.significance = 1;
        const Mat model = groups.run(params);
        refusals += groups.check->refused > 0;
        EXPECT_TRUE(groups.check->refused == 0 || model.empty()) << seed;
    }
    EXPECT_GE(refusals, 2);
}

}
}  // namespace
