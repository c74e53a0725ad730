// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/contracts.hpp"
#include "../../../../samples/affine_problem.hpp"

// Tests of a problem that is defined outside the module: the affine map of
// samples/custom_problem.cpp.

namespace opencv_test {
namespace {

const Matx23d TRUTH(0.9, 0.2, 30, -0.15, 1.1, -20);

struct AffineScene
{
    AffineScene(int inliers, int outliers, double noise)
    {
        RNG rng(7);
        for (int i = 0; i < inliers + outliers; ++i)
        {
            const Point2d p = uniformPoint(rng, 0., 640., 0., 480.);
            const Vec2d q = TRUTH * Vec3d(p.x, p.y, 1);
            const Point2d right = Point2d(q[0], q[1]) + gaussianPoint(rng, noise);
            points1.push_back(p);
            points2.push_back(i < inliers ? right : uniformPoint(rng, 0., 640., 0., 480.));
        }
    }

    Mat estimate(const Params& params, OutputArray mask = noArray(), Report* report = 0) const
    {
        return Usac::create(makePtr<custom::AffineProblem>(), points1, points2, params)
            ->run(mask, report);
    }

    //! Largest error in pixels at the four corners of the image.
    static double error(const Mat& model)
    {
        double largest = 0;
        for (int corner = 0; corner < 4; ++corner)
        {
            const Vec3d x(corner % 2 * 640, corner / 2 * 480, 1);
            const Vec2d difference = Matx23d(model.ptr<double>()) * x - TRUTH * x;
            largest = std::max(largest, std::hypot(difference[0], difference[1]));
        }
        return largest;
    }

