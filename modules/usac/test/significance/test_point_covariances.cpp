// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "significance/directed_noise.hpp"
#include "problems/kernels.hpp"

// Tests of covariances of points, given as Params::sigmas.

namespace opencv_test {
namespace {

//! The test parameters: the problem, and whether there is noise in both images.
typedef testing::TestWithParam<testing::tuple<ProblemType, bool>> Usac_PointCovariances;
INSTANTIATE_TEST_CASE_P(/**/, Usac_PointCovariances,
                        testing::Combine(testing::Values(HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL,
                                                         AFFINITY, SIMILARITY, ABSOLUTE_POSE),
                                         testing::Bool()));

/** A model estimated with the covariances of the points must be closer to the true model than one
estimated without them (with a threshold of 4 pixels). Its squared Mahalanobis distance from the
true model must on average be the number of parameters, and the estimated noise must be 1 in units
of the standard deviations of the errors. */
TEST_P(Usac_PointCovariances, accuracy)
{
    const ProblemType problem = testing::get<0>(GetParam());
    const int scenes = 60;
    double with = 0, without = 0, square = 0, noise = 0;
    for (int seed = 1; seed <= scenes; ++seed)
    {
        const Directed directed(problem, seed, testing::get<1>(GetParam()));
        Params params;
        params.covariance = 1;
        Report report;
        const Mat model = directed.create(params, 3, true)->run(noArray(), &report);
        ASSERT_FALSE(model.empty()) << seed;
        ASSERT_FALSE(isNaN(report.covariance)) << seed;
        const Mat equal = directed.create(params, 20 * SMALL_NOISE, false)->run();
        ASSERT_FALSE(equal.empty()) << seed;
        square += squaredDistance(directed.scene, model, report.covariance) /
                  report.covariance.rows;
        with += squaredDistance(directed.scene, model, report.covariance, model);
        without += squaredDistance(directed.scene, equal, report.covariance, model);
        noise += report.sigma;
    }
    EXPECT_NEAR(1, square / scenes, 0.25);
    EXPECT_NEAR(1, noise / scenes, 0.05);
    EXPECT_GE(std::sqrt(without / with), 1.3);  // measured: F, E: 1.4 to 2.0; others: 2.5 to 4.5
}

//! Usac::fit and Usac::refine must minimize the errors in units of their standard deviations, as
//! Usac::errors returns them. Equal weights of all matches must have no effect.
TEST_P(Usac_PointCovariances, fits)
{
    const Directed directed(testing::get<0>(GetParam()), 3, testing::get<1>(GetParam()));
    const Ptr<Usac> usac = directed.create(Params(), 3, true);
    const Mat chosen = usac->errors(directed.scene.truth) <= 4.5;
    const auto cost = [&](const Mat& model) {
        Mat errors = usac->errors(model);
        errors.setTo(0, chosen == 0);
        return errors.dot(errors);
    };
    const Mat fitted = usac->fit(noArray(), chosen),
              refined = usac->refine(directed.scene.truth, chosen);
    ASSERT_FALSE(fitted.empty());
    ASSERT_FALSE(refined.empty());
    EXPECT_LT(cost(fitted), cost(directed.scene.truth));
    EXPECT_NEAR(cost(fitted), cost(refined), 1e-6 * cost(fitted));
    Mat weights(chosen.rows, 1, CV_64F, Scalar(7));
    EXPECT_NEAR(cost(fitted), cost(usac->fit(weights, chosen)), 1e-6 * cost(fitted));
}

//! Covariances 0, 0, 0 of all points in image 1 (6 N numbers) must have the same effect as no
//! covariances in image 1 (3 N numbers).
TEST(Usac_PointCovariances_, exactPointsInImage1)
{
    for (ProblemType problem : {HOMOGRAPHY, FUNDAMENTAL})
    {
        Directed directed(problem, 2, false);
        const Mat model = directed.create(Params(), 3, true)->run();
        std::vector<float> zeros;
        for (size_t i = 0; i < directed.sigmas.size(); ++i)
        {
            zeros.push_back(directed.sigmas[i]);
            if (i % 3 == 2)
                zeros.insert(zeros.end(), 3, 0.f);
        }
        directed.sigmas = zeros;
        const Mat same = directed.create(Params(), 3, true)->run();
        ASSERT_FALSE(model.empty());
        EXPECT_EQ(0, cv::norm(model, same)) << (int)problem;
    }
}

//! Extreme ratios of covariances must not lead to NaN or infinite values, and errors in single
//! precision must agree with those in double precision.
TEST_P(Usac_PointCovariances, extremeRatios)
{
    const Directed directed(testing::get<0>(GetParam()), 1, testing::get<1>(GetParam()));
    const int each = directed.both ? 6 : 3;
    Params params;
    params.sigmas = directed.sigmas;
    for (size_t i = 0; i < params.sigmas.size(); ++i)
        params.sigmas[i] *= (int)i / each % 2 ? 2e9f : 1e-10f;
    params.threshold = 1e6;
    const Ptr<Usac> usac = directed.create(params, 1e6, false);
    const Mat model = usac->run();
    EXPECT_FALSE(model.empty());
    EXPECT_TRUE(cv::checkRange(model));
    EXPECT_TRUE(cv::checkRange(usac->errors(directed.scene.truth)));
    const Correspondences& points = usac->points();
    Model truth;
    const Mat numbers = directed.scene.truth.clone().reshape(1, 1);
    ASSERT_TRUE(points.problem->fromOutput(std::vector<double>(numbers), points, truth));
    std::vector<float> errors(points.size);
    std::vector<double> exact(points.size);
    const Ptr<Residual> residual = usac->components().residual;
    residual->squaredErrors(points, truth, 0, points.size, errors.data());
    residual->squaredErrors(truth, points.exact, points.size, exact.data());
    for (int i = 0; i < points.size; ++i)
        EXPECT_NEAR(exact[i], errors[i], 0.02 * exact[i] + 1e-9) << i;
}

//! Checks that a call raises a cv::Exception that names `sigmas`.
template <class Call>
void expectRefused(const Call& call, const std::string& what)
{
    try
    {
        call();
        ADD_FAILURE() << what << ": no exception";
    }
    catch (const Exception& e)
    {
        EXPECT_NE(String::npos, e.msg.find("sigmas")) << what << ": " << e.msg;
    }
}

TEST(Usac_PointCovariances_, invalid)
{
    const Directed directed(HOMOGRAPHY, 1, true);
    const Mat &points1 = directed.scene.points1, &points2 = directed.scene.points2;
    const auto estimate = [&](const std::vector<float>& sigmas) {
        Params params;
        params.sigmas = sigmas;
        estimateHomography(points1, points2, params);
    };
    estimate(directed.sigmas);
    for (size_t each : {2, 4, 5, 7, 12})
        expectRefused([&] { estimate(std::vector<float>(each * points1.rows, 1.f)); },
                      std::to_string(each));
    const float wrong[][3] = {{0, 0, 1},      {1, 0, 0},     {1, 1, 1},          {1, -1.5f, 1},
                              {-1, 0, -1},    {NAN, 0, 1},   {1, NAN, 1},        {1, 0, INFINITY},
                              {9e-13f, 0, 1}, {1, 0, 2e12f}, {1, 0.99999994f, 1}};
    for (const auto& covariance : wrong)
        for (int image = 0; image < 2; ++image)
        {
            std::vector<float> sigmas = directed.sigmas;
            std::copy(covariance, covariance + 3, &sigmas[6 * 7 + 3 * image]);
            expectRefused([&] { estimate(sigmas); }, std::to_string(covariance[0]));
        }
    std::vector<float> sigmas = directed.sigmas;
    std::fill(&sigmas[6 * 7], &sigmas[6 * 7 + 3], 0.f);  // exact points are allowed in image 1 only
    expectRefused([&] { estimate(sigmas); }, "zeros");
}

TEST(Usac_PointCovariances_, otherProblems)
{
    const Directed directed(HOMOGRAPHY, 1, true);
    Params params;
    params.sigmas = directed.sigmas;
    params.residual = RESIDUAL_SYMMETRIC;
    expectRefused(
        [&] { estimateHomography(directed.scene.points1, directed.scene.points2, params); },
        "symmetric");
    for (ProblemType problem : {RIGID_3D, ABSOLUTE_POSE})
    {
        const Case scene = makeCase(problem, 1);
        Params options;
        for (int i = 0; i < scene.points1.rows; ++i)
            for (float each : {1.f, 0.f, 1.f, 1.f, 0.f, 1.f})
                options.sigmas.push_back(each);
        expectRefused(
            [&] { Usac::create(problem, scene.points1, scene.points2, options, scene.camera); },
            problem == RIGID_3D ? "rigid" : "pose");
    }
    TwoViewPair pair;
    pair.points1 = directed.scene.points1;
    pair.points2 = directed.scene.points2;
    pair.sigmas = directed.sigmas;
    expectRefused([&] { estimateTwoViewGeometry(pair); }, "two views");
}

//! The K numbers in Params::sigmas are N, 3 N or 6 N numbers for N points. setPoints() must reject
//! another number of points for which K numbers would be valid, too, but with another meaning: for
//! example K points, for which they would be standard deviations instead of covariances. The
//! estimator then has no points, as after any other invalid argument of setPoints().
TEST(Usac_PointCovariances_, otherNumbersOfPoints)
{
    const Directed directed(HOMOGRAPHY, 1, false);
    const Mat points1 = directed.scene.points1.rowRange(0, 96),
              points2 = directed.scene.points2.rowRange(0, 96);
    for (int each : {1, 3, 6})
        for (int other : {1, 3, 6})
        {
            if (each == other)
                continue;
            Params params;
            for (int i = 0; i < each * points1.rows; ++i)
                params.sigmas.push_back(i % 3 == 1 ? 0.5f : 1.f);
            const Ptr<Usac> usac = Usac::create(HOMOGRAPHY, points1, points2, params);
            const int wrong = each * points1.rows / other;
            const Mat many1 = cv::repeat(points1, 6, 1).rowRange(0, wrong),
                      many2 = cv::repeat(points2, 6, 1).rowRange(0, wrong);
            expectRefused([&] { usac->setPoints(many1, many2); }, std::to_string(wrong));
            EXPECT_EQ(0, usac->points().size);
            EXPECT_EQ(0, usac->points().inputSize);
            Report report;
            EXPECT_TRUE(usac->run(noArray(), &report).empty());
            EXPECT_EQ(STOP_TOO_FEW_POINTS, report.stop);
            EXPECT_TRUE(usac->errors(directed.scene.truth).empty());
            usac->setPoints(points1, points2);
            EXPECT_FALSE(usac->run().empty());
        }
}

//! Matches with points that are not finite must be left out together with their covariances, for
//! 3 N and for 6 N numbers.
TEST_P(Usac_PointCovariances, notFinite)
{
    const Directed directed(testing::get<0>(GetParam()), 1, testing::get<1>(GetParam()));
    const Mat model = directed.create(Params(), 3, true)->run();
    Directed more = directed;
    more.scene.points1.push_back(Mat(3, 1, directed.scene.points1.type(), Scalar::all(NAN)));
    more.scene.points2.push_back(Mat(3, 1, directed.scene.points2.type(), Scalar::all(7)));
    for (int i = 0; i < 3; ++i)
        for (int image = 0; image < (more.both ? 2 : 1); ++image)
            append(more.sigmas, Matx22d::eye());
    const Ptr<Usac> usac = more.create(Params(), 3, true);
    EXPECT_EQ(directed.scene.points1.rows, usac->points().size);
    const Mat found = usac->run();
    EXPECT_LE(std::min(cv::norm(model - found), cv::norm(model + found)), 0.05 * cv::norm(model));
}

//! If there are covariances, a built-in residual that does not use them must be rejected. If the
//! default residual is put back, the result must be the same as before.
TEST(Usac_PointCovariances_, replacedResidual)
{
    const Directed directed(HOMOGRAPHY, 1, true);
    const Ptr<Usac> usac = directed.create(Params(), 3, true);
    const Mat model = usac->run();
    const Ptr<Residual> given = usac->components().residual;
    usac->components().residual = createResidualOf<TransferError>();
    expectRefused([&] { usac->run(); }, "replaced");
    usac->components().residual = given;
    EXPECT_EQ(0, cv::norm(model, usac->run()));
}

//! Report::chance of a right model must be small; models of random points must be rejected.
TEST_P(Usac_PointCovariances, significance)
{
    Directed directed(testing::get<0>(GetParam()), 2, testing::get<1>(GetParam()));
    Report report;
    directed.create(Params(), 3, true)->run(noArray(), &report);
    EXPECT_LT(report.chance, 1e-6);
    int found = 0;
    for (int seed = 1; seed <= 20; ++seed)
    {
        RNG rng(seed);
        rng.fill(directed.scene.points2, RNG::UNIFORM, 0, 500);
        found += !directed.create(Params(), 3, true)->run().empty();
    }
    EXPECT_LE(found, 1);
}

}  // namespace
}  // namespace opencv_test
