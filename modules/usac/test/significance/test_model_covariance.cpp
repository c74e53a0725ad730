// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "significance/model_cases.hpp"

// Tests of whether Report::covariance and Report::sigma describe the errors of models.

namespace opencv_test {
namespace {

typedef testing::TestWithParam<ProblemType> Usac_ModelCovariance;
INSTANTIATE_TEST_CASE_P(/**/, Usac_ModelCovariance,
                        testing::Values(HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL, AFFINITY, SIMILARITY,
                                        ABSOLUTE_POSE, RIGID_3D, SIMILARITY_3D));

/** The mean over n scenes of the squared Mahalanobis distance divided by its dimension d must be
about 1. The standard deviation of this mean is sqrt(2 / (d n)), 0.04 to 0.05 for 200 scenes. The
mean increases if there are outliers among the inliers or errors that are too large for a linear
approximation, so that the tolerance is larger above 1 than below. */
TEST_P(Usac_ModelCovariance, calibrated)
{
    const int scenes = 200;
    for (PolishingType polishing :
         {POLISHING_ROBUST, POLISHING_LEAST_SQUARES, POLISHING_REWEIGHTED})
    {
        Params params;
        params.polishing = polishing;
        double sum = 0, noise = 0;
        int within = 0, d = 0;
        for (int seed = 1001; seed <= 1000 + scenes; ++seed)
        {
            const Case scene = makeCase(GetParam(), seed);
            Report report;
            const Mat model = scene.run(params, &report);
            ASSERT_FALSE(model.empty()) << seed;
            ASSERT_FALSE(isNaN(report.covariance)) << seed;
            d = report.covariance.rows;
            const double square = squaredDistance(scene, model, report.covariance);
            ASSERT_GE(square, 0) << seed;
            sum += square / d;
            const double quantiles[] = {9.4877, 11.0705, 12.5916, 14.0671, 15.5073};
            within += square <= quantiles[d - 4];
            noise += report.sigma / scene.noise;
        }
        // in one dimension, MAGSAC++'s weights grow steeply toward an error of 0: covariances of F
        // and E are a third too large
        const bool singular = polishing == POLISHING_REWEIGHTED &&
                              (GetParam() == FUNDAMENTAL || GetParam() == ESSENTIAL);
        EXPECT_LE(sum / scenes, 1.19) << (int)polishing;
        EXPECT_GE(sum / scenes, singular ? 0.65 : 0.85) << (int)polishing;
        EXPECT_GE(within, scenes * 0.9) << (int)polishing;  // 3.2 standard deviations below 95 %
        EXPECT_NEAR(1, noise / scenes, 0.04) << (int)polishing;
    }
}

TEST_P(Usac_ModelCovariance, same_bits_and_no_influence)
{
    const Case scene = makeCase(GetParam(), 3);
    Report one, many;
    Mat mask1, mask2, mask3;
    Params params;
    const Mat model = scene.run(params, &one, &mask1);
    params.threads = 0;
    const int threads = cv::getNumThreads();
    cv::setNumThreads(4);
    const Mat parallel = scene.run(params, &many, &mask2), silent = scene.run(params, 0, &mask3);
    cv::setNumThreads(threads);
    EXPECT_EQ(0, cvtest::norm(model, parallel, NORM_INF));
    EXPECT_EQ(0, cvtest::norm(model, silent, NORM_INF));
    EXPECT_EQ(0, cvtest::norm(mask1, mask3, NORM_INF));
    EXPECT_EQ(0, cvtest::norm(one.covariance, many.covariance, NORM_INF));
    EXPECT_EQ(one.sigma, many.sigma);
}

//! With an estimated threshold, the inliers are nearly the same as with the given one, so that each
//! variance must change by at most 35 %.
TEST_P(Usac_ModelCovariance, estimated_threshold)
{
    const Case scene = makeCase(GetParam(), 5);
    Report given, estimated;
    scene.run(Params(), &given);
    Params params = Params::automatic();
    Case wide = scene;
    wide.threshold *= 3;
    wide.run(params, &estimated);
    ASSERT_FALSE(isNaN(estimated.covariance));
    for (int i = 0; i < given.covariance.rows; ++i)
        EXPECT_NEAR(1, estimated.covariance.at<double>(i, i) / given.covariance.at<double>(i, i),
                    0.35)
            << i;
}

TEST_P(Usac_ModelCovariance, not_determined)
{
    const Case scene = makeCase(GetParam(), 1);
    Report report;
    Params params;
    params.polishing = POLISHING_NONE;
    ASSERT_FALSE(scene.run(params, &report).empty());
    EXPECT_TRUE(isNaN(report.covariance));
    EXPECT_EQ(0, report.sigma);
    const int d = report.covariance.rows;
    Case nothing = scene;  // too few points
    nothing.points1 = scene.points1.rowRange(0, 1).clone();
    nothing.points2 = scene.points2.rowRange(0, 1).clone();
    EXPECT_TRUE(nothing.run(Params(), &report).empty());
    EXPECT_TRUE(report.covariance.empty());
    EXPECT_EQ(0, report.sigma);
    EXPECT_GE(d, 4);
}

//! Points on a plane do not determine all parameters of F, and the images of cameras at practically
//! the same place do not determine all parameters of E, although noise can make it look as if they
//! did. At most one in ten models is allowed to have a covariance.
TEST(Usac_ModelCovariance_, free_parameters)
{
    int determined = 0, models = 0;
    for (ProblemType problem : {FUNDAMENTAL, ESSENTIAL})
        for (int seed = 1; seed <= 20; ++seed)
        {
            SceneOptions options;
            options.setSize(200, 1);
            options.seed = seed;
            options.noise = 0.3;
            if (problem == FUNDAMENTAL)
                options.planeFraction = 1;
            else
                options.baseline = 1e-6;
            const Case scene = twoViews(problem, options, 1);
            Report report;
            Params params;
            params.significance = 1;
            if (scene.run(params, &report).empty())
                continue;
            ++models;
            determined += !isNaN(report.covariance);
        }
    EXPECT_GE(models, 30);
    // noise can look like a translation or like points off the plane
    EXPECT_LE(determined, models / 10);
}

//! Points on a plane determine E up to a discrete second solution, so that there must be a
//! covariance.
TEST(Usac_ModelCovariance_, essential_of_plane)
{
    SceneOptions options;
    options.setSize(200, 1);
    options.noise = 0.1;
    options.planeFraction = 1;
    Report report;
    twoViews(ESSENTIAL, options, 1).run(Params(), &report);
    EXPECT_FALSE(isNaN(report.covariance));
}

//! The scene with every second match, beginning with match `first`.
Case halfOf(const Case& scene, int first)
{
    Case half = scene;
    half.points1.release();
    half.points2.release();
    for (int i = first; i < scene.points1.rows; i += 2)
    {
        half.points1.push_back(scene.points1.row(i));
        half.points2.push_back(scene.points2.row(i));
    }
    return half;
}

/** The model of one half of the matches is a prior for the other half. The errors of the result
must agree with the covariance of the result. The squared distance of the result from the truth must
be clearly smaller than without the prior (half is expected); for this comparison, both distances
are measured with the covariance of the run without the prior. */
TEST_P(Usac_ModelCovariance, prior)
{
    const struct
    {
        int size;
        double noise;
    } kinds[] = {{100, 1}, {40, 1}, {100, 0.01}};
    for (const auto& kind : kinds)
    {
        SCOPED_TRACE(testing::Message() << kind.size << " matches, noise " << kind.noise);
        const int scenes = 120;
        double sum = 0, with = 0, without = 0, shrunk = 0;
        int used = 0;
        for (int seed = 1; seed <= scenes; ++seed)
        {
            const Case scene = makeCase(GetParam(), seed, kind.size, kind.noise),
                       second = halfOf(scene, 1);
            Report before, alone, report;
            const Mat prior = halfOf(scene, 0).run(Params(), &before),
                      single = second.run(Params(), &alone);
            ASSERT_FALSE(prior.empty() || single.empty()) << seed;
            if (isNaN(before.covariance) || isNaN(alone.covariance))
                continue;
            EXPECT_EQ(0, alone.priorChance);
            Params params;
            params.setInitialModel(prior, before.covariance);
            const Mat model = second.run(params, &report);
            ASSERT_FALSE(model.empty()) << seed;
            if (report.priorChance < 0.001)
                continue;
            const int d = report.covariance.rows;
            ++used;
            sum += squaredDistance(scene, model, report.covariance) / d;
            with += squaredDistance(scene, model, alone.covariance, single) / d;
            without += squaredDistance(scene, single, alone.covariance) / d;
            shrunk += cv::trace(report.covariance)[0] / cv::trace(alone.covariance)[0];
        }
        EXPECT_GE(used, 0.96 * scenes);
        EXPECT_GT(sum / used, 0.85);
        EXPECT_LT(sum / used, 1.25);
        EXPECT_LT(with, 0.65 * without);
        EXPECT_LT(shrunk / used, 0.65);
    }
}

//! A prior that contradicts the points must have only the effect of the same initial model without
//! a covariance.
TEST_P(Usac_ModelCovariance, contradictingPrior)
{
    const Case scene = makeCase(GetParam(), 1);
    Report other, started, report;
    const Mat wrong = makeCase(GetParam(), 2).run(Params(), &other);
    Params params;
    params.setInitialModel(wrong);
    const Mat expected = scene.run(params, &started);
    params.setInitialModel(wrong, other.covariance);
    EXPECT_EQ(0, cv::norm(expected, scene.run(params, &report)));
    EXPECT_LT(report.priorChance, 0.001);
    EXPECT_EQ(0, cv::norm(started.covariance, report.covariance));
    // a prior with a huge covariance must give the result of the same initial model without
    // covariance
    params.setInitialModel(expected);
    const Mat again = scene.run(params, &started);
    params.setInitialModel(expected, 1e12 * other.covariance);
    EXPECT_LE(cv::norm(again, scene.run(params, &report)), 1e-6 * cv::norm(again));
    EXPECT_GT(report.priorChance, 0.999);
    // with a tiny covariance of the prior, the result must be the prior
    params.setInitialModel(expected, 1e-12 * started.covariance);
    EXPECT_LE(cv::norm(expected, scene.run(params, &report)), 1e-6 * cv::norm(expected));
    EXPECT_LE(cv::norm(report.covariance), 1e-6 * cv::norm(started.covariance));
}

TEST_P(Usac_ModelCovariance, priorsOfAnySize)
{
    const Case scene = makeCase(GetParam(), 1);
    Report report;
    const Mat model = scene.run(Params(), &report);
    const int d = report.covariance.rows;
    for (double factor : {1e-307, 1e-200, 1., 1e200, 1e307})
    {
        Params params;
        params.setInitialModel(model, factor * Mat::eye(d, d, CV_64F));
        const Mat result = scene.run(params, &report);
        ASSERT_FALSE(result.empty()) << factor;
        EXPECT_LE(cv::norm(result - model), 1e-2 * cv::norm(model)) << factor;
        EXPECT_TRUE(cv::checkRange(report.covariance)) << factor;
        EXPECT_GE(report.priorChance, 0) << factor;
        EXPECT_LE(report.priorChance, 1) << factor;
    }
}

TEST_P(Usac_ModelCovariance, refinedModel)
{
    const Case scene = makeCase(GetParam(), 1);
    Report report, refined;
    Params params;
    const Mat model = scene.run(params, &report);
    params.threshold = scene.threshold;
    params.covariance = 1;
    Mat mask;
    refineModel(scene.problem, model, scene.points1, scene.points2, params, mask, refined,
                noArray(), scene.camera);
    EXPECT_LE(cv::norm(refined.covariance - report.covariance), 0.02 * cv::norm(report.covariance));
    EXPECT_NEAR(report.sigma, refined.sigma, 0.01 * report.sigma);
    params.covariance = 0;
    refineModel(scene.problem, model, scene.points1, scene.points2, params, mask, refined,
                noArray(), scene.camera);
    EXPECT_TRUE(refined.covariance.empty());
}

TEST_P(Usac_ModelCovariance, invalidPrior)
{
    const Case scene = makeCase(GetParam(), 1);
    Report report;
    const Mat model = scene.run(Params(), &report), C = report.covariance;
    const int d = C.rows;
    const Mat zeros = Mat::zeros(d, d, CV_64F);
    Mat oblique = C.clone(), unknown = C.clone();
    oblique.at<double>(0, 1) += std::sqrt(C.at<double>(0, 0) * C.at<double>(1, 1));
    unknown.at<double>(1, 1) = NAN;
    for (const Mat& wrong : {Mat(-C), zeros, oblique, unknown, Mat(C(Rect(1, 1, d - 1, d - 1)))})
    {
        Params params;
        params.setInitialModel(model, wrong);
        try
        {
            scene.run(params, &report);
            ADD_FAILURE() << "no exception for " << wrong;
        }
        catch (const Exception& e)
        {
            EXPECT_NE(std::string::npos, e.msg.find("initialCovariance")) << e.msg;
        }
    }
    Params params;
    params.setInitialModel(noArray(), C);
    EXPECT_THROW(params.check(), Exception);
    EXPECT_THROW(params.setInitialModel(model, Mat(d, d, CV_64FC2, Scalar::all(1))), Exception);
}

}  // namespace
}  // namespace opencv_test
