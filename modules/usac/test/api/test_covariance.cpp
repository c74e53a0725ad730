// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/random_rotation.hpp"

// Tests of the conversion of the covariance of a model's parameters to the covariance of the
// model's entries, of a relative pose and of mapped points. The results are compared with finite
// differences and with the scatter of many perturbed models.

namespace opencv_test {
namespace {

const ProblemType ALL[] = {HOMOGRAPHY, FUNDAMENTAL,   ESSENTIAL, AFFINITY,
                           SIMILARITY, ABSOLUTE_POSE, RIGID_3D,  SIMILARITY_3D};
const int PARAMETERS[] = {8, 7, 5, 6, 4, 6, 6, 7};

const Matx33d CAMERA(600, 0, 320, 0, 600, 240, 0, 0, 1);

Matx33d rotationOf(const Vec3d& w)
{
    Matx33d R;
    cv::Rodrigues(w, R);
    return R;
}

Matx33d cross(const Vec3d& t) { return Matx33d(0, -t[2], t[1], t[2], 0, -t[0], -t[1], t[0], 0); }

const Vec3d TRANSLATION(0.3, -0.5, 0.8);
const Matx33d ROTATION = rotationOf(Vec3d(0.1, -0.2, 0.3));

//! A valid model of the problem, in the form in which the estimator returns it.
Mat modelOf(ProblemType problem)
{
    if (problem <= ESSENTIAL)
    {
        const Scene scene = makeScene(problem);
        const Matx33d E = cross(TRANSLATION) * ROTATION;
        return Mat(problem == ESSENTIAL ? E * (1 / cv::norm(E)) : scene.model, true);
    }
    if (problem == AFFINITY || problem == SIMILARITY)
        return Mat(Matx23d(1.1, -0.3, 20, 0.3, problem == AFFINITY ? 0.9 : 1.1, -5));
    const double scale = problem == SIMILARITY_3D ? 1.7 : 1;
    Mat pose(3, 4, CV_64F);
    Mat(ROTATION * scale).copyTo(pose.colRange(0, 3));
    Mat(TRANSLATION + Vec3d(0, 0, 5)).copyTo(pose.col(3));
    return pose;
}

Mat moved(const Mat& model, const Mat& change) { return model + change.reshape(1, model.rows); }

//! A covariance of the parameters, with correlations. It is so small that functions of the
//! parameters are practically linear over several standard deviations.
Mat someCovariance(ProblemType problem, const Mat& model)
{
    const int d = PARAMETERS[problem];
    const Mat T = tangentOfModel(problem, model);
    RNG rng(17);
    Mat L(d, d, CV_64F, Scalar(0));
    for (int i = 0; i < d; ++i)
        for (int k = 0; k <= i; ++k)
            L.at<double>(i, k) = (i == k ? 1 : 0.4 * rng.uniform(-1., 1.)) * 1e-5;
    // `scale` makes the relative errors of all entries small although the entries have different
    // units
    Mat scale(d, d, CV_64F, Scalar(0));
    for (int i = 0; i < d; ++i)
    {
        double most = 0;
        for (int j = 0; j < T.rows; ++j)
            most = std::max(most, std::abs(T.at<double>(j, i)) /
                                      std::max(std::abs(model.ptr<double>()[j]), 1e-6));
        scale.at<double>(i, i) = 1 / most;
    }
    return scale * L * L.t() * scale;
}

//! Draws Gaussian changes of the parameters with a given covariance.
class Errors
{
public:
    explicit Errors(const Mat& covariance) : L(covariance.clone()), rng(5)
    {
        const int d = L.rows;
        for (int i = 0; i < d; ++i)  // Cholesky decomposition
            for (int k = 0; k <= i; ++k)
            {
                double sum = covariance.at<double>(i, k);
                for (int j = 0; j < k; ++j)
                    sum -= L.at<double>(i, j) * L.at<double>(k, j);
                L.at<double>(i, k) = i == k ? std::sqrt(sum) : sum / L.at<double>(k, k);
            }
        for (int i = 0; i < d; ++i)
            for (int k = i + 1; k < d; ++k)
                L.at<double>(i, k) = 0;
    }

