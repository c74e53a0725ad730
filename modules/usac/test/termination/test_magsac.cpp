// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "termination/termination.hpp"

namespace opencv_test {
namespace {

//! A scene, the state of a run whose best model is the true one, and the number of points within a
//! fraction of the threshold.
struct Found
{
    Found(ProblemType problem, const Params& params_, const SceneOptions& options = SceneOptions())
        : params(params_), scene(makeScene(problem, options)), usac(createUsac(scene, params)),
          context(usac->points(), usac->components(), params, arena)
    {
        usac->components().start(context);
        state.best = toInternal(usac->points(), scene.model);
        state.bestQuality = context.rate(state.best);
    }

    int within(double part) const
    {
        const Correspondences& p = usac->points();
        std::vector<float> errors(p.size);
        usac->components().residual->squaredErrors(p, state.best, 0, p.size, errors.data());
        int count = 0;
        for (int i = 0; i < p.size; ++i)
            count += std::sqrt((double)errors[i]) <= part * p.threshold;
        return count;
    }

    Params params;
    Scene scene;
    Ptr<Usac> usac;
    Arena arena;
    Context context;
    State state;
};

double binomial(int n, int m)
{
    double result = 1;
    for (int i = 0; i < m; ++i)
        result *= (double)(n - i) / (m - i);
    return result;
}

typedef testing::TestWithParam<int> Usac_Magsac_Termination;

//! The number of samples must be the mean of log(1 - confidence) / log(1 - p) over five scales of
//! the noise, where p is the probability of an all-inlier sample at this scale.
TEST_P(Usac_Magsac_Termination, againstItsFormula)
{
    const ProblemType problem = (ProblemType)GetParam();
    for (int exact = 0; exact < 2; ++exact)
        for (double inlierThreshold = 3; inlierThreshold < 20; inlierThreshold *= 1.5)
        {
            Params params;
            params.threshold = inlierThreshold;
            params.confidence = 0.999;
            params.termination = TERMINATION_MAGSAC | (exact ? TERMINATION_EXACT : 0);
            const Found found(problem, params);
            const int m = found.usac->components().minimalSolver->sampleSize(),
                      n = found.scene.size();
            double sum = 0;
            for (int i = 1; i <= 5; ++i)
            {
                const int inliers = found.within(i / 5.);
                const double p = exact ? binomial(inliers, m) / binomial(n, m)
                                       : std::pow((double)inliers / n, m);
                sum += std::log(0.001) / std::log(1 - p) / 5;
            }
            const Ptr<Termination> termination = createMagsacTermination();
            EXPECT_EQ(STOP_MAGSAC, termination->reason());
            EXPECT_NEAR(sum, termination->iterations(found.context, found.state),
                        1.001 + 1e-9 * sum)
                << inlierThreshold;
            // the criterion must not end the search before the standard criterion does
            EXPECT_GE(termination->iterations(found.context, found.state),
                      createStandardTermination()->iterations(found.context, found.state));
        }
}

TEST_P(Usac_Magsac_Termination, withoutAModel)
{
    const Found found((ProblemType)GetParam(), Params());
    const Ptr<Termination> termination = createMagsacTermination();
    State state;
    EXPECT_EQ(INT_MAX, termination->iterations(found.context, state));
    state = found.state;
    state.best = Matx33d::all(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(INT_MAX, termination->iterations(found.context, state));
}

//! If all points agree exactly, one sample must be enough.
TEST_P(Usac_Magsac_Termination, allAgree)
{
    SceneOptions options;
    options.noise = 0;
    options.outliers = 0;
    const Found found((ProblemType)GetParam(), Params(), options);
    EXPECT_EQ(1, createMagsacTermination()->iterations(found.context, found.state));
}

//! The criterion must end a run, the report must say so, and the model must be correct.
TEST_P(Usac_Magsac_Termination, estimates)
{
    Params params;
    params.threshold = 8;
    params.termination = TERMINATION_MAGSAC;
    params.quality = QUALITY_MAGSAC_PLUS_PLUS;
    params.polishing = POLISHING_REWEIGHTED;
    const Scene scene = makeScene((ProblemType)GetParam());
    Report report;
    EXPECT_LT(modelError(scene, estimate(scene, params, noArray(), &report)), 0.35);
    EXPECT_EQ((int)STOP_MAGSAC, report.stop);
    EXPECT_LT(report.iterations, 1000);
    const int wide = report.iterations;
    params.threshold = 4;  // fewer inliers at the finest scale
    estimate(scene, params, noArray(), &report);
    if (sampleSizeOf(GetParam()) > 1)  // otherwise the first batch of samples is enough
    {
        EXPECT_GT(report.iterations, wide);
    }
}

INSTANTIATE_TEST_CASE_P(All, Usac_Magsac_Termination, testing::ValuesIn(TWO_VIEW_PROBLEMS));

}
}  // namespace
