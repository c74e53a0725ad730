// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/run_context.hpp"
#include "support/contracts.hpp"
#include "support/problem_objects.hpp"
#include "problems/share_a_point.hpp"

namespace opencv_test {
namespace {

typedef testing::TestWithParam<int> Usac_SharedPoints;
INSTANTIATE_TEST_CASE_P(/**/, Usac_SharedPoints, testing::Values((int)FUNDAMENTAL, (int)ESSENTIAL));

Scene sceneWith(int problem, OutlierModel outliers, uint64 seed)
{
    SceneOptions options;
    options.setSize(1000, 0.3);
    options.outlierModel = outliers;
    options.seed = seed;
    return makeScene((ProblemType)problem, options);
}

//! The scenes have 30 % inliers. In OUTLIERS_TARGETS scenes, all outliers are at one of two points
//! of image 2 (35 % of the matches each); in OUTLIERS_LINE scenes, half of the outliers are on a
//! line in image 2. The true model must be found. Without DEGENERACY_REPEATED, the search must fail
//! in at least five of six OUTLIERS_TARGETS scenes.
TEST_P(Usac_SharedPoints, targetsDoNotWin)
{
    int wrongWithout = 0;
    for (uint64 seed = 1; seed <= 6; ++seed)
    {
        Params params;
        for (int line = 0; line < 2; ++line)
        {
            const Scene scene = sceneWith(GetParam(), line ? OUTLIERS_LINE : OUTLIERS_TARGETS,
                                          seed);
            Report report;
            Mat mask;
            const Mat model = estimate(scene, params, mask, &report);
            EXPECT_LT(modelError(scene, model), 0.4) << seed << " " << line;
            checkResult(scene, params.threshold, model, mask, report);
        }
        params.degeneracy &= ~DEGENERACY_REPEATED;
        const Scene scene = sceneWith(GetParam(), OUTLIERS_TARGETS, seed);
        wrongWithout += modelError(scene, estimate(scene, params)) > 3;
    }
    EXPECT_GE(wrongWithout, 5);
}

//! The quality of a model before and after the check for shared points.
struct Checked
{
    Checked(const Scene& scene, const std::vector<Point2d>& points1,
            const std::vector<Point2d>& points2, const Matx33d& given, double inlierThreshold = 1.5)
    {
        Params params;
        params.threshold = inlierThreshold;
        const Mat K = scene.problem == ESSENTIAL ? Mat(scene.K) : Mat();
        const Ptr<Usac> usac = Usac::create(scene.problem, points1, points2, params, K);
        Arena arena;
        const Context context(usac->points(), usac->components(), params, arena);
        usac->components().start(context);
        const Model model = toInternal(usac->points(), given);
        before = after = context.rate(model);
        started(createSharedPoints(), context.points)->discount(context, model, after);
    }