    Mat next()
    {
        Mat x(L.rows, 1, CV_64F);
        for (int i = 0; i < L.rows; ++i)
            x.at<double>(i) = rng.gaussian(1);
        return L * x;
    }

private:
    Mat L;
    RNG rng;
};

//! Number of vectors that are drawn. A variance estimated from them has a relative standard
//! deviation of 2.2 %; the tolerance is about five times as large.
enum { DRAWN = 4000 };
const double TOLERANCE = 0.11;

//! Compares a covariance with the mean of v v^T over the vectors v.
void expectScatter(const Mat& covariance, const std::vector<Mat>& vectors)
{
    Mat scatter = Mat::zeros(covariance.size(), CV_64F);
    for (const Mat& v : vectors)
        scatter += v * v.t() / (double)vectors.size();
    for (int i = 0; i < scatter.rows; ++i)
        for (int k = 0; k < scatter.cols; ++k)
            EXPECT_NEAR(covariance.at<double>(i, k), scatter.at<double>(i, k),
                        TOLERANCE * std::sqrt(scatter.at<double>(i, i) * scatter.at<double>(k, k)))
                << i << " " << k;
}

//! For poses and 3-D motions, tangentOfModel must return the derivatives with respect to rotation,
//! translation and (similarities) scale. A matrix whose last entry is exactly 1 must not be treated
//! like a homography, whose scale is arbitrary. This is tested with many rotations, because the
//! rounding errors depend on the rotation.
TEST(Usac_Covariance, parameters_of_poses_and_motions)
{
    const double h = 1e-6;
    RNG rng(3);
    for (int i = 0; i < 120; ++i)
    {
        const ProblemType problem = std::vector<ProblemType>{ABSOLUTE_POSE, RIGID_3D,
                                                             SIMILARITY_3D}[i % 3];
        Mat model = modelOf(problem);
        if (i >= 3)
        {
            model.at<double>(2, 3) = 1;
            model.colRange(0, 3) = model.colRange(0, 3) *
                                   Mat(rotationOf(uniformVector(rng, -2., 2.)));
        }
        const Mat T = tangentOfModel(problem, model);
        ASSERT_EQ(Size(PARAMETERS[problem], 12), T.size());
        for (int k = 0; k < T.cols; ++k)
        {
            Mat sides[2];
            for (int side = 0; side < 2; ++side)
            {
                Vec3d w, t;
                const double step = side ? h : -h;
                (k < 3 ? w : t)[k % 3] = k < 6 ? step : 0;
                const double scale = k == 6 ? 1 + step : 1;
                Mat& other = sides[side] = model.clone();
                Mat(Mat(rotationOf(w)) * model.colRange(0, 3) * scale).copyTo(other.colRange(0, 3));
                other.col(3) += Mat(t);
            }
            const Mat expected = Mat(sides[1] - sides[0]).reshape(1, 12) / (2 * h);
            EXPECT_LT(cv::norm(T.col(k), expected, NORM_INF), 1e-8) << (int)problem << " " << k;
        }
    }
}

TEST(Usac_Covariance, parameters_of_maps_are_entries)
{
    EXPECT_LT(cv::norm(tangentOfModel(AFFINITY, modelOf(AFFINITY)), Mat::eye(6, 6, CV_64F)), 1e-7);
    double entries[6 * 4] = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0,
                             0, 1, 0, 0, 1, 0,  0, 0, 0, 0, 0, 1};
    const Mat expected(6, 4, CV_64F, entries);
    EXPECT_LT(cv::norm(tangentOfModel(SIMILARITY, modelOf(SIMILARITY)), expected), 1e-7);
    const Mat H = modelOf(HOMOGRAPHY), T = tangentOfModel(HOMOGRAPHY, H);
    EXPECT_EQ(0, cv::norm(T.row(8), NORM_INF));  // h33 is always 1
    // the columns of T, as changes of H / |H|, must be orthonormal
    const double size = cv::norm(H);
    const Mat unit = Mat(H / size).reshape(1, 9);
    const Mat changes = (T - unit * (unit.t() * T)) / size;
    EXPECT_LT(cv::norm(changes.t() * changes, Mat::eye(8, 8, CV_64F)), 1e-6);
    // h33 stays 1 even if all other entries are so small that the norm of H is 1 to within 2e-11
    const Matx33d tiny(1e-6, 2e-6, 3e-6, -1e-6, 2e-6, 1e-6, 3e-6, 1e-6, 1);
    EXPECT_EQ(0, cv::norm(tangentOfModel(HOMOGRAPHY, tiny).row(8), NORM_INF));
}

//! For F and E, tangentOfModel returns an orthonormal basis of the changes that keep the norm and
//! the constraints. This basis must not depend on rounding errors or the scale of the model. If the
//! model changes its sign, the basis is allowed to change its sign, too.
TEST(Usac_Covariance, basis_of_epipolar_models)
{
    for (ProblemType problem : {FUNDAMENTAL, ESSENTIAL})
    {
        const Mat model = modelOf(problem), T = tangentOfModel(problem, model);
        ASSERT_EQ(Size(PARAMETERS[problem], 9), T.size());
        EXPECT_LT(cv::norm(T.t() * T, Mat::eye(T.cols, T.cols, CV_64F)), 1e-8);
        EXPECT_LT(cv::norm(T.t() * model.reshape(1, 9)), 1e-8);
        const double h = 1e-4;
        for (int k = 0; k < T.cols; ++k)
        {
            const Mat other = moved(model, T.col(k) * h);
            Mat w;
            SVD::compute(other, w, SVD::NO_UV);
            EXPECT_LT(w.at<double>(2), 100 * h * h) << (int)problem << " " << k;
            if (problem == ESSENTIAL)
            {
                EXPECT_LT(w.at<double>(0) - w.at<double>(1), 100 * h * h) << k;
            }
        }
        RNG rng(3);
        for (int i = 0; i < 20; ++i)
        {
            Mat other = model * (1 + 1e-15 * i);
            for (int k = 0; k < 9; ++k)
                other.ptr<double>()[k] *= 1 + 1e-15 * rng.uniform(-1., 1.);
            EXPECT_LT(cv::norm(tangentOfModel(problem, other), T), 1e-6)
                << (int)problem << " " << i;
        }
        const Mat scaled = tangentOfModel(problem, model * -5);
        EXPECT_LT(std::min(cv::norm(scaled, T), cv::norm(scaled, -T)), 1e-6);
    }
    // E without rotation: in the choice of the basis, several candidates for a basis vector have
    // exactly the same length
    const Mat E = Mat(cross(Vec3d(1, 0, 0)) * std::sqrt(0.5));
    const Mat T = tangentOfModel(ESSENTIAL, E);
    EXPECT_LT(cv::norm(T.t() * T, Mat::eye(5, 5, CV_64F)), 1e-8);
}

TEST(Usac_Covariance, entries)
{
    for (ProblemType problem : ALL)
    {
        const Mat model = modelOf(problem), C = someCovariance(problem, model),
                  T = tangentOfModel(problem, model);
        const Mat entries = covarianceOfModel(problem, model, C);
        EXPECT_LT(cv::norm(entries, T * C * T.t()), 1e-12 * cv::norm(entries)) << (int)problem;
        Mat single;
        C.convertTo(single, CV_32F);
        EXPECT_LT(cv::norm(covarianceOfModel(problem, model, single), entries),
                  1e-5 * cv::norm(entries));
    }
}

TEST(Usac_Covariance, pose_of_essential_matrix)
{
    const Mat E = modelOf(ESSENTIAL), C = someCovariance(ESSENTIAL, E),
              T = tangentOfModel(ESSENTIAL, E);
    const Vec3d direction = TRANSLATION * (1 / cv::norm(TRANSLATION));
    for (double sign : {1., -1.})
    {
        const Mat covariance = covarianceOfPose(E * sign * 3, C, ROTATION, TRANSLATION * sign);
        ASSERT_EQ(Size(6, 6), covariance.size());
        EXPECT_LT(cv::norm(Mat(direction).t() * covariance.rowRange(3, 6)),
                  1e-8 * cv::norm(covariance));
        Errors errors(C);
        std::vector<Mat> vectors;
        for (int i = 0; i < DRAWN; ++i)
        {
            Mat R1, R2, t, v(6, 1, CV_64F);
            cv::decomposeEssentialMat(moved(E, T * errors.next()), R1, R2, t);
            const Mat R = cv::norm(R1, Mat(ROTATION)) < cv::norm(R2, Mat(ROTATION)) ? R1 : R2;
            // not converted with cv::Rodrigues, which returns 0 for small angles
            const Mat turn = R * Mat(ROTATION).t();
            v.at<double>(0) = turn.at<double>(2, 1);
            v.at<double>(1) = turn.at<double>(0, 2);
            v.at<double>(2) = turn.at<double>(1, 0);
            if (t.dot(Mat(direction)) * sign < 0)
                t = -t;
            Mat(t - Mat(direction) * sign).copyTo(v.rowRange(3, 6));
            vectors.push_back(v);
        }
        expectScatter(covariance, vectors);
    }
}

//! All mapped points in one column, computed without the library. For F and E, the column has the
//! signed distances of the points `second` from the epipolar lines of `first` instead.
Mat predictionOf(ProblemType problem, const Mat& model, const Mat& first, const Mat& second)
{
    Mat result;
    for (int i = 0; i < first.rows; ++i)
    {
        Mat x = Mat::ones(first.cols + 1, 1, CV_64F), y;
        Mat(first.row(i).t()).copyTo(x.rowRange(0, first.cols));
        if (problem == FUNDAMENTAL || problem == ESSENTIAL)
        {
            const Mat F = problem == FUNDAMENTAL
                              ? model
                              : Mat(Mat(CAMERA.inv().t()) * model * Mat(CAMERA.inv()));
            Mat x2 = Mat::ones(3, 1, CV_64F), line = F * x;
            Mat(second.row(i).t()).copyTo(x2.rowRange(0, 2));
            y = Mat(1, 1, CV_64F, Scalar(line.dot(x2) / cv::norm(line.rowRange(0, 2))));
        }
        else
        {
            y = model * x;
            if (problem == ABSOLUTE_POSE)
                y = Mat(CAMERA) * y;
            if (problem == HOMOGRAPHY || problem == ABSOLUTE_POSE)
                y = y.rowRange(0, 2) / y.at<double>(2);
        }
        result.push_back(y);
    }
    return result;
}

TEST(Usac_Covariance, points)
{
    for (ProblemType problem : ALL)
    {
        const Mat model = modelOf(problem), C = someCovariance(problem, model),
                  T = tangentOfModel(problem, model);
        const int columns = problem < ABSOLUTE_POSE ? 2 : 3;
        Mat first(4, columns, CV_64F), second(4, 2, CV_64F);
        RNG rng(11);
        rng.fill(first, RNG::UNIFORM, columns == 2 ? 100 : -1, columns == 2 ? 400 : 1);
        rng.fill(second, RNG::UNIFORM, 100, 400);
        const Mat found = pointCovariance(problem, model, C, first, second, CAMERA);
        ASSERT_EQ(4, found.rows);
        const int k = cvRound(std::sqrt((double)found.cols));
        ASSERT_EQ(problem == FUNDAMENTAL || problem == ESSENTIAL ? 1
                  : problem < RIGID_3D                           ? 2
                                                                 : 3,
                  k);
        const Mat before = predictionOf(problem, model, first, second);
        Errors errors(C);
        std::vector<std::vector<Mat>> vectors(4);
        for (int i = 0; i < DRAWN; ++i)
        {
            const Mat after = predictionOf(problem, moved(model, T * errors.next()), first, second);
            for (int p = 0; p < 4; ++p)
                vectors[p].push_back(Mat(after - before).rowRange(p * k, (p + 1) * k).clone());
        }
        for (int p = 0; p < 4; ++p)
        {
            SCOPED_TRACE(cv::format("problem %d, point %d", (int)problem, p));
            expectScatter(found.row(p).reshape(1, k), vectors[p]);
        }
    }
}

TEST(Usac_Covariance, points_that_are_nowhere)
{
    const Mat pose = modelOf(ABSOLUTE_POSE), C = someCovariance(ABSOLUTE_POSE, pose);
    // center of the camera, where no projection exists
    const Mat center = -pose.colRange(0, 3).t() * pose.col(3);
    const Mat points(
        Matx23d(center.at<double>(0), center.at<double>(1), center.at<double>(2), NAN, 0, 0));
    const Mat found = pointCovariance(ABSOLUTE_POSE, pose, C, points, noArray(), CAMERA);
    for (int k = 0; k < 4; ++k)
        EXPECT_TRUE(cvIsNaN(found.at<double>(1, k)));
    // the computed center is a rounding error away from the exact one, where there is no projection
    EXPECT_FALSE(found.at<double>(0, 0) < 1e12);
    const Mat unknown(6, 6, CV_64F, Scalar::all(NAN));
    EXPECT_TRUE(cvIsNaN(covarianceOfModel(ABSOLUTE_POSE, pose, unknown).at<double>(0, 0)));
    EXPECT_TRUE(
        pointCovariance(ABSOLUTE_POSE, pose, C, Mat(0, 3, CV_64F), noArray(), CAMERA).empty());
}

//! The message of the exception that `call` raises, up to its first colon; this part is the name of
//! the argument. "nothing" if there is no exception.
template <class Call>
std::string blamed(const Call& call)
{
    try
    {
        call();
    }
    catch (const cv::Exception& mistake)
    {
        return mistake.err.substr(0, mistake.err.find(':'));
    }
    return "nothing";
}

TEST(Usac_Covariance, mistakes)
{
    const Mat H = modelOf(HOMOGRAPHY), C = someCovariance(HOMOGRAPHY, H), E = modelOf(ESSENTIAL),
              D = someCovariance(ESSENTIAL, E);
    const Mat points = Mat::zeros(3, 2, CV_64F);
    EXPECT_EQ("model", blamed([&] { tangentOfModel(HOMOGRAPHY, Mat()); }));
    EXPECT_EQ("model", blamed([&] { tangentOfModel(HOMOGRAPHY, H.rowRange(0, 2)); }));
    EXPECT_EQ("model", blamed([&] { tangentOfModel(AFFINITY, H); }));
    EXPECT_EQ("model", blamed([&] { tangentOfModel(HOMOGRAPHY, H * NAN); }));
    EXPECT_EQ("model", blamed([&] { tangentOfModel(FUNDAMENTAL, H * 0); }));
    for (double second : {0., 1e-14})  // 2nd singular value; rank 1 is not valid for F
        EXPECT_EQ("model", blamed([&] {
                      tangentOfModel(FUNDAMENTAL, Matx33d(1, 0, 0, 0, second, 0, 0, 0, 0));
                  }));
    EXPECT_EQ("covariance", blamed([&] { covarianceOfModel(HOMOGRAPHY, H, D); }));
    EXPECT_EQ("covariance", blamed([&] { covarianceOfModel(HOMOGRAPHY, H, Mat()); }));
    EXPECT_EQ("covariance", blamed([&] { covarianceOfPose(E, C, ROTATION, TRANSLATION); }));
    EXPECT_EQ("R", blamed([&] { covarianceOfPose(E, D, ROTATION * 2, TRANSLATION); }));
    EXPECT_EQ("t", blamed([&] { covarianceOfPose(E, D, ROTATION, Vec3d(0, 0, 0)); }));
    EXPECT_EQ("R and t", blamed([&] { covarianceOfPose(E, D, ROTATION, Vec3d(1, 0, 0)); }));
    EXPECT_EQ("points1", blamed([&] { pointCovariance(HOMOGRAPHY, H, C, Mat(5, 1, CV_64F)); }));
    EXPECT_EQ("points1 and points2", blamed([&] {
                  pointCovariance(ESSENTIAL, E, D, points, points.rowRange(0, 2), CAMERA);
              }));
    EXPECT_EQ("cameraMatrix1", blamed([&] { pointCovariance(ESSENTIAL, E, D, points, points); }));
}

//! Estimates H or F from the points of the scene, whose coordinates are multiplied by `scale` and
//! then increased by `origin`. @return the result of pointCovariance() for these points (H:
//! covariances of the mapped points; F: variances of the distances from the epipolar lines),
//! converted back to squared pixels of the scene
Mat covarianceWithPixels(const Scene& scene, ProblemType problem, double scale, double origin)
{
    const Mat first = column(scene.points1).reshape(1) * scale + Scalar(origin),
              second = column(scene.points2).reshape(1) * scale + Scalar(origin);
    Params params;
    params.covariance = 1;
    params.threshold = 2 * scale;
    Report report;
    const Mat model = problem == HOMOGRAPHY
                          ? estimateHomography(first, second, params, noArray(), report)
                          : estimateFundamental(first, second, params, noArray(), report);
    EXPECT_TRUE(cv::checkRange(report.covariance));
    return pointCovariance(problem, model, report.covariance, first, second) / (scale * scale);
}

//! Report::covariance of F and H must be finite for coordinates of any size and origin, although
//! the entries of F and H then differ by many orders of magnitude. The covariances of points that
//! follow from it must agree with those in the original coordinates.
TEST(Usac_Covariance, any_size_and_origin_of_pixels)
{
    for (ProblemType problem : {HOMOGRAPHY, FUNDAMENTAL})
        for (uint64 seed = 1; seed <= 10; ++seed)
        {
            SceneOptions options;
            options.seed = seed;
            const Scene scene = makeScene(problem, options);
            const Mat expected = covarianceWithPixels(scene, problem, 1, 0);
            for (double scale : {0.01, 1., 10., 100.})
                for (double origin : {0., 1000.})
                {
                    const Mat found = covarianceWithPixels(scene, problem, scale, origin * scale);
                    EXPECT_LT(cvtest::norm(found, expected, NORM_INF),
                              1e-3 * cvtest::norm(expected, NORM_INF))
                        << (int)problem << " " << seed << " " << scale << " " << origin;
                }
        }
}

}  // namespace
}  // namespace opencv_test
