// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "significance/model_cases.hpp"
#include "neighborhood/neighborhood.hpp"
#include "support/run_context.hpp"

// Tests of Params::sigmas, the relative noise of each match.

namespace opencv_test {
namespace {

//! Noise of a component of the errors of the better matches, in pixels.
constexpr double NOISE = 0.2;

//! A scene in which every second match has five times the noise of the others.
struct MixedNoise
{
    MixedNoise(ProblemType problem, int seed) : scene(makeCase(problem, seed, 100, 0.01))
    {
        const bool spaces = problem == RIGID_3D || problem == SIMILARITY_3D;
        unit = spaces ? 50 * scene.noise : NOISE;
        scene.noise = unit;
        scene.threshold = 3 * unit;
        RNG rng(seed);
        for (int i = 0; i < scene.points2.rows; ++i)
        {
            sigmas.push_back(i % 2 ? 5.f : 1.f);
            disturb(scene.points2, i, rng);
            if (problem == FUNDAMENTAL || problem == ESSENTIAL)
                disturb(scene.points1, i, rng);
        }
    }

    void disturb(Mat& points, int row, RNG& rng) const
    {
        for (int k = 0; k < (int)points.total() * points.channels() / points.rows; ++k)
            points.ptr<double>(row)[k] += rng.gaussian(unit * sigmas[row]);
    }

    Ptr<Usac> create(Params params, double threshold, bool weighted) const
    {
        params.threshold = threshold;
        if (weighted)
            params.sigmas = sigmas;
        return Usac::create(scene.problem, scene.points1, scene.points2, params, scene.camera);
    }

