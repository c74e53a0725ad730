// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "polishing/polishing.hpp"
#include "polishing/restarts.hpp"
#include "support/counted_solver.hpp"
#include "support/run_context.hpp"

namespace opencv_test {
namespace {

/** Matches of an H whose horizon lies between the points, and Restarts applied to the worst model
to which least squares leads from samples. The threshold is so wide that all points are inliers of
all these models. `check` replaces the degeneracy checks. */
struct Restarted
{
    Restarted(int count, int seed, const Ptr<Degeneracy>& check = Ptr<Degeneracy>())
    {
        RNG rng(seed);
        std::vector<Point2d> points1, points2;
        while ((int)points1.size() < count)
        {
            const Point2d p = uniformPoint(rng, -1., 1.);
            const double w = 1 + 2 * p.x;
            if (std::abs(w) < 0.05)
                continue;
            points1.push_back(p);
            points2.push_back(p * (1 / w) + gaussianPoint(rng, 1e-4));
        }
        Params params;
        params.threshold = 30;
        const Ptr<Usac> usac = Usac::create(HOMOGRAPHY, points1, points2, params);
        if (check)
            usac->components().degeneracies.assign(1, check);
        const Correspondences& points = usac->points();
        const RunContext run(points, usac->components(), params);
        std::vector<int> all(count);
        for (int i = 0; i < count; ++i)
            all[i] = i;
        Model model;
        before = 0;
        best = DBL_MAX;
        for (int i = 0; i < 50; ++i)
        {
            int sample[4];
            Model models[MAX_MODELS];
            Rng(seed, i).distinct(count, 4, sample);
            if (!usac->components().minimalSolver->solve(points, sample, models) ||
                !usac->components().nonMinimalSolver->fit(points, all.data(), count, 0, models[0],
                                                          20))
                continue;
            const double error = errorOf(*usac, models[0]);
            best = std::min(best, error);
            if (error > before)
            {
                before = error;
                model = models[0];
            }
        }
        Restarts(run, *createBiweightPolisher()).improve(model);
        after = errorOf(*usac, model);
    }

    double before, best, after;  //!< root mean square errors; `best` is that of the best model

private:
    static double errorOf(Usac& usac, const Model& model)
    {
        const Correspondences& points = usac.points();
        std::vector<double> errors(points.size);
        usac.components().residual->squaredErrors(model, points.exact, points.size, errors.data());
        return std::sqrt(cv::sum(errors)[0] / points.size);
    }
};

TEST(Usac_Restarts, theBestMinimumIsFound)
{
    int wrong = 0;
    for (int seed = 1; seed <= 20; ++seed)
    {
        const Restarted result(10, seed);
        wrong += result.before > 2 * result.best;
        EXPECT_LE(result.after, 1.1 * result.best) << "seed " << seed;
    }
    EXPECT_GE(wrong, 5) << "scenes with a wrong minimum";
}

//! A degeneracy check that accepts or rejects every model.
class Distrust : public Degeneracy
{
public:
    explicit Distrust(bool rejects_) : rejects(rejects_), asked(0) {}
    bool recover(const Context&, State&, const int*, Model&, Quality&) CV_OVERRIDE
    {
        ++asked;
        return !rejects;
    }

    const bool rejects;
    int asked;
};

//! A better fit replaces the model only if the check accepts it.
TEST(Usac_Restarts, rejectedModelsAreNotTaken)
{
    for (bool rejects : {false, true})
    {
        int changed = 0, asked = 0;
        for (int seed = 1; seed <= 10; ++seed)
        {
            const Ptr<Distrust> check = makePtr<Distrust>(rejects);
            const Restarted result(10, seed, check);
            changed += result.after != result.before;
            asked += check->asked;
        }
        EXPECT_GT(asked, 0);
        EXPECT_EQ(rejects, changed == 0);
    }
}

//! With more than 30 inliers, nothing is done.
TEST(Usac_Restarts, manyInliersStay)
{
    for (int seed = 1; seed <= 10; ++seed)
    {
        const Restarted result(31, seed);
        EXPECT_EQ(result.before, result.after);
    }
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
        Model model = toInternal(usac->points(), scene.model);
        Restarts(context, *createBiweightPolisher()).improve(model);
        fits += solver->longFits;
    }
    EXPECT_GE(fits, SCENES) << "the inliers are fitted from the model";
    EXPECT_LE(fits, 12 * SCENES) << "21 if no fit ends early; 5 of them start from the model";
}

}
}  // namespace
