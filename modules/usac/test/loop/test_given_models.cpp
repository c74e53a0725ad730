// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

// Tests of Usac::fit and Usac::refine where points or solvers do not determine a model.

namespace opencv_test {
namespace {

//! A least-squares solver that replaces the built-in one. It fails for the model from which its
//! first call starts, also in later calls, and leaves any other model unchanged.
class RefusesTheFirst : public NonMinimalSolver
{
public:
    bool fit(const Correspondences&, const int*, int, const double*, Model& model,
             int) const CV_OVERRIDE
    {
        if (refused.size() == 0)
            refused = model;
        return model != refused;
    }

    mutable Model refused;
};

//! Usac::fit starts from the models of several samples, best first. If the least-squares solver
//! fails for the best of these models, this model must not be the result, although its errors are
//! the smallest ones. The result must be one of the others.
TEST(Usac_GivenModels, fitOfAnotherSampleReplacesAFitThatFails)
{
    const Scene scene = makeScene(TRANSLATION_2D, 50, 0);
    const Ptr<Usac> usac = createUsac(scene, Params());
    const Ptr<RefusesTheFirst> solver = makePtr<RefusesTheFirst>();
    usac->components().nonMinimalSolver = solver;
    Report report;
    const Mat fitted = usac->fit(noArray(), noArray(), noArray(), &report);
    ASSERT_FALSE(fitted.empty());
    EXPECT_EQ((int)STOP_NO_SEARCH, report.stop);
    EXPECT_LE(modelError(scene, fitted), 1);
    Model refused;
    ASSERT_TRUE(usac->points().problem->toInput(solver->refused, usac->points(), refused));
    EXPECT_GT(cvtest::norm(squareModel(fitted) - Matx33d(refused), NORM_INF), 1e-6);
}

//! With one point fewer than a minimal sample, Usac::refine must return no model, even if the
//! caller gives a good one. With a minimal sample of points, it must return a model.
TEST(Usac_GivenModels, refineNeedsAMinimalSample)
{
    for (ProblemType problem : {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL, AFFINITY, SIMILARITY})
    {
        const Scene scene = makeScene(problem, 50, 0);
        const Ptr<Usac> usac = createUsac(scene, Params());
        const Mat fitted = usac->fit();
        const int m = usac->components().minimalSolver->sampleSize();
        for (int count : {m - 1, m})
        {
            std::vector<int> chosen(scene.size(), 0);
            std::fill(chosen.begin(), chosen.begin() + count, 1);
            Mat mask;
            Report report;
            const Mat refined = usac->refine(fitted, chosen, mask, &report);
            EXPECT_EQ((int)(count < m ? STOP_TOO_FEW_POINTS : STOP_NO_SEARCH), report.stop) << m;
            EXPECT_EQ(count < m, refined.empty()) << m;
            EXPECT_EQ(count < m, countNonZero(mask) == 0) << m;
        }
    }
}

//! The linear part of the map is about 1e-340, which is 0 in double precision. The fit succeeds in
//! normalized coordinates, but it must return no model.
TEST(Usac_GivenModels, mapThatIsTooSmallForDoubleIsNoModel)
{
    for (ProblemType problem : {AFFINITY, SIMILARITY})
    {
        Scene scene = makeScene(problem, 50, 0);
        for (int i = 0; i < scene.size(); ++i)
        {
            scene.points1[i] *= 1e170;
            scene.points2[i] *= 1e-170;
        }
        Params params;
        params.threshold = 1.5e-170;
        Mat mask;
        Report report;
        EXPECT_TRUE(createUsac(scene, params)->fit(noArray(), noArray(), mask, &report).empty());
        EXPECT_EQ((int)STOP_NO_MODEL, report.stop);
        EXPECT_EQ(scene.size(), mask.rows);
        EXPECT_EQ(0, countNonZero(mask));
        EXPECT_EQ(0, report.inliers);
    }
}

}  // namespace
}  // namespace opencv_test