    Case scene;
    double unit;  //!< noise of a match with sigma 1
    std::vector<float> sigmas;
};

typedef testing::TestWithParam<ProblemType> Usac_Sigmas;
INSTANTIATE_TEST_CASE_P(/**/, Usac_Sigmas,
                        testing::Values(HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL, AFFINITY, SIMILARITY,
                                        ABSOLUTE_POSE, RIGID_3D, SIMILARITY_3D));

/** The error of the model must be close to that of a fit to the true inliers with the true weights,
clearly lower than without sigmas, and described by the covariance. */
TEST_P(Usac_Sigmas, weightedLeastSquares)
{
    const int scenes = 60;
    double with = 0, without = 0, ideal = 0, square = 0, noise = 0;
    for (int seed = 1; seed <= scenes; ++seed)
    {
        const MixedNoise mixed(GetParam(), seed);
        Params params;
        params.covariance = 1;
        const Ptr<Usac> usac = mixed.create(params, mixed.scene.threshold, true);
        Report report;
        Mat mask;
        const Mat model = usac->run(mask, &report);
        ASSERT_FALSE(model.empty()) << seed;
        ASSERT_FALSE(isNaN(report.covariance)) << seed;
        const int d = report.covariance.rows;
        Mat weights, inliers = usac->errors(mixed.scene.truth) <= 4.5 * mixed.unit;
        for (float sigma : mixed.sigmas)
            weights.push_back(1. / (sigma * sigma));
        const Mat fit = mixed.create(params, 1, false)->fit(weights, inliers);
        const Mat equal = mixed.create(params, 3 * mixed.scene.threshold, false)->run();
        ASSERT_FALSE(equal.empty()) << seed;
        square += squaredDistance(mixed.scene, model, report.covariance) / d;
        with += squaredDistance(mixed.scene, model, report.covariance, model);
        ideal += squaredDistance(mixed.scene, fit, report.covariance, model);
        without += squaredDistance(mixed.scene, equal, report.covariance, model);
        noise += report.sigma / mixed.unit;
    }
    EXPECT_NEAR(1, square / scenes, 0.25);
    EXPECT_NEAR(1, noise / scenes, 0.05);
    EXPECT_LE(std::sqrt(with / ideal), 1.1);    // measured: 0.99 to 1.05
    EXPECT_GE(std::sqrt(without / with), 1.6);  // measured: 1.94 to 2.24
}

//! Errors must be divided by the sigmas, and the mask must compare these errors with the threshold.
TEST_P(Usac_Sigmas, errorsAndMask)
{
    const MixedNoise mixed(GetParam(), 1);
    const Ptr<Usac> usac = mixed.create(Params(), mixed.scene.threshold, true);
    Report report;
    Mat mask;
    const Mat model = usac->run(mask, &report), errors = usac->errors(model),
              plain = mixed.create(Params(), 1, false)->errors(model);
    ASSERT_FALSE(model.empty());
    EXPECT_EQ(mixed.scene.threshold, report.threshold);
    int inliers = 0;
    for (int i = 0; i < errors.rows; ++i)
    {
        const double expected = plain.at<double>(i) / mixed.sigmas[i];
        EXPECT_NEAR(expected, errors.at<double>(i), 1e-9 * expected) << i;
        EXPECT_EQ(errors.at<double>(i) <= report.threshold, mask.at<uchar>(i) != 0) << i;
        inliers += mask.at<uchar>(i) != 0;
    }
    EXPECT_EQ(inliers, report.inliers);
}

//! Norm of the difference of two models, whose signs are arbitrary for F and E.
double apart(const Mat& a, const Mat& b) { return std::min(cv::norm(a - b), cv::norm(a + b)); }

//! Fits without a search must use the sigmas, too: the weight of a match is its given weight
//! divided by the square of its sigma.
TEST_P(Usac_Sigmas, fits)
{
    const MixedNoise mixed(GetParam(), 3);
    const Ptr<Usac> usac = mixed.create(Params(), mixed.scene.threshold, true),
                    plain = mixed.create(Params(), mixed.scene.threshold, false);
    const Mat chosen = usac->errors(mixed.scene.truth) <= 4.5 * mixed.unit;
    Mat weights, inverse;
    for (float sigma : mixed.sigmas)
    {
        weights.push_back(1. / (sigma * sigma));
        inverse.push_back((double)sigma * sigma);
    }
    const Mat expected = plain->fit(weights, chosen);
    ASSERT_FALSE(expected.empty());
    const double scale = cv::norm(expected);
    EXPECT_LE(apart(usac->fit(noArray(), chosen), expected), 1e-6 * scale);
    EXPECT_LE(apart(usac->fit(inverse, chosen), plain->fit(noArray(), chosen)), 1e-6 * scale);
    EXPECT_LE(apart(usac->refine(mixed.scene.truth, chosen), expected), 1e-4 * scale);
    EXPECT_LE(apart(usac->refine(mixed.scene.truth), usac->run()), 0.05 * scale);
}

//! If the threshold is estimated, the noise must be found as a multiple of the sigmas, too.
TEST_P(Usac_Sigmas, estimatedThreshold)
{
    double sum = 0;
    const int scenes = 20;
    for (int seed = 1; seed <= scenes; ++seed)
    {
        const MixedNoise mixed(GetParam(), seed);
        Report report;
        const Ptr<Usac> usac = mixed.create(Params::automatic(), 20 * mixed.unit, true);
        ASSERT_FALSE(usac->run(noArray(), &report).empty()) << seed;
        sum += report.sigma / mixed.unit;
    }
    EXPECT_NEAR(1, sum / scenes, 0.2);
}

TEST(Usac_Sigmas_, invalid)
{
    const Scene scene = makeScene(HOMOGRAPHY, 20, 0);
    Params params;
    const auto sigmasRefused = [&]() {
        try
        {
            estimateHomography(scene.points1, scene.points2, params);
        }
        catch (const Exception& e)
        {
            return e.msg.find("sigmas") != std::string::npos;
        }
        return false;
    };
    EXPECT_FALSE(sigmasRefused());
    for (size_t wrong : {1, 19, 21})
    {
        params.sigmas.assign(wrong, 1.f);
        EXPECT_TRUE(sigmasRefused()) << wrong;
    }
    for (float wrong : {0.f, -1.f, 9e-7f, 1.1e6f, NAN, INFINITY})
    {
        params.sigmas.assign(20, 1.f);
        EXPECT_FALSE(sigmasRefused());
        params.sigmas[7] = wrong;
        EXPECT_TRUE(sigmasRefused()) << wrong;
    }
}

//! After setPoints(), an estimator must apply its sigmas to the new points. setPoints() must reject
//! a different number of points.
TEST(Usac_Sigmas_, setPoints)
{
    const MixedNoise one(HOMOGRAPHY, 1), two(HOMOGRAPHY, 2);
    const Ptr<Usac> usac = one.create(Params(), one.scene.threshold, true);
    usac->run();
    usac->setPoints(two.scene.points1, two.scene.points2);
    EXPECT_EQ(0, cv::norm(usac->run(), two.create(Params(), two.scene.threshold, true)->run()));
    EXPECT_THROW(
        usac->setPoints(two.scene.points1.rowRange(0, 50), two.scene.points2.rowRange(0, 50)),
        Exception);
}

//! Params::neighborRadius must be in pixels, whatever the unit of the threshold is.
TEST(Usac_Sigmas_, radiusOfNeighborhoods)
{
    const MixedNoise mixed(HOMOGRAPHY, 1);
    std::vector<Vec2i> edges[2];
    for (int weighted = 0; weighted < 2; ++weighted)
    {
        const Ptr<Usac> usac = mixed.create(Params(), 1, weighted != 0);
        const Ptr<Neighborhood> neighborhood = createRadiusNeighborhood(80);
        const Components none;
        const RunContext context(usac->points(), none, Params());
        neighborhood->start(context);
        edges[weighted] = edgesOf(*neighborhood, context);
    }
    EXPECT_FALSE(edges[0].empty());
    EXPECT_EQ(edges[0], edges[1]);
}

//! A residual without kernels, which applies the factors of the errors itself.
class OwnResidual : public Residual
{
public:
    explicit OwnResidual(const Ptr<Residual>& inner_) : inner(inner_) {}

