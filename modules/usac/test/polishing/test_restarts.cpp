// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "polishing/restarts.hpp"
#include "support/counted_solver.hpp"
#include "support/run_context.hpp"

namespace opencv_test {
namespace {

//! Makes `right` matches of a translation, followed by `wrong` random matches. In image 1 the first
//! point is far from the others, which lie in a narrow strip.
void stripAndOne(int right, int wrong, double noise, RNG& rng, std::vector<Point2d>& points1,
                 std::vector<Point2d>& points2)
{
    points1.clear();
    points2.clear();
    for (int i = 0; i < right + wrong; ++i)
    {
        points1.push_back(i ? uniformPoint(rng, 220., 225., 260., 315.) : Point2d(280, 240));
        points2.push_back(i < right ? points1[i] - Point2d(96, 96) + gaussianPoint(rng, noise)
                                    : uniformPoint(rng, 0., 370., 0., 490.));
    }
}

//! Fits a model by least squares to the rows `first` to `end` - 1 of the given matches, and applies
//! Restarts to it: fits from other starting points to the inliers, and to the inliers and a single
//! outlier. `check` is a degeneracy check in addition to the default ones.
struct Restarted
{
    Restarted(const std::vector<Point2d>& points1, const std::vector<Point2d>& points2,
              double threshold, int first, int end,
              const Ptr<Degeneracy>& check = Ptr<Degeneracy>())
    {
        Params params;
        params.threshold = threshold;
        const Ptr<Usac> usac = Usac::create(HOMOGRAPHY, points1, points2, params);
        if (check)
            usac->components().degeneracies.push_back(check);
        const Correspondences& points = usac->points();
        const RunContext run(points, usac->components(), params);
        const Context& context = run;
        std::vector<int> rows;
        for (int i = 0; i < points.size; ++i)
        {
            if (points.inputIndex[i] >= first && points.inputIndex[i] < end)
                rows.push_back(i);
            if (points.inputIndex[i] == 0)
                far = i;
        }
        const double shift[] = {1, 0, -96, 0, 1, -96, 0, 0, 1};
        Model model;
        EXPECT_TRUE(
            points.problem->fromOutput(std::vector<double>(shift, shift + 9), points, model));
        EXPECT_TRUE(
            context.nonMinimalSolver().fit(points, rows.data(), (int)rows.size(), 0, model, 20));
        before = after = context.rate(model);
        std::vector<double> errors(points.size);
        usac->components().residual->squaredErrors(model, points.exact, points.size, errors.data());
        farBefore = std::sqrt(errors[far]) / points.threshold;
        State state;
        Restarts(context, context, state).improve(model, after);
        degenerate = state.degenerate;
        EXPECT_EQ(context.rate(model).inliers, after.inliers);
    }

    Quality before, after;
    int far;           //!< index of the match that is far from the others
    double farBefore;  //!< error of this match before the restarts, in thresholds
    bool degenerate;   //!< State::degenerate after the restarts
};

//! In some scenes, the error of the far match under the model of the nine matches in the strip is
//! more than ten thresholds, although another model has all ten matches as inliers. Restarts must
//! find such a model in every scene.
TEST(Usac_Restarts, anInlierThatIsFarAwayIsFound)
{
    double most = 0;
    for (int seed = 1; seed <= 20; ++seed)
    {
        RNG rng(seed);
        std::vector<Point2d> points1, points2;
        stripAndOne(10, 19, 2e-3, rng, points1, points2);
        const Restarted result(points1, points2, 0.01, 1, 10);
        EXPECT_EQ(10, result.after.inliers) << "seed " << seed;
        most = std::max(most, result.farBefore);
    }
    EXPECT_GT(most, 10);
}

//! If the far match is an outlier, restarts must not make it an inlier in more than one of 40
//! scenes.
TEST(Usac_Restarts, aWrongMatchIsNot)
{
    int taken = 0;
    for (int seed = 1; seed <= 40; ++seed)
    {
        RNG rng(seed);
        std::vector<Point2d> points1, points2;
        stripAndOne(10, 19, 2e-3, rng, points1, points2);
        points2[0] += uniformPoint(rng, 20., 60.);
        taken += Restarted(points1, points2, 0.01, 1, 10).after.inliers > 9;
    }
    EXPECT_LE(taken, 1);
}

//! A degeneracy check that sets State::degenerate for every model, and rejects every model if
//! `rejects` is true.
class Distrust : public Degeneracy
{
public:
    explicit Distrust(bool rejects_) : rejects(rejects_), asked(0) {}
    bool recover(const Context&, State& state, const int*, Model&, Quality&) CV_OVERRIDE
    {
        ++asked;
        state.degenerate = true;
        return !rejects;
    }

    const bool rejects;
    int asked;
};

//! A better fit that the check rejects must not replace the model, and the changes that the check
//! made to the state of the run must be undone. A better fit that the check accepts must
//! replace the model.
TEST(Usac_Restarts, rejectedModelsAreNotTaken)
{
    for (bool rejects : {false, true})
    {
        RNG rng(1);
        std::vector<Point2d> points1, points2;
        stripAndOne(10, 19, 2e-3, rng, points1, points2);
        const Ptr<Distrust> check = makePtr<Distrust>(rejects);
        const Restarted result(points1, points2, 0.01, 1, 10, check);
        EXPECT_GT(check->asked, 0);
        EXPECT_EQ(rejects, result.before.cost == result.after.cost);
        EXPECT_EQ(rejects, result.after.inliers < 10);
        EXPECT_EQ(!rejects, result.degenerate);
    }
}

//! With more than 30 inliers, and a threshold that makes random matches inliers with a probability
//! below 0.2, Restarts does nothing, so that the cost must not change.
TEST(Usac_Restarts, manyInliersStay)
{
    RNG rng(1);
    std::vector<Point2d> points1, points2;
    stripAndOne(60, 20, 0.3, rng, points1, points2);
    const Restarted result(points1, points2, 1.5, 0, 30);
    EXPECT_EQ(result.before.cost, result.after.cost);
    EXPECT_GT(result.after.inliers, 40);
}

//! If the inliers have only one minimum, the fits from 16 samples of inliers lead to it. Most of
//! them must end after their first steps.
TEST(Usac_Restarts, endNearTheKnownMinimum)
{
    int fits = 0;
    const int SCENES = 20;
    for (uint64 seed = 1; seed <= SCENES; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.inliers = 25;
        options.outliers = 15;
        options.noise = 0.5;
        const Scene scene = makeScene(HOMOGRAPHY, options);
        const Ptr<Usac> usac = createUsac(scene, Params());
        Components parts = usac->components();
        const Ptr<CountedSolver> solver = makePtr<CountedSolver>(parts.nonMinimalSolver);
        parts.nonMinimalSolver = solver;
        const Params params;
        const RunContext run(usac->points(), parts, params);
        const Context& context = run;
        State state;
        Model model = toInternal(usac->points(), scene.model);
        Quality quality = context.rate(model);
        Restarts(context, context, state).improve(model, quality);
        fits += solver->longFits;
    }
    EXPECT_GE(fits, SCENES) << "the inliers are fitted from the model";
    EXPECT_LE(fits, 12 * SCENES) << "21 if no fit ends early; 5 of them start from the model";
}

}
}  // namespace
