// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "polishing/polishing.hpp"
#include "significance/model_covariance.hpp"
#include "support/problem_objects.hpp"
#include "support/run_context.hpp"

// Tests of the class ModelCovariance with models and points for which the covariance is not
// determined, and with models that cannot be converted to the caller's coordinates. The inlier
// threshold is 1 unless OwnPoints gets another one.

namespace opencv_test {
namespace {

//! The components that ModelCovariance uses. All points within the threshold have the weight 1.
Components partsOf(const Correspondences& points)
{
    Components parts;
    parts.residual = points.problem->createResidual(RESIDUAL_STANDARD);
    parts.polisher = createLeastSquaresPolisher();
    return parts;
}

//! Noise and covariance of a model, as ModelCovariance computes them.
struct Certainty
{
    Certainty(const OwnPoints& points, const Model& model)
    {
        const Components parts = partsOf(points.view());
        const Params params;
        const RunContext run(points.view(), parts, params);
        ModelCovariance estimate(run);
        estimate.estimate(model);
        sigma = estimate.sigma();
        covariance = estimate.ofCaller();
        determined = cv::checkRange(covariance);
        unknown = true;
        for (int i = 0; i < (int)covariance.total(); ++i)
            unknown = unknown && cvIsNaN(covariance.ptr<double>()[i]);
    }