    void squaredErrors(const Correspondences& points, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        inner->squaredErrors(points, model, begin, end, errors);
        for (int i = begin; i < end; ++i)
            errors[i - begin] *= square(points.column[points.columns()][i]);
    }

    void squaredErrors(const Model& model, const double* const* columns, int count,
                       double* errors) const CV_OVERRIDE
    {
        inner->squaredErrors(model, columns, count, errors);
        for (int i = 0; i < count; ++i)
            errors[i] *= square(columns[4][i]);
    }

    int linearize(const Model& model, const double* datum, double* error,
                  double* derivative) const CV_OVERRIDE
    {
        const int components = inner->linearize(model, datum, error, derivative);
        for (int k = 0; k < components; ++k)
            error[k] *= datum[4];
        for (int k = 0; k < components * model.size(); ++k)
            derivative[k] *= datum[4];
        return components;
    }

    int error(const Model& model, const double* datum, double* error) const CV_OVERRIDE
    {
        double unused[4 * 9];
        return linearize(model, datum, error, unused);
    }

private:
    template <class T>
    static T square(T x)
    {
        return x * x;
    }

    const Ptr<Residual> inner;
};

//! A replaced residual must get the factors, so that it leads to the same model.
TEST(Usac_Sigmas_, replacedResidual)
{
    for (ProblemType problem : {HOMOGRAPHY, FUNDAMENTAL})
    {
        const MixedNoise mixed(problem, 2);
        const Mat expected = mixed.create(Params(), mixed.scene.threshold, true)->run();
        const Ptr<Usac> usac = mixed.create(Params(), mixed.scene.threshold, true);
        const Ptr<Usac> plain = mixed.create(Params(), mixed.scene.threshold, false);
        usac->components().residual = makePtr<OwnResidual>(plain->components().residual);
        const Mat model = usac->run();
        ASSERT_FALSE(model.empty());
        EXPECT_LE(cv::norm(model, expected), 1e-3 * cv::norm(expected));
    }
}

}  // namespace
}  // namespace opencv_test