    std::vector<Point2d> points1, points2;
};

//! Every preset except LMedS must find the affine map of a scene in which half of the matches are
//! wrong. The presets differ in sampler, score, verification, local optimization, termination and
//! polishing.
TEST(Usac_CustomProblem, everyPreset)
{
    const AffineScene scene(200, 200, 0.5);
    const std::vector<NamedPreset> presets = allPresets();
    for (size_t p = 0; p < presets.size(); ++p)
    {
        Params params = presets[p].params;
        params.threshold = 2;
        params.maxIterations = 5000;
        if (params.quality == QUALITY_LMEDS)
            continue;  // half of the points are outliers, too many for LMedS
        Mat mask;
        Report report;
        const Mat A = scene.estimate(params, mask, &report);
        ASSERT_FALSE(A.empty()) << presets[p].name;
        EXPECT_LE(AffineScene::error(A), 0.6) << presets[p].name;
        EXPECT_EQ(Size(3, 2), A.size());
        EXPECT_GE(report.inliers, 190) << presets[p].name;
        EXPECT_EQ(report.inliers, countNonZero(mask));
    }
}

//! The problem has no parameterization, so that the module cannot compute the covariance of a
//! model, but it converts initial models (fromOutput). An initial model with a covariance (a prior)
//! must then have the same effect as one without.
class StartedAffineProblem : public custom::AffineProblem
{
public:
    bool fromOutput(const std::vector<double>& output, const Correspondences& points,
                    Model& model) const CV_OVERRIDE
    {
        Matx33d A = Matx33d::eye();
        std::copy(output.begin(), output.end(), A.val);
        A = points.frame[1].matrix() * A * points.frame[0].matrix().inv();
        model = Matx23d(A.val);
        return true;
    }
};

TEST(Usac_CustomProblem, priorWithoutACovarianceOfThePoints)
{
    const AffineScene scene(100, 50, 0.5);
    Params params;
    params.threshold = 2;
    params.setInitialModel(TRUTH);
    Report report;
    const Ptr<Problem> problem = makePtr<StartedAffineProblem>();
    const Mat expected = Usac::create(problem, scene.points1, scene.points2, params)
                             ->run(noArray(), &report);
    params.setInitialModel(TRUTH, Mat::eye(6, 6, CV_64F));
    EXPECT_EQ(0, cv::norm(expected, Usac::create(problem, scene.points1, scene.points2, params)
                                        ->run(noArray(), &report)));
    EXPECT_EQ(0, report.priorChance);
}

//! A problem with one of six mistakes, for example a wrong dimension. Usac::create() must raise an
//! exception that names the problem. `mistake` 6 means none.
class WrongProblem : public custom::AffineProblem
{
public:
    explicit WrongProblem(int mistake_) : mistake(mistake_) {}
    int dimension() const CV_OVERRIDE { return mistake == 0 ? 7 : 6; }
    int errorDimension() const CV_OVERRIDE { return mistake == 1 ? 3 : 2; }
    SampleCost sampleCost() const CV_OVERRIDE { return SampleCost(mistake == 2 ? 0 : 100, 1); }
    int coordinates(int array) const CV_OVERRIDE
    {
        return mistake == 4 ? 4 : mistake == 5 && array == 1 ? 1 : 2;
    }
    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE
    {
        return mistake == 3 ? Ptr<MinimalSolver>() : AffineProblem::createMinimalSolver();
    }

private:
    const int mistake;
};

TEST(Usac_CustomProblem, mistakesAreNamed)
{
    const AffineScene scene(20, 0, 0.5);
    for (int mistake = 0; mistake <= 6; ++mistake)
    {
        std::string message;
        try
        {
            Usac::create(makePtr<WrongProblem>(mistake), scene.points1, scene.points2,
                         Params::magsac());
        }
        catch (const cv::Exception& e)
        {
            message = e.err;
        }
        EXPECT_EQ(mistake < 6, message.find("problem affine:") == 0) << mistake << " " << message;
    }
}

//! A problem without a least-squares solver: the default of createNonMinimalSolver() makes one only
//! from a parameterization, which this problem does not have either.
class UnfittedAffineProblem : public custom::AffineProblem
{
public:
    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>& residual) const CV_OVERRIDE
    {
        return Problem::createNonMinimalSolver(residual);
    }
};

TEST(Usac_CustomProblem, fitsAreOptional)
{
    const AffineScene scene(100, 50, 0.5);
    Params params = Params::ransac();
    params.threshold = 2;
    params.polishing = POLISHING_NONE;
    const Ptr<Usac> usac = Usac::create(makePtr<UnfittedAffineProblem>(), scene.points1,
                                        scene.points2, params);
    EXPECT_TRUE(usac->components().nonMinimalSolver.empty());
    const Mat A = usac->run();
    ASSERT_EQ(Size(3, 2), A.size());
    EXPECT_EQ(0, cv::norm(A, scene.estimate(params), NORM_INF));
    expectException([&]() { usac->fit(); }, "nonMinimalSolver");
}

//! The problem has no fromOutput(), so that it cannot convert a model that the caller gives. The
//! exception that such a model raises must name the problem.
TEST(Usac_CustomProblem, modelsOfTheCallerAreRefused)
{
    const AffineScene scene(100, 50, 0.5);
    Params params;
    const Ptr<Usac> usac = Usac::create(makePtr<custom::AffineProblem>(), scene.points1,
                                        scene.points2, params);
    expectException([&]() { usac->errors(TRUTH); },
                    "model: the 2 x 3 numbers are not a model of the problem affine");
    expectException([&]() { usac->refine(TRUTH); },
                    "model: the 2 x 3 numbers are not a model of the problem affine");
    params.setInitialModel(TRUTH);
    expectException([&]() { scene.estimate(params); },
                    "initialModel: the 6 numbers are not a model of the problem affine");
}

//! The problem has a residual for the original image points (createImageResidual), but does not
//! override toImageCoordinates(). The residual is that of the search, so that the results must be
//! the same as without createImageResidual().
class SeenAffineProblem : public custom::AffineProblem
{
public:
    Ptr<Residual> createImageResidual(const Ptr<Residual>& residual) const CV_OVERRIDE
    {
        return residual;
    }
};

TEST(Usac_CustomProblem, pointsOfTheCallerAreUnchanged)
{
    const AffineScene scene(100, 50, 0.5);
    Params params;
    params.threshold = 2;
    Mat mask, seenMask;
    const Mat expected = scene.estimate(params, mask),
              seen = Usac::create(makePtr<SeenAffineProblem>(), scene.points1, scene.points2,
                                  params)
                         ->run(seenMask);
    ASSERT_EQ(expected.size(), seen.size());
    EXPECT_LT(cv::norm(expected, seen, NORM_INF), 1e-9);
    EXPECT_EQ(0, cv::norm(mask, seenMask, NORM_INF));
}

}  // namespace
}  // namespace opencv_test