    double sigma;
    Mat covariance;
    bool determined, unknown;  //!< whether all entries of the covariance are finite; whether all
                               //!< are NaN
};

std::vector<Point2d> randomPoints(int size, double low, double high)
{
    RNG rng(3);
    std::vector<Point2d> points;
    for (int i = 0; i < size; ++i)
        points.push_back(uniformPoint(rng, low, high));
    return points;
}

//! The points moved by these distances, each in another direction.
std::vector<Point2d> displaced(const std::vector<Point2d>& points,
                               const std::vector<double>& distances)
{
    std::vector<Point2d> result;
    for (size_t i = 0; i < points.size(); ++i)
        result.push_back(points[i] +
                         distances[i] * Point2d(std::cos(2.4 * (double)i), std::sin(2.4 * i)));
    return result;
}

//! An H that maps the plane to a line has no parameterization, so that neither noise nor covariance
//! is computed, although all points agree with this H.
TEST(Usac_ModelCovariance_Limits, degenerateModel)
{
    const std::vector<Point2d> points1 = randomPoints(40, 1, 9);
    std::vector<Point2d> flat;
    for (const Point2d& p : points1)
        flat.push_back(Point2d(p.x, 0));
    const std::vector<double> noise(40, 0.1);
    const Certainty regular(OwnPoints(HOMOGRAPHY, points1, displaced(points1, noise)),
                            Matx33d::eye()),
        degenerate(OwnPoints(HOMOGRAPHY, points1, displaced(flat, noise)),
                   Matx33d(1, 0, 0, 0, 0, 0, 0, 0, 1));
    EXPECT_TRUE(regular.determined);
    EXPECT_NEAR(0.1 / std::sqrt(2.), regular.sigma, 0.02);
    EXPECT_TRUE(degenerate.unknown);
    EXPECT_EQ(0, degenerate.sigma);
}

//! Six points are within the threshold, but only three of them have the small errors of inliers.
//! With fewer inliers than the four that H needs, neither noise nor covariance is known.
TEST(Usac_ModelCovariance_Limits, noiseOfFewInliers)
{
    const std::vector<Point2d> points1 = randomPoints(6, 1, 9);
    const double distances[] = {1e-3, 0.98, 1e-3, 0.98, 1e-3, 0.98};
    const Certainty few(
        OwnPoints(HOMOGRAPHY, points1,
                  displaced(points1, std::vector<double>(distances, distances + 6))),
        Matx33d::eye());
    EXPECT_TRUE(few.unknown);
    EXPECT_EQ(0, few.sigma);
}

//! `within` of eight matches have errors of 0.6 thresholds, the others of 1.2 thresholds. The noise
//! is known in any case, because it is estimated from the errors up to twice the threshold. But two
//! matches within the threshold are too few for the covariance of a translation; eight are enough.
TEST(Usac_ModelCovariance_Limits, fewInliersWithinTheThreshold)
{
    const std::vector<Point2d> points1 = randomPoints(8, 1, 99);
    for (int within : {2, 8})
    {
        std::vector<double> distances(8, 1.2);
        std::fill(distances.begin(), distances.begin() + within, 0.6);
        const Certainty found(OwnPoints(TRANSLATION_2D, points1, displaced(points1, distances)),
                              Matx33d::eye());
        EXPECT_EQ(within == 2, found.unknown) << within;
        EXPECT_EQ(within == 8, found.determined) << within;
        EXPECT_GT(found.sigma, 0.3) << within;
    }
}

//! If all points of image 1 are on the line x = 1, scaling along x and translations along x cannot
//! be told apart, so that no covariance is known, whatever the noise is.
TEST(Usac_ModelCovariance_Limits, pointsOnALine)
{
    for (int trial = 0; trial < 50; ++trial)
    {
        RNG rng(trial);
        std::vector<Point2d> points1 = randomPoints(16, 1, 9);
        std::vector<double> noise;
        for (int i = 0; i < 16; ++i)
            noise.push_back(rng.uniform(0., 0.5));
        EXPECT_TRUE(
            Certainty(OwnPoints(AFFINITY, points1, displaced(points1, noise)), Matx33d::eye())
                .determined);
        for (Point2d& p : points1)
            p.x = 1;
        const Certainty line(OwnPoints(AFFINITY, points1, displaced(points1, noise)),
                             Matx33d::eye());
        EXPECT_TRUE(line.unknown) << trial;
        EXPECT_GT(line.sigma, 0) << trial;
    }
}

//! H is divided by h33 before it is returned. If h33 is so small that finite differences change its
//! sign, the division changes the signs of all other entries instead. The covariance must
//! nevertheless be nearly that of a similar H with a larger h33.
TEST(Usac_ModelCovariance_Limits, arbitrarySign)
{
    const std::vector<Point2d> points1 = randomPoints(40, 1, 9);
    std::vector<Point2d> points2;
    for (const Point2d& p : points1)
        points2.push_back(p * (1 / (0.3 * p.x + 0.4 * p.y)));
    const OwnPoints points(HOMOGRAPHY, points1, displaced(points2, std::vector<double>(40, 0.01)),
                           0.05);
    const Certainty tiny(points, Matx33d(1, 0, 0, 0, 1, 0, 0.3, 0.4, 3e-7)),
        similar(points, Matx33d(1, 0, 0, 0, 1, 0, 0.3, 0.4, 1e-5));
    ASSERT_TRUE(tiny.determined && similar.determined);
    EXPECT_LE(cv::norm(tiny.covariance, similar.covariance), 0.01 * cv::norm(similar.covariance));
}

//! Which step fails in the problem Unconvertible.
enum Impossible {
    NOTHING,
    CENTER_TO_INPUT,  //!< converting the model `center` to the caller's coordinates
    OTHERS_TO_INPUT,  //!< converting any other model
    TANGENT           //!< computing a basis of the tangent space at any model
};

//! The problem of affinities, in which one of the steps of Impossible fails.
class Unconvertible : public Problem
{
public:
    Unconvertible() : impossible(NOTHING), inner(problemObject(AFFINITY)) {}

    String name() const CV_OVERRIDE { return "unconvertible"; }
    int dimension() const CV_OVERRIDE { return inner.dimension(); }
    int errorDimension() const CV_OVERRIDE { return inner.errorDimension(); }
    SampleCost sampleCost() const CV_OVERRIDE { return inner.sampleCost(); }
    Ptr<Residual> createResidual(int type) const CV_OVERRIDE { return inner.createResidual(type); }
    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE
    {
        return inner.createMinimalSolver();
    }
    bool toInput(const Model& model, const Correspondences& points, Model& result) const CV_OVERRIDE
    {
        return inner.toInput(model, points, result) &&
               impossible != (model == center ? CENTER_TO_INPUT : OTHERS_TO_INPUT);
    }
    Ptr<cv::usacv20::Parameterization> createParameterization() const CV_OVERRIDE
    {
        return makePtr<Rule>(*this);
    }

