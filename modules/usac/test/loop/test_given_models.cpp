// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/absolute_pose/pose_scenes.hpp"

// Tests of Usac::fit, Usac::refine and Usac::errors: points or solvers that do not determine a
// model, the threshold and the cost that are reported, lenses, and replaced components. Also tests
// that a report without a model has neither noise nor cost.

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

//! A least-squares solver that always fails.
class Refuses : public NonMinimalSolver
{
public:
    bool fit(const Correspondences&, const int*, int, const double*, Model&, int) const CV_OVERRIDE
    {
        return false;
    }
};

//! If the least-squares solver fails, as many points as in a minimal sample still determine the
//! model: the result must be that of the minimal solver, not the model that the caller has given.
TEST(Usac_GivenModels, minimalSampleWithoutAFit)
{
    for (ProblemType problem : {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL, AFFINITY, SIMILARITY})
    {
        const Scene scene = makeScene(problem, 50, 0), other = makeScene(problem, 50, 0, 2);
        const Ptr<Usac> usac = createUsac(scene, Params());
        const Mat given = createUsac(other, Params())->fit();
        usac->components().nonMinimalSolver = makePtr<Refuses>();
        const int m = usac->components().minimalSolver->sampleSize();
        std::vector<int> chosen(scene.size(), 0);
        std::fill(chosen.begin(), chosen.begin() + m, 1);
        const Mat refined = usac->refine(given, chosen);
        ASSERT_FALSE(refined.empty()) << (int)problem;
        const Mat errors = usac->errors(refined);
        for (int i = 0; i < m; ++i)
            EXPECT_LT(errors.at<double>(i), 1e-4) << (int)problem;
    }
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

//! With #QUALITY_LMEDS, Params::threshold has no meaning: Usac::refine must polish with the
//! threshold of its mask, also if Params::threshold is much smaller than the noise.
TEST(Usac_GivenModels, refineWithLmedsUsesItsOwnThreshold)
{
    SceneOptions options;
    options.noise = 5;
    options.outliers = 40;
    const Scene scene = makeScene(HOMOGRAPHY, options);
    Params params = Params::lmeds();
    params.threshold = 0.5;
    params.covariance = true;
    const Ptr<Usac> usac = createUsac(scene, params);
    Report found, refined;
    const Mat model = usac->run(noArray(), &found);
    usac->refine(model, noArray(), noArray(), &refined);
    EXPECT_GT(refined.threshold, 10);
    EXPECT_GT(found.sigma, 3);
    EXPECT_NEAR(found.sigma, refined.sigma, 0.2 * found.sigma);
}

//! A scene seen through a distorting lens, and an estimator of the camera's pose.
struct Distorted
{
    explicit Distorted(const Params& params)
    {
        PoseSceneOptions options;
        options.coefficients = 5;
        options.inlierRatio = 0.7;
        scene = makePoseScene(options);
        usac = Usac::create(ABSOLUTE_POSE, scene.object, scene.image, params, scene.K, noArray(),
                            scene.distortion);
    }

    PoseScene scene;
    Ptr<Usac> usac;
};

//! Usac::refine must report about the cost (within 2 %) that Usac::run reports for the same model,
//! although the lens makes the errors of the search differ from those of the mask.
TEST(Usac_GivenModels, costIsThatOfTheMask)
{
    for (const Params& preset : {Params(), Params::automatic()})
    {
        Params params = preset;
        params.threshold = preset.thresholdType == THRESHOLD_GIVEN ? 1.5 : 12;
        const Distorted distorted(params);
        Report found, refined;
        const Mat pose = distorted.usac->run(noArray(), &found);
        distorted.usac->refine(pose, noArray(), noArray(), &refined);
        EXPECT_NEAR(found.threshold, refined.threshold, 0.02 * found.threshold);
        EXPECT_NEAR(found.inliers, refined.inliers, 2);
        EXPECT_NEAR(found.cost, refined.cost, 0.02 * found.cost);
    }
}

//! A solver of the caller does not support the original image points: it must nevertheless be used
//! in place of the built-in one, with the points of the search.
TEST(Usac_GivenModels, replacedSolverIsUsedWithALens)
{
    const Distorted distorted((Params()));
    const Mat pose = distorted.usac->run();
    const Ptr<RefusesTheFirst> solver = makePtr<RefusesTheFirst>();
    distorted.usac->components().nonMinimalSolver = solver;
    const std::vector<int> all(distorted.scene.truth.size(), 1);
    EXPECT_TRUE(distorted.usac->refine(pose, all).empty());
    EXPECT_GT(solver->refused.size(), 0);
}

//! If the first residual is put back after another one, the result must be that of the first run:
//! here with a lens, once without sigmas and once with a sigma for each match.
TEST(Usac_GivenModels, residualPutBackWithALens)
{
    for (int numbers : {0, 1})
    {
        Params params;
        params.sigmas.assign(numbers * Distorted((Params())).scene.truth.size(), 1.f);
        for (size_t i = 0; i < params.sigmas.size(); i += 2)
            params.sigmas[i] = 2;
        const Distorted distorted(params);
        Usac& usac = *distorted.usac;
        const Mat first = usac.run();
        const Ptr<Residual> original = usac.components().residual;
        usac.components().residual = usac.points().problem->createResidual(RESIDUAL_STANDARD);
        usac.run();
        usac.components().residual = original;
        EXPECT_EQ(0, cvtest::norm(first, usac.run(), NORM_INF)) << numbers;
    }
}

//! If the model is rejected, the report must not contain its noise or its cost.
TEST(Usac_GivenModels, rejectedModelsLeaveNothing)
{
    int rejected = 0;
    for (uint64 seed = 1; seed <= 20; ++seed)
    {
        SceneOptions options;
        options.inliers = 0;
        options.outliers = 100;
        options.seed = seed;
        const Scene scene = makeScene(HOMOGRAPHY, options);
        Params params = Params::automatic();
        params.threshold = 5;
        Report report;
        const Mat model = createUsac(scene, params)->run(noArray(), &report);
        if (!model.empty())
            continue;
        rejected += report.stop == STOP_NOT_SIGNIFICANT;
        EXPECT_EQ(0, report.sigma);
        EXPECT_EQ(0, report.cost);
        EXPECT_EQ(0, report.priorChance);
    }
    EXPECT_GE(rejected, 10);
}

//! If the chosen points are a degenerate minimal sample (collinear points), Usac::refine must
//! return no model, although the model from which it begins is valid.
TEST(Usac_GivenModels, refineOfADegenerateSample)
{
    const Scene scene = makeScene(AFFINITY, 50, 0);
    std::vector<Point2d> points1 = scene.points1;
    points1[1] = points1[0] + (points1[2] - points1[0]) * 0.5;
    const Ptr<Usac> usac = Usac::create(AFFINITY, points1, scene.points2, Params());
    const Mat model = usac->run();
    ASSERT_FALSE(model.empty());
    std::vector<int> chosen(scene.size(), 0);
    std::fill(chosen.begin(), chosen.begin() + 3, 1);
    Report report;
    EXPECT_TRUE(usac->refine(model, chosen, noArray(), &report).empty());
    EXPECT_EQ((int)STOP_NO_MODEL, report.stop);
}

//! Usac::errors needs no solver.
TEST(Usac_GivenModels, errorsWithoutASolver)
{
    const Scene scene = makeScene(HOMOGRAPHY, 50, 0);
    const Ptr<Usac> usac = createUsac(scene, Params());
    const Mat before = usac->errors(Mat(scene.model));
    usac->components().nonMinimalSolver.release();
    EXPECT_EQ(0, cvtest::norm(before, usac->errors(Mat(scene.model)), NORM_INF));
}

//! A residual that keeps data of the points, as start() allows.
class StartedResidual : public Residual
{
public:
    explicit StartedResidual(const Ptr<Residual>& inner_) : size(0), inner(inner_) {}

    void start(const Context& context) CV_OVERRIDE { size = context.points.size; }
    void squaredErrors(const Correspondences& p, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        inner->squaredErrors(p, model, begin, end, errors);
    }
    void squaredErrors(const Model& model, const double* const* columns, int count,
                       double* errors) const CV_OVERRIDE
    {
        inner->squaredErrors(model, columns, count, errors);
    }

    int size;

private:
    const Ptr<Residual> inner;
};

//! Usac::errors must start a replaced residual, even if there was no run yet, and again if the
//! points have been replaced.
TEST(Usac_GivenModels, errorsStartTheResidual)
{
    const Scene scene = makeScene(HOMOGRAPHY, 50, 0), larger = makeScene(HOMOGRAPHY, 70, 0);
    const Ptr<Usac> usac = createUsac(scene, Params());
    const Ptr<StartedResidual> residual = makePtr<StartedResidual>(usac->components().residual);
    usac->components().residual = residual;
    usac->errors(Mat(scene.model));
    EXPECT_EQ(50, residual->size);
    usac->setPoints(larger.points1, larger.points2);
    usac->errors(Mat(scene.model));
    EXPECT_EQ(70, residual->size);
}

//! A run uses a frequent match once, but a fit must use each of its repetitions. The least-squares
//! translation is the mean of all shifts.
TEST(Usac_GivenModels, fitCountsRepetitions)
{
    std::vector<Point2d> points1(10, Point2d(5, 7)), points2 = points1;
    for (int i = 0; i < 10; ++i)
    {
        points1.push_back(Point2d(20 * i, i * i));
        points2.push_back(points1.back() + Point2d(1, 0));
    }
    const Ptr<Usac> usac = Usac::create(TRANSLATION_2D, points1, points2, Params());
    EXPECT_NEAR(0.5, usac->fit().at<double>(0, 2), 1e-9);
    usac->run();
    EXPECT_NEAR(0.5, usac->fit().at<double>(0, 2), 1e-9);
}

}  // namespace
}  // namespace opencv_test
