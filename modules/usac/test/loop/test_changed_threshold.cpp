// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "loop/ransac.hpp"
#include "problems/two_view/two_view.hpp"
#include "support/problem_objects.hpp"
#include "support/run_context.hpp"

// Tests of what a search discards when its threshold changes: samples that a criterion has counted,
// and results of the degeneracy checks.

namespace opencv_test {
namespace {

//! After Ransac::forgetSamples(), the samples that PROSAC has drawn in the order of the scores must
//! no longer count: the criterion must require new ones.
TEST(Usac_ChangedThreshold, orderedSamplesAreDrawnAgain)
{
    for (int termination : {TERMINATION_ORDER | TERMINATION_STANDARD, (int)TERMINATION_PROSAC})
        for (int every : {1, 4})
        {
            if (termination != TERMINATION_PROSAC && every == 1)
                continue;  // the criterion needs uniform samples, too
            SceneOptions options;
            options.setSize(400, 0.25);
            options.scoreInformation = 0.9;
            const Scene scene = makeScene(FUNDAMENTAL, options);
            Params params;
            params.sampler = SAMPLER_PROSAC;
            params.scores = scene.scores;
            params.termination = termination;
            params.orderedEvery = every;
            params.maxIterations = 100000;
            const Ptr<Usac> usac = createUsac(scene, params);
            const RunContext run(usac->points(), usac->components(), params);
            State state;
            Ransac search(run, state);
            search.run();
            const int ordered = state.orderedSamples, first = state.iteration;
            EXPECT_GE(ordered, 20);
            EXPECT_LT(first, params.maxIterations);
            search.forgetSamples();

            EXPECT_EQ(first, state.forgotten);
            EXPECT_EQ(0, state.orderedSamples);
            search.thresholdChanged();
            search.run();
            EXPECT_GE(state.orderedSamples, ordered / 4) << termination << " " << every;
            EXPECT_LT(state.iteration, params.maxIterations);
        }
}

//! Quality of a model after a check that was started with the threshold `before` has been notified
//! of the threshold `now` (both in pixels).
Quality discounted(const Ptr<Degeneracy>& check, const Scene& scene, const Matx33d& given,
                   double before, double now)
{
    Params params;
    params.threshold = now;
    const Ptr<Usac> usac = Usac::create(scene.problem, scene.points1, scene.points2, params);
    Correspondences points = usac->points();
    const double unit = points.threshold / now;
    points.threshold = unit * before;
    const RunContext run(points, usac->components(), params);
    const Context& context = run;
    check->start(context);
    points.threshold = unit * now;
    check->thresholdChanged(context);
    const Model model = toInternal(points, given);
    Quality quality = context.rate(model);
    check->discount(context, model, quality);
    return quality;
}

//! Half of the matches have their points of image 2 in one square of side 12 pixels, and unrelated
//! points in image 1. With a threshold of 6 pixels, the check for crowded places must treat these
//! matches as one crowded place, so that they count as a single inlier. With a tenth of this
//! threshold, only about ten of them are inliers, too few for a crowded place. The result must not
//! depend on an earlier threshold.
TEST(Usac_ChangedThreshold, placesAreSearchedAgain)
{
    RNG rng(3);
    Scene scene = makeScene(HOMOGRAPHY);
    scene.points1.clear();
    scene.points2.clear();
    for (int i = 0; i < 200; ++i)
    {
        scene.points1.push_back(uniformPoint(rng, 0., 640., 0., 480.));
        scene.points2.push_back(
            i % 2 ? uniformPoint(rng, 0., 640., 0., 480.)
                  : Point2d(320, 240) + uniformPoint(rng, i < 20 ? -0.3 : -6., i < 20 ? 0.3 : 6.));
    }
    const Matx33d shrinks(1e-3, 0, 320, 0, 1e-3, 240, 0, 0, 1);
    const Quality wide = discounted(createCrowdedPlaces(), scene, shrinks, 6, 6),
                  narrow = discounted(createCrowdedPlaces(), scene, shrinks, 0.6, 0.6);
    EXPECT_EQ(1, wide.inliers);
    EXPECT_GE(narrow.inliers, 8);
    EXPECT_EQ(wide.cost, discounted(createCrowdedPlaces(), scene, shrinks, 0.6, 6).cost);
    EXPECT_EQ(narrow.cost, discounted(createCrowdedPlaces(), scene, shrinks, 6, 0.6).cost);
}

//! Half of the matches share a point of image 2, with deviations of at most two pixels in each
//! coordinate. With a threshold of 4 pixels, a sample that contains two of these matches must be
//! rejected, even if the search began with a threshold so small that they did not seem to share a
//! point.
TEST(Usac_ChangedThreshold, sharedPointsAreSearchedAgain)
{
    RNG rng(3);
    std::vector<Point2d> points1, points2;
    for (int i = 0; i < 200; ++i)
    {
        points1.push_back(uniformPoint(rng, 0., 640., 0., 480.));
        points2.push_back(i % 2 ? uniformPoint(rng, 0., 640., 0., 480.)
                                : Point2d(320, 240) + uniformPoint(rng, -2., 2.));
    }
    const Params params;
    const Ptr<Usac> usac = Usac::create(FUNDAMENTAL, points1, points2, params);
    Correspondences points = usac->points();
    const double unit = points.threshold / params.threshold;
    const RunContext run(points, usac->components(), params);
    int sample[7], size = 0;
    for (int i = 0; size < 2; ++i)
        if (points.inputIndex[i] % 2 == 0)
            sample[size++] = i;
    for (int i = 0; size < 7; ++i)
        if (points.inputIndex[i] % 2 == 1)
            sample[size++] = i;
    const Ptr<Degeneracy> check = createSharedPoints();
    points.threshold = 0.01 * unit;
    check->start(run);
    EXPECT_TRUE(check->validSample(run, sample));
    points.threshold = 4 * unit;
    check->thresholdChanged(run);
    EXPECT_FALSE(check->validSample(run, sample));
}

//! A sampler of a caller that draws uniform samples and counts the calls of start().
class StartedSampler : public Sampler
{
public:
    StartedSampler() : starts(0) {}
    void start(const Context&) CV_OVERRIDE { ++starts; }
    void sample(const Context& context, State& state, int* out) CV_OVERRIDE
    {
        state.rng.distinct(context.points.size, context.components.minimalSolver->sampleSize(),
                           out);
    }
    int starts;
};

//! A criterion of a caller that asks for a number of samples, whatever the best model is.
class Always : public Termination
{
public:
    explicit Always(int samples_) : samples(samples_) {}
    int iterations(const Context&, const State&) const CV_OVERRIDE { return samples; }

private:
    const int samples;
};

//! After Ransac::forgetSamples(), the sampler begins anew, and a criterion of a caller that asks
//! for 40 samples gets 40 further ones.
TEST(Usac_ChangedThreshold, forgottenSamplesDoNotCount)
{
    Params params;
    const Ptr<Usac> usac = createUsac(makeScene(HOMOGRAPHY), params);
    const Ptr<StartedSampler> sampler = makePtr<StartedSampler>();
    usac->components().sampler = sampler;
    usac->components().terminations.assign(1, makePtr<Always>(40));
    const RunContext run(usac->points(), usac->components(), params);
    const int starts = sampler->starts;
    State state;
    Ransac search(run, state);
    search.run();
    EXPECT_EQ(40, state.iteration);
    search.forgetSamples();
    EXPECT_EQ(starts + 1, sampler->starts);
    search.thresholdChanged();
    search.run();
    EXPECT_EQ(80, state.iteration);
}

//! A caller's check that compares the current threshold with the one of the last notification, that
//! is, of the last call of start() or thresholdChanged().
class Informed : public Degeneracy
{
public:
    Informed() : known(0), told(0), wrong(0) {}
    void start(const Context& context) CV_OVERRIDE { known = context.points.threshold; }
    void thresholdChanged(const Context& context) CV_OVERRIDE
    {
        known = context.points.threshold;
        ++told;
    }
    bool recover(const Context& context, State&, const int*, Model&, Quality&) CV_OVERRIDE
    {
        wrong += context.points.threshold != known;
        return true;
    }
    void discount(const Context& context, const Model&, Quality&) CV_OVERRIDE
    {
        wrong += context.points.threshold != known;
    }
    double known;
    int told, wrong;
};

//! Runs an estimation and a refinement with the check Informed, which must be notified of each new
//! threshold before it examines a model. @return the number of calls of thresholdChanged()
int timesTold(const Scene& scene, const Params& params)
{
    const Ptr<Usac> usac = createUsac(scene, params);
    const Ptr<Informed> check = makePtr<Informed>();
    usac->components().degeneracies.push_back(check);
    Mat mask;
    const Mat model = usac->run(mask);
    EXPECT_FALSE(model.empty());
    EXPECT_EQ(0, check->wrong);
    if (!model.empty())
    {
        EXPECT_FALSE(usac->refine(model, noArray(), mask).empty());
        EXPECT_EQ(0, check->wrong);
    }
    return check->told;
}

//! Polishing has a threshold of its own with #QUALITY_LMEDS. With few points, robust polishing
//! tries other initial models, which the checks examine.
TEST(Usac_ChangedThreshold, checksAreToldOfPolishing)
{
    SceneOptions options;
    options.setSize(24, 0.7);
    options.noise = 0.2;
    Params params = Params::lmeds();
    params.threshold = 3;
    params.polishing = POLISHING_ROBUST;
    EXPECT_GT(timesTold(makeScene(HOMOGRAPHY, options), params), 0);
}

//! The threshold is a tenth of the noise, so that the search must enlarge the reach, see
//! Params::widestReach.
TEST(Usac_ChangedThreshold, checksAreToldOfTheReach)
{
    SceneOptions options;
    options.setSize(200, 0.7);
    options.noise = 1;
    Params params = Params::magsac();
    params.threshold = 0.1;
    EXPECT_GT(timesTold(makeScene(HOMOGRAPHY, options), params), 0);
}

//! In some of the scenes with a plane, the search continues with another estimated threshold.
//! Polishing is off, because it would notify the checks, too.
TEST(Usac_ChangedThreshold, checksAreToldOfTheEstimate)
{
    int told = 0;
    for (uint64 seed = 1; seed <= 40; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.outliers = 60;
        options.planeFraction = 0.9;
        Params params = Params::automatic();
        params.threshold = 15;
        params.polishing = POLISHING_NONE;
        told += timesTold(makeScene(ESSENTIAL, options), params);
    }
    EXPECT_GT(told, 0);
}

//! DEGENSAC stores the last plane and the F that it has found from this plane. After a change of
//! the threshold, it must not return this F with its score under the old threshold.
TEST(Usac_ChangedThreshold, planeIsHandledAgain)
{
    int replaced = 0, handled = 0;
    for (uint64 seed = 1; seed <= 5; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.planeFraction = 0.8;
        const Scene scene = makeScene(FUNDAMENTAL, options);
        const Params params;
        const Ptr<Usac> usac = createUsac(scene, params);
        Correspondences points = usac->points();
        const double unit = points.threshold / params.threshold;
        const RunContext run(points, usac->components(), params);
        int sample[MAX_SAMPLE_SIZE], on = 0, off = 6;
        for (int i = 0; i < points.size && (on < 6 || off < 7); ++i)
        {
            const int row = points.inputIndex[i];
            if (scene.onPlane[row] && on < 6)
                sample[on++] = i;
            else if (scene.truth[row] && !scene.onPlane[row] && off < 7)
                sample[off++] = i;
        }
        Model models[MAX_MODELS];
        ASSERT_GT(usac->components().minimalSolver->solve(points, sample, models), 0);
        const Ptr<Degeneracy> degensac = createDegensac();
        degensac->start(run);
        for (double threshold : {3., 0.5})
        {
            points.threshold = unit * threshold;
            degensac->thresholdChanged(run);
            State state;
            Model model = models[0];
            Quality quality = run.context.rate(model);
            EXPECT_TRUE(degensac->recover(run, state, sample, model, quality));
            EXPECT_EQ(run.context.rate(model).cost, quality.cost) << seed;
            (threshold == 3 ? replaced : handled) += state.degenerate && model != models[0];
        }
    }
    EXPECT_GT(replaced, 0);
    EXPECT_GT(handled, 0);
}

}  // namespace
}  // namespace opencv_test