    Impossible impossible;
    Model center;

private:
    class Rule : public cv::usacv20::Parameterization
    {
    public:
        explicit Rule(const Unconvertible& problem_)
            : problem(problem_), inner(problem.inner.createParameterization())
        {}
        int dimension() const CV_OVERRIDE { return inner->dimension(); }
        bool tangent(const Model& model, double* basis) const CV_OVERRIDE
        {
            return inner->tangent(model, basis) && problem.impossible != TANGENT;
        }
        Model plus(const Model& model, const double* x) const CV_OVERRIDE
        {
            return inner->plus(model, x);
        }

    private:
        const Unconvertible& problem;
        const Ptr<cv::usacv20::Parameterization> inner;
    };

    const Problem& inner;
};

//! The covariance of an affinity, the identity, whose 40 inliers have errors of 0.1, with the
//! problem Unconvertible.
class Unconverted
{
public:
    Unconverted()
        : points1(randomPoints(40, 1, 9)),
          own(AFFINITY, points1, displaced(points1, std::vector<double>(40, 0.1))),
          points(withProblem(own.view(), problem)), parts(partsOf(points)),
          run(points, parts, params), covariance(run)
    {
        covariance.estimate(Matx33d::eye());
        problem.center = covariance.model();
    }

    Unconvertible problem;

private:
    static Correspondences withProblem(Correspondences points, const Problem& problem)
    {
        points.problem = &problem;
        return points;
    }

    const std::vector<Point2d> points1;
    const OwnPoints own;
    const Correspondences points;
    const Components parts;
    const Params params;
    const RunContext run;

public:
    ModelCovariance covariance;
};

//! The covariance in the caller's coordinates is not known if the model, or a model near it that
//! finite differences need, cannot be converted to these coordinates, or if the converted model is
//! degenerate, so that it has no tangent.
TEST(Usac_ModelCovariance_Limits, modelsThatCannotBeConverted)
{
    Unconverted estimated;
    for (Impossible impossible : {NOTHING, CENTER_TO_INPUT, OTHERS_TO_INPUT, TANGENT, NOTHING})
    {
        estimated.problem.impossible = impossible;
        const Mat found = estimated.covariance.ofCaller();
        ASSERT_EQ(Size(6, 6), found.size());
        EXPECT_EQ(impossible == NOTHING, cv::checkRange(found)) << (int)impossible;
        for (int i = 0; impossible != NOTHING && i < 36; ++i)
            EXPECT_TRUE(cvIsNaN(found.ptr<double>()[i])) << (int)impossible << " " << i;
    }
}

//! The covariance of a prior refers to the caller's coordinates. If the prior cannot be converted
//! to these coordinates, ModelCovariance::weigh must not use it and must return 0.
TEST(Usac_ModelCovariance_Limits, priorThatCannotBeConverted)
{
    Unconverted estimated;
    const Mat before = estimated.covariance.ofCaller();
    const Model here = estimated.covariance.model(), prior = Matx33d(1, 0, 0.01, 0, 1, 0, 0, 0, 1);
    estimated.problem.impossible = OTHERS_TO_INPUT;
    EXPECT_EQ(0, estimated.covariance.weigh(prior, before));
    estimated.problem.impossible = NOTHING;
    EXPECT_EQ(here, estimated.covariance.model());
    EXPECT_EQ(0, cv::norm(before, estimated.covariance.ofCaller()));
    // the same prior is used if it can be converted
    EXPECT_GT(estimated.covariance.weigh(prior, before), 0.9);
    EXPECT_NE(here, estimated.covariance.model());
    EXPECT_LT(cv::norm(estimated.covariance.ofCaller()), 0.6 * cv::norm(before));
}

}  // namespace
}  // namespace opencv_test
