// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/problem_objects.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"
#include "numeric/chi_square.hpp"

namespace opencv_test {
namespace {

TEST(Usac_Statistics, chiSquareKnownValues)
{
    EXPECT_NEAR(6.634896601021214, chiSquareQuantile(0.99, 1), 1e-12);
    EXPECT_NEAR(3.841458820694124, chiSquareQuantile(0.95, 1), 1e-12);
    EXPECT_NEAR(0.454936423119573, chiSquareQuantile(0.5, 1), 1e-12);
    EXPECT_NEAR(-2 * std::log(0.01), chiSquareQuantile(0.99, 2), 1e-12);
    EXPECT_NEAR(11.34486673014437, chiSquareQuantile(0.99, 3), 1e-11);
    EXPECT_NEAR(13.27670413598762, chiSquareQuantile(0.99, 4), 1e-11);
    EXPECT_NEAR(std::sqrt(6.634896601021214), thresholdInSigmas(1), 1e-12);
    EXPECT_NEAR(std::sqrt(-2 * std::log(0.01)), thresholdInSigmas(2), 1e-12);
    EXPECT_NEAR(std::sqrt(11.34486673014437), thresholdInSigmas(3), 1e-12);
    EXPECT_EQ(0, chiSquareQuantile(0, 3));
    for (int degrees = 1; degrees < 9; ++degrees)
        for (double p = 0.001; p < 1; p += 0.037)
            EXPECT_NEAR(p, chiSquareDistribution(chiSquareQuantile(p, degrees), degrees), 1e-12);
    EXPECT_THROW(chiSquareQuantile(1, 2), cv::Exception);
}

double squaredDistance(const Matx33d& H, const Point2d& a, const Point2d& b)
{
    const Vec3d y = H * Vec3d(a.x, a.y, 1);
    return (y[0] / y[2] - b.x) * (y[0] / y[2] - b.x) + (y[1] / y[2] - b.y) * (y[1] / y[2] - b.y);
}

//! The squared Sampson distance or (`symmetric`) the squared symmetric epipolar distance.
double squaredEpipolar(const Matx33d& F, const Point2d& a, const Point2d& b, bool symmetric)
{
    const Vec3d l2 = F * Vec3d(a.x, a.y, 1), l1 = F.t() * Vec3d(b.x, b.y, 1);
    const double N = b.x * l2[0] + b.y * l2[1] + l2[2];
    const double n1 = l1[0] * l1[0] + l1[1] * l1[1], n2 = l2[0] * l2[0] + l2[1] * l2[1];
    return symmetric ? N * N * (1 / n1 + 1 / n2) : N * N / (n1 + n2);
}

//! Sorted squared errors of one exact match for `count` draws of the noise of its four coordinates.
std::vector<double> noisyErrors(const Scene& scene, const Matx33d& inverse, int row, bool symmetric,
                                int count, RNG& rng)
{
    std::vector<double> errors(count);
    for (int i = 0; i < count; ++i)
    {
        const Point2d a = scene.clean1[row] + gaussianPoint(rng, 0.5);
        const Point2d b = scene.clean2[row] + gaussianPoint(rng, 0.5);
        if (scene.problem == HOMOGRAPHY)
            errors[i] = squaredDistance(scene.model, a, b) +
                        (symmetric ? squaredDistance(inverse, b, a) : 0);
        else
            errors[i] = squaredEpipolar(scene.F, a, b, symmetric);
    }
    std::sort(errors.begin(), errors.end());
    return errors;
}

/** Checks the degrees of freedom of the errors: quantiles of the squared errors must be those of a
chi-squared distribution up to a scale. The ratio of the 0.9 quantile to the 0.3 quantile is 18.2
for one degree, 6.5 for two, 4.4 for three and 3.5 for four. */
TEST(Usac_Statistics, degreesOfFreedomOfTheErrors)
{
    const ProblemType problems[] = {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL};
    for (int k = 0; k < 6; ++k)
    {
        SceneOptions options;
        options.outliers = 0;
        const Scene scene = makeScene(problems[k / 2], options);
        const Matx33d inverse = problems[k / 2] == HOMOGRAPHY ? scene.model.inv() : Matx33d::eye();
        const int degrees = problemObject(problems[k / 2]).errorDimension(), COUNT = 20000;
        EXPECT_EQ(k < 2 ? 2 : 1, degrees);
        RNG rng(k + 1);
        double ratio = 0;
        for (int row = 0; row < 3; ++row)
        {
            const std::vector<double> errors = noisyErrors(scene, inverse, row, k % 2 == 1, COUNT,
                                                           rng);
            ratio += errors[COUNT * 9 / 10] / errors[COUNT * 3 / 10] / 3;
        }
        const double expected = chiSquareQuantile(0.9, degrees) / chiSquareQuantile(0.3, degrees);
        EXPECT_NEAR(expected, ratio, 0.06 * expected)
            << "problem " << k / 2 << " symmetric " << k % 2;
    }
}

//! Errors of a 3-D motion must have three degrees of freedom, with noise in space 2 only or in both
//! spaces.
TEST(Usac_Statistics, degreesOfFreedomInSpace)
{
    RigidSceneOptions options;
    options.noise = 0;
    options.inlierRatio = 1;
    const RigidScene scene = makeRigidScene(options);
    RNG rng(1);
    for (double noise1 : {0., 0.01})
    {
        std::vector<double> errors;
        for (int i = 0; i < 60000; ++i)
        {
            const Vec3d at(scene.points1[i % 200]), to(scene.points2[i % 200]);
            const Vec3d off1 = gaussianVector(rng, noise1);
            const Vec3d off2 = gaussianVector(rng, 0.01);
            const Vec3d error = moved(scene.motion, Point3d(at + off1)) - to - off2;
            errors.push_back(error.dot(error));
        }
        std::sort(errors.begin(), errors.end());
        const double expected = chiSquareQuantile(0.9, 3) / chiSquareQuantile(0.3, 3);
        EXPECT_NEAR(expected, errors[54000] / errors[18000], 0.03 * expected);
        const double limit = std::sqrt(1e-4 + noise1 * noise1) * thresholdInSigmas(3);
        const auto within = std::lower_bound(errors.begin(), errors.end(), limit * limit) -
                            errors.begin();
        EXPECT_NEAR(0.99, within / 60000., 0.0015);
    }
    for (int type = RIGID_3D; type <= SIMILARITY_3D; ++type)
        EXPECT_EQ(3, Usac::create((ProblemType)type, scene.points1, scene.points2)
                         ->points()
                         .problem->errorDimension());
}

//! The standard deviation of Sampson's distance is that of the noise of a coordinate, so that 99 %
//! of the inliers must be within thresholdInSigmas(1) standard deviations.
TEST(Usac_Statistics, thresholdKeepsInliers)
{
    SceneOptions options;
    options.inliers = 20000;
    options.outliers = 0;
    const Scene scene = makeScene(FUNDAMENTAL, options);
    const double limit = options.noise * thresholdInSigmas(1);
    int within = 0;
    for (int i = 0; i < scene.size(); ++i)
        within += squaredEpipolar(scene.F, scene.points1[i], scene.points2[i], false) <=
                  limit * limit;
    EXPECT_NEAR(0.99, within / 20000., 0.003);
}

//! Satterthwaite's approximation: a weighted sum of two squared normal variables must be nearly
//! chi-squared with a fractional number of degrees of freedom.
TEST(Usac_Statistics, chiSquareOfDifferentVariances)
{
    RNG rng(1);
    const int COUNT = 100000;
    for (double ratio : {0.1, 0.3, 0.7})
    {
        const double a = 1 / (1 + ratio), b = ratio / (1 + ratio), degrees = 1 / (a * a + b * b);
        for (double p : {0.5, 0.8, 0.95})
        {
            const double limit = chiSquareQuantile(p, degrees) / degrees;
            int within = 0;
            for (int i = 0; i < COUNT; ++i)
            {
                const double u = rng.gaussian(1), v = rng.gaussian(1);
                within += a * u * u + b * v * v <= limit;
            }
            EXPECT_NEAR(p, within / (double)COUNT, 0.02) << ratio;
        }
    }
}

TEST(Usac_Statistics, chiSquareOfNonsense)
{
    EXPECT_THROW(chiSquareQuantile(-0.1, 1), cv::Exception);
    EXPECT_THROW(chiSquareQuantile(1, 1), cv::Exception);
    EXPECT_THROW(chiSquareQuantile(0.5, 0), cv::Exception);
    EXPECT_THROW(thresholdInSigmas(0), cv::Exception);
    EXPECT_THROW(thresholdInSigmas(4), cv::Exception);
}

}  // namespace
}  // namespace opencv_test
