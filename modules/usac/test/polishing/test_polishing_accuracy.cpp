// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/problem_objects.hpp"

// The accuracy of polishing is compared with the best possible one, that of least squares over the
// true matches.

namespace opencv_test {
namespace {

const double THRESHOLD = 1.5;

//! The scene without its wrong matches.
Scene trueMatches(const Scene& scene)
{
    Scene result = scene;
    std::vector<Point2d>* const to[] = {&result.points1, &result.points2, &result.clean1,
                                        &result.clean2};
    const std::vector<Point2d>* const from[] = {&scene.points1, &scene.points2, &scene.clean1,
                                                &scene.clean2};
    for (int k = 0; k < 4; ++k)
    {
        to[k]->clear();
        for (int i = 0; i < scene.size(); ++i)
            if (scene.truth[i])
                to[k]->push_back((*from[k])[i]);
    }
    result.truth.assign(result.points1.size(), 1);
    result.onPlane.assign(result.points1.size(), 0);
    return result;
}

//! Least squares over all matches, started at the exact model.
Mat leastSquares(const Scene& scene)
{
    const Ptr<Usac> usac = createUsac(scene, Params());
    const Correspondences& points = usac->points();
    std::vector<int> all(points.size);
    for (int i = 0; i < points.size; ++i)
        all[i] = i;
    Model model = toInternal(points, scene.model);
    for (int i = 0; i < 5; ++i)
        EXPECT_TRUE(usac->components().nonMinimalSolver->fit(points, all.data(), points.size, 0,
                                                             model, 20));
    return Mat(toInput(points, model));
}

//! The result of polishing the exact model.
Mat polished(const Scene& scene, const Params& params)
{
    const Ptr<Usac> usac = createUsac(scene, params);
    Arena arena;
    const Context context(usac->points(), usac->components(), params, arena);
    usac->components().start(context);
    Model model = toInternal(usac->points(), scene.model);
    usac->components().polisher->polish(context, model);
    return Mat(toInput(usac->points(), model));
}

SceneOptions optionsOf(Motion motion, double noise, uint64 seed)
{
    SceneOptions options;
    options.motion = motion;
    options.noise = noise;
    options.seed = seed;
    options.outliers = 20;
    return options;
}

//! The test parameters are a problem and a motion.
typedef testing::TestWithParam<std::tuple<int, int>> Usac_Polishing_Accuracy;

/** The root mean square error of polishing over the scenes must be at most 1.1 times that of least
squares over the true matches. Polishing starts from the exact model: a model from the search can
fit an outlier better than the true model does (mostly under forward motion), and polishing would
keep this outlier. */
TEST_P(Usac_Polishing_Accuracy, isNearlyThatOfLeastSquares)
{
    const double noises[] = {THRESHOLD / 10, THRESHOLD / 3};
    for (int k = 0; k < 2; ++k)
    {
        double best = 0, reached = 0;
        for (uint64 seed = 1; seed <= 12; ++seed)
        {
            const Scene scene = makeScene(
                (ProblemType)std::get<0>(GetParam()),
                optionsOf((Motion)std::get<1>(GetParam()), noises[k], seed));
            Params params;
            params.threshold = THRESHOLD;
            const double exact = modelError(scene, leastSquares(trueMatches(scene)));
            const double ours = modelError(scene, polished(scene, params));
            best += exact * exact;
            reached += ours * ours;
        }
        RecordProperty("ratio", cv::format("%.3f", std::sqrt(reached / best)));
        EXPECT_LE(std::sqrt(reached / best), 1.1) << "noise " << noises[k];
    }
}

/** The threshold is at least 300 times the noise. For H and F, image 2 is also scaled to
coordinates below 1, but the threshold is not, so that almost every H or F has all matches as
inliers. Polishing must nevertheless reach nearly the accuracy of least squares: an error of at most
1.5 times that of least squares (F: 3 times). */
TEST_P(Usac_Polishing_Accuracy, thresholdFarAboveTheNoise)
{
    const ProblemType problem = (ProblemType)std::get<0>(GetParam());
    for (uint64 seed = 1; seed <= 5; ++seed)
    {
        SceneOptions options = optionsOf((Motion)std::get<1>(GetParam()), 0.01, seed);
        options.inliers = problem == HOMOGRAPHY ? 10 : 20;
        options.outliers = 0;
        Scene scene = makeScene(problem, options);
        const double best = modelError(scene, leastSquares(scene));
        const Matx33d S(1. / 640, 0, 0, 0, 1. / 640, 0, 0, 0, 1);
        Params params;
        params.threshold = 3;
        Mat model;
        if (problem == ESSENTIAL)
            model = estimate(scene, params);
        else
        {
            for (int i = 0; i < scene.size(); ++i)
                scene.points2[i] *= 1. / 640;
            model = estimate(scene, params);
            ASSERT_FALSE(model.empty());
            const Matx33d M(model.ptr<double>());
            model = Mat(problem == HOMOGRAPHY ? S.inv() * M : S * M, true);
        }
        EXPECT_LE(modelError(scene, model), (problem == FUNDAMENTAL ? 3 : 1.5) * best + 1e-6)
            << "seed " << seed;
    }
}

INSTANTIATE_TEST_CASE_P(All, Usac_Polishing_Accuracy,
                        testing::Combine(testing::Range(0, 3),
                                         testing::Range((int)MOTION_GENERAL, (int)MOTION_CAR + 1)));

}
}  // namespace
