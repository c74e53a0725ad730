// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "loop/ransac.hpp"
#include "problems/two_view/two_view.hpp"
#include "support/run_context.hpp"

// Tests of what a search forgets when its threshold changes: samples that a criterion has counted,
// and what the degeneracy checks have found.

namespace opencv_test {
namespace {

//! After Ransac::forgetSamples(), samples that followed the order do not count any longer: a
//! criterion must ask for new ones.
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

//! Quality of a model after a check has seen the threshold `before`, and then `now` (in pixels).
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
//! points in image 1. With a threshold of 6 pixels, the check for crowded places must take these
//! matches for one place, so that they count as a single inlier. With a tenth of this threshold,
//! they are not one place. The result must not depend on an earlier threshold.
TEST(Usac_ChangedThreshold, placesAreSearchedAgain)
{
    RNG rng(3);
    Scene scene = makeScene(HOMOGRAPHY);
    scene.points1.clear();
    scene.points2.clear();
    for (int i = 0; i < 200; ++i)
    {
        scene.points1.push_back(uniformPoint(rng, 0., 640., 0., 480.));
        scene.points2.push_back(i % 2 ? uniformPoint(rng, 0., 640., 0., 480.)
                                      : Point2d(320, 240) + uniformPoint(rng, -6., 6.));
    }
    const Matx33d shrinks(1e-3, 0, 320, 0, 1e-3, 240, 0, 0, 1);
    const Quality wide = discounted(createCrowdedPlaces(), scene, shrinks, 6, 6),
                  narrow = discounted(createCrowdedPlaces(), scene, shrinks, 0.6, 0.6);
    EXPECT_LT(wide.inliers, 20);
    EXPECT_EQ(wide.cost, discounted(createCrowdedPlaces(), scene, shrinks, 0.6, 6).cost);
    EXPECT_EQ(narrow.cost, discounted(createCrowdedPlaces(), scene, shrinks, 6, 0.6).cost);
}

//! Half of the matches share a point of image 2, up to at most two pixels in each coordinate. With
//! a threshold of 4 pixels, a sample that contains two of these matches must be rejected, also if
//! the search has begun with a threshold so narrow that they do not seem to share a point.
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

//! A check of a caller that compares the current threshold with the one it was told.
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

//! A check must be told of each new threshold before it is asked about a model: of the estimated
//! threshold, of a larger reach, and of the threshold of polishing and of refinements. With few
//! points, polishing tries other initial models, which the checks examine.
TEST(Usac_ChangedThreshold, checksAreTold)
{
    for (int kind : {0, 1, 2})
    {
        SceneOptions options;
        options.setSize(kind == 1 ? 200 : 24, 0.7);
        options.noise = kind == 1 ? 1 : 0.2;
        const Scene scene = makeScene(HOMOGRAPHY, options);
        Params params = kind == 0   ? Params::lmeds()
                        : kind == 1 ? Params::magsac()
                                    : Params::automatic();
        params.threshold = kind == 1 ? 0.1 : 3;
        const Ptr<Usac> usac = createUsac(scene, params);
        const Ptr<Informed> check = makePtr<Informed>();
        usac->components().degeneracies.push_back(check);
        Mat mask;
        const Mat model = usac->run(mask);
        ASSERT_FALSE(model.empty()) << kind;
        EXPECT_GT(check->told, 0) << kind;
        EXPECT_EQ(0, check->wrong) << kind;
        EXPECT_FALSE(usac->refine(model, noArray(), mask).empty()) << kind;
        EXPECT_EQ(0, check->wrong) << kind;
    }
}

}  // namespace
}  // namespace opencv_test