    Quality before, after;
};

//! Exact points in front of and behind the second camera, some of them near its center. Returns E.
Matx33d pointsAroundACamera(RNG& rng, std::vector<Point2d>& points1, std::vector<Point2d>& points2)
{
    Matx33d R;
    Rodrigues(gaussianVector(rng, 1), R);
    const Vec3d t = uniformVector(rng, 0., 10.);
    for (int i = 0; i < 16; ++i)
    {
        const Vec3d X = uniformVector(rng, Vec3d(0, 0, 10), Vec3d(10, 10, 20)), Y = R * X + t;
        points1.push_back(Point2d(X[0] / X[2], X[1] / X[2]));
        points2.push_back(Point2d(Y[0] / Y[2], Y[1] / Y[2]));
    }
    return Matx33d(0, -t[2], t[1], t[2], 0, -t[0], -t[1], t[0], 0) * R;
}

/** Points near a camera that are close together in one image can be far apart in the other. Their
matches must nevertheless count in full, because they constrain the epipolar geometry: if a point is
shifted by a few thresholds in one image, its epipolar line does not move across the whole other
image. */
TEST(Usac_SharedPoints_Models, strongPerspectiveCounts)
{
    Scene scene;
    scene.problem = ESSENTIAL;
    scene.K = Matx33d::eye();
    for (int seed = 1; seed <= 100; ++seed)
    {
        RNG rng(seed);
        std::vector<Point2d> points1, points2;
        const Matx33d E = pointsAroundACamera(rng, points1, points2);
        const Checked checked(scene, points1, points2, E, 1e-4);
        EXPECT_EQ(16, checked.before.inliers) << "seed " << seed;
        EXPECT_EQ(checked.before.cost, checked.after.cost) << "seed " << seed;
    }
}

//! Half of the matches share a point of an image, the target. An F whose epipole is the target has
//! all these matches as inliers. Together, they must count as about one inlier.
TEST(Usac_SharedPoints_Models, targetsCountOnce)
{
    RNG rng(5);
    for (int image = 0; image < 2; ++image)
    {
        const Point2d target(320, 200);
        const Matx33d cross(0, -1, target.y, 1, 0, -target.x, -target.y, target.x, 0);
        const double angle = rng.uniform(0., 6.);
        const Matx33d F = cross * Matx33d(std::cos(angle), std::sin(angle), 100, -std::sin(angle),
                                          std::cos(angle), 50, 0, 0, 1);
        std::vector<Point2d> some, others;
        for (int i = 0; i < 300; ++i)
        {
            some.push_back(uniformPoint(rng, 0., 640., 0., 480.));
            others.push_back(i % 2 ? uniformPoint(rng, 0., 640., 0., 480.)
                                   : target + gaussianPoint(rng, 0.3));
        }
        SceneOptions options;
        const Scene scene = makeScene(FUNDAMENTAL, options);
        const Checked checked = image == 0 ? Checked(scene, some, others, F)
                                           : Checked(scene, others, some, F.t());
        EXPECT_GE(checked.before.inliers, 145);
        EXPECT_LE(checked.after.inliers, checked.before.inliers - 140);
        EXPECT_GE(checked.after.inliers, 1);
        EXPECT_GT(checked.after.cost, checked.before.cost + 120);
        EXPECT_LE(checked.after.cost, 300);
    }
}

//! Correct models must lose at most two inliers: with each motion, with epipoles among the points,
//! with an image 2 that is four times as large (F only), and with points one pixel apart.
TEST_P(Usac_SharedPoints, rightModelsCountInFull)
{
    for (int motion = MOTION_GENERAL; motion <= MOTION_CAR; ++motion)
        for (int kind = 0; kind < 3; ++kind)
        {
            SceneOptions options;
            options.motion = (Motion)motion;
            options.noise = 0.4;
            options.seed = 3 + motion;
            const Scene scene = makeScene((ProblemType)GetParam(), options);
            std::vector<Point2d> points1 = scene.points1, points2 = scene.points2;
            Matx33d model = scene.model;
            if (kind == 1 && scene.problem == FUNDAMENTAL)  // image 2 is four times as large
            {
                for (size_t i = 0; i < points2.size(); ++i)
                    points2[i] *= 4;
                model = Matx33d(0.25, 0, 0, 0, 0.25, 0, 0, 0, 1) * model;
            }
            if (kind == 2)  // two more matches near each match, up to one pixel away in x and in y
                for (int i = scene.size(); i < 3 * scene.size(); ++i)
                {
                    const Point2d shift(i % 3 - 1, i / 3 % 3 - 1);
                    points1.push_back(scene.points1[i % scene.size()] + shift);
                    points2.push_back(scene.points2[i % scene.size()] + shift);
                }
            const Checked checked(scene, points1, points2, model);
            SCOPED_TRACE(cv::format("motion %d, kind %d", motion, kind));
            EXPECT_GE(checked.before.inliers, 150);
            EXPECT_GE(checked.after.inliers, checked.before.inliers - 2);
            EXPECT_LE(checked.after.cost, checked.before.cost + 2);
        }
}

//! A check that drops each new best model or, if `kept` is 1, makes the cost of this model so high
//! that every other model is better. In both cases, the search must go on and pass later models to
//! the check.
class DropsEach : public Degeneracy
{
public:
    explicit DropsEach(int kept_) : kept(kept_), seen(0) {}

    bool recover(const Context&, State&, const int* sample, Model&, Quality& quality) CV_OVERRIDE
    {
        seen += sample != 0;
        if (kept)
            quality.cost += 1000;
        return kept != 0;
    }

    const int kept;
    int seen;
};

TEST_P(Usac_SharedPoints, modelsThatAreRefusedDoNotStandInTheWay)
{
    for (int kept = 0; kept < 2; ++kept)
    {
        Params params;
        params.termination = 0;
        params.runnersUp = 0;
        params.maxIterations = 200;
        const Ptr<Usac> usac = createUsac(makeScene((ProblemType)GetParam()), params);
        const Ptr<DropsEach> dropping = makePtr<DropsEach>(kept);
        usac->components().degeneracies.assign(1, dropping);
        usac->components().verifier.release();
        EXPECT_EQ(kept == 0, usac->run().empty());
        EXPECT_GT(dropping->seen, 20);
    }
}

}  // namespace
}  // namespace opencv_test
