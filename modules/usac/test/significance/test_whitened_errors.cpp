// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "significance/directed_noise.hpp"
#include "problems/absolute_pose/lens_residual.hpp"
#include "problems/kernels.hpp"

// Tests of whitened errors: errors in units of their standard deviations (for two components, the
// Mahalanobis length), which follow from covariances of the points.

namespace opencv_test {
namespace {

//! Derivative of a map from the plane to the plane at a point, by central differences.
template <class Map>
Matx22d derivativeOf(const Map& map, const Vec2d& at)
{
    const double step = 1e-3;
    Matx22d result;
    for (int k = 0; k < 2; ++k)
    {
        Vec2d before = at, after = at;
        before[k] -= step;
        after[k] += step;
        const Vec2d change = (map(after) - map(before)) * (0.5 / step);
        result(0, k) = change[0];
        result(1, k) = change[1];
    }
    return result;
}

Vec2d pointOf(const Mat& points, int row)
{
    return Vec2d(points.ptr<double>(row)[0], points.ptr<double>(row)[1]);
}

//! Errors of maps of the plane must be the Mahalanobis lengths of the transfer errors in image 2,
//! whose covariances follow from those of the points in both images to first order.
TEST(Usac_WhitenedErrors, errorsOfMaps)
{
    for (ProblemType problem : {HOMOGRAPHY, AFFINITY, SIMILARITY, TRANSLATION_2D})
        for (bool both : {false, true})
        {
            Directed directed(problem == TRANSLATION_2D ? SIMILARITY : problem, 1, both);
            directed.scene.problem = problem;
            const Mat truth = problem == TRANSLATION_2D ? Mat(Matx23d(1, 0, 3, 0, 1, -5), true)
                                                        : directed.scene.truth;
            Mat M = Mat::eye(3, 3, CV_64F);
            truth.copyTo(M.rowRange(0, truth.rows));
            const Matx33d H = M;
            const auto map = [&](const Vec2d& x) {
                const Vec3d y = H * Vec3d(x[0], x[1], 1);
                return Vec2d(y[0] / y[2], y[1] / y[2]);
            };
            const Mat errors = directed.create(Params(), 3, true)->errors(truth);
            for (int i = 0; i < errors.rows; ++i)
            {
                const Vec2d x1 = pointOf(directed.scene.points1, i),
                            off = map(x1) - pointOf(directed.scene.points2, i);
                Matx22d S = directed.second[i];
                const Matx22d A = derivativeOf(map, x1);
                if (both)
                    S = S + A * directed.first[i] * A.t();
                const double expected = std::sqrt(off.dot(S.inv() * off));
                EXPECT_NEAR(expected, errors.at<double>(i), 1e-4 * expected)
                    << (int)problem << " " << i;
            }
        }
}

Vec2d undistorted(const Vec2d& x, const Matx33d& K, const Mat& lens)
{
    std::vector<Vec2d> points(1, x);
    cv::undistortPoints(points, points, K, lens, noArray(), noArray(), TermCriteria(3, 100, 1e-14));
    return points[0];
}

//! Errors of F and E must be |x2^T F x1| divided by the standard deviation of x2^T F x1. If there
//! is lens distortion, the given covariances must be taken as those of the distorted points.
TEST(Usac_WhitenedErrors, errorsOfEpipolarGeometry)
{
    for (bool both : {false, true})
        for (bool distorted : {false, true})
        {
            const Directed directed(ESSENTIAL, 1, both);
            const Mat lens = distorted ? Mat(1, 5, CV_64F, (void*)LENS) : Mat();
            const Matx33d K = directed.scene.camera, E = directed.scene.truth,
                          K2(700, 0, 300, 0, 650, 260, 0, 0, 1);
            const Mat lens2 = distorted ? Mat(lens * 0.5) : Mat();
            Params params;
            params.threshold = 3;
            params.sigmas = directed.sigmas;
            const Mat errors = modelErrors(ESSENTIAL, directed.scene.truth, directed.scene.points1,
                                           directed.scene.points2, params, K, K2, lens, lens2);
            const auto undistort1 = [&](const Vec2d& x) { return undistorted(x, K, lens); };
            const auto undistort2 = [&](const Vec2d& x) { return undistorted(x, K2, lens2); };
            for (int i = 0; i < errors.rows; ++i)
            {
                const Vec2d x1 = pointOf(directed.scene.points1, i),
                            x2 = pointOf(directed.scene.points2, i), u1 = undistort1(x1),
                            u2 = undistort2(x2);
                const Vec3d line2 = E * Vec3d(u1[0], u1[1], 1),
                            line1 = E.t() * Vec3d(u2[0], u2[1], 1);
                const Vec2d a(line2[0], line2[1]), b(line1[0], line1[1]);
                const Matx22d J1 = derivativeOf(undistort1, x1), J2 = derivativeOf(undistort2, x2);
                double variance = a.dot(J2 * directed.second[i] * J2.t() * a);
                if (both)
                    variance += b.dot(J1 * directed.first[i] * J1.t() * b);
                const double expected = std::abs(line2.dot(Vec3d(u2[0], u2[1], 1))) /
                                        std::sqrt(variance);
                EXPECT_NEAR(expected, errors.at<double>(i), 1e-4 * expected + 1e-6) << i;
            }
            if (distorted)
                continue;
            const Matx33d F = K2.inv().t() * E * K.inv();
            const Mat same = modelErrors(FUNDAMENTAL, F, directed.scene.points1,
                                         directed.scene.points2, params);
            EXPECT_LE(cv::norm(same, errors, NORM_INF), 1e-4 * cv::norm(errors, NORM_INF));
        }
}

//! Errors of poses must be the Mahalanobis lengths of the reprojection errors in the original
//! image, that is, with lens distortion.
TEST(Usac_WhitenedErrors, errorsOfPoses)
{
    for (bool distorted : {false, true})
    {
        const Directed directed(ABSOLUTE_POSE, 1, false);
        const Mat lens = distorted ? Mat(1, 5, CV_64F, (void*)LENS) : Mat();
        Params params;
        params.threshold = 3;
        params.sigmas = directed.sigmas;
        const Mat pose = directed.scene.truth;
        const Mat errors = modelErrors(ABSOLUTE_POSE, pose, directed.scene.points1,
                                       directed.scene.points2, params, directed.scene.camera,
                                       noArray(), lens);
        Mat rotation;
        cv::Rodrigues(pose.colRange(0, 3), rotation);
        std::vector<Point2d> projected;
        cv::projectPoints(directed.scene.points1.reshape(3), rotation, pose.col(3),
                          directed.scene.camera, lens, projected);
        int compared = 0;
        for (int i = 0; i < errors.rows; ++i)
        {
            const Vec2d off = Vec2d(projected[i].x, projected[i].y) -
                              pointOf(directed.scene.points2, i);
            const double expected = std::sqrt(off.dot(directed.second[i].inv() * off));
            if (!(errors.at<double>(i) <= DBL_MAX))  // a point that the camera does not see
                continue;
            ++compared;
            EXPECT_NEAR(expected, errors.at<double>(i), 1e-4 * expected) << i;
        }
        EXPECT_GT(compared, 70);
    }
}

//! Derivatives of the errors must agree with finite differences.
TEST(Usac_WhitenedErrors, derivatives)
{
    RNG rng(3);
    const PoseCamera camera(Matx33d(500, 2, 320, 0, 510, 240, 0, 0, 1),
                            Mat(1, 5, CV_64F, (void*)LENS));
    const Ptr<Residual> residuals[] = {
        createResidualOf<WhitenedTransferError>(), createResidualOf<WhitenedSampsonError>(),
        createResidualOf<WhitenedReprojectionError>(), makePtr<LensResidual>(camera, true)};
    for (int which = 0; which < 4; ++which)
        for (int repeat = 0; repeat < 50; ++repeat)
        {
            const Residual& residual = *residuals[which];
            const bool pose = which > 1;
            Model model = pose ? Model(3, 4) : Model(3, 3);
            for (int k = 0; k < model.size(); ++k)
                model.val[k] = (k % (pose ? 5 : 4) == 0) + rng.gaussian(0.1);
            if (pose)
                model.val[11] += 5;
            double datum[MAX_COLUMNS], error[2][4], derivative[MAX_DERIVATIVE], unused[4];
            for (int k = 0; k < MAX_COLUMNS; ++k)
                datum[k] = rng.gaussian(k < (pose ? 5 : 4) ? 0.5 : 0.3);
            for (int k = pose ? 5 : 4; k < MAX_COLUMNS; ++k)
                if ((k - (pose ? 5 : 4)) % 3 != 1)  // p, s of a root [p 0; q s] are positive
                    datum[k] = 0.1 + std::abs(datum[k]);
            const int components = residual.linearize(model, datum, unused, derivative);
            ASSERT_EQ(which == 1 ? 1 : 2, components);
            residual.error(model, datum, error[0]);
            for (int c = 0; c < components; ++c)
                EXPECT_EQ(error[0][c], unused[c]);
            for (int k = 0; k < model.size(); ++k)
            {
                const double step = 1e-6;
                Model moved = model;
                moved.val[k] -= step;
                residual.error(moved, datum, error[0]);
                moved.val[k] += 2 * step;
                residual.error(moved, datum, error[1]);
                for (int c = 0; c < components; ++c)
                {
                    const double expected = (error[1][c] - error[0][c]) / (2 * step),
                                 found = derivative[model.size() * c + k];
                    EXPECT_NEAR(expected, found, 1e-5 * (1 + std::abs(expected)))
                        << which << " " << c << " " << k;
                }
            }
        }
}

//! The squared error must be the squared length of the error vector. For points behind the camera,
//! the squared error must be infinite, the first component of the error vector 1e100, and the
//! derivatives of both components 0.
TEST(Usac_WhitenedErrors, squaredErrors)
{
    const PoseCamera camera(Matx33d::eye(), Mat(1, 5, CV_64F, (void*)LENS));
    const Ptr<Residual> residuals[] = {createResidualOf<WhitenedReprojectionError>(),
                                       makePtr<LensResidual>(camera, true)};
    const double seen[] = {0.1, 0.2, 1, 0.3, 0.4, 0.5, 0.2, 0.7},
                 behind[] = {0.1, 0.2, -9, 0.3, 0.4, 0.5, 0.2, 0.7};
    Model model(3, 4);
    model(0, 0) = model(1, 1) = model(2, 2) = model(2, 3) = 1;
    for (const Ptr<Residual>& residual : residuals)
    {
        double error[4], squared, derivative[MAX_DERIVATIVE];
        const double* columns[8];
        for (int k = 0; k < 8; ++k)
            columns[k] = seen + k;
        residual->squaredErrors(model, columns, 1, &squared);
        residual->error(model, seen, error);
        EXPECT_NEAR(error[0] * error[0] + error[1] * error[1], squared, 1e-12 * squared);
        for (int k = 0; k < 8; ++k)
            columns[k] = behind + k;
        residual->squaredErrors(model, columns, 1, &squared);
        EXPECT_EQ(INFINITY, squared);
        residual->linearize(model, behind, error, derivative);
        EXPECT_EQ(1e100, error[0]);
        for (int k = 0; k < 24; ++k)
            EXPECT_EQ(0, derivative[k]);
    }
}

}  // namespace
}  // namespace opencv_test
