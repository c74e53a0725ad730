// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_MODEL_CASES_HPP
#define OPENCV_USACV20_TEST_MODEL_CASES_HPP

#include "test_precomp.hpp"
#include "problems/absolute_pose/pose_scenes.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"

// Scenes with a known model for tests of its covariance and of Params::sigmas.

namespace opencv_test {
namespace {

//! Points, their true model, and the threshold for an estimation.
struct Case
{
    ProblemType problem;
    Mat points1, points2, camera, truth;
    double noise;  //!< standard deviation of a component of the error, in the unit of image 2 or
                   //!< space 2
    double threshold;

    Mat run(const Params& options, Report* report, Mat* mask = 0) const
    {
        Params params = options;
        params.threshold = threshold;
        params.covariance = 1;
        Mat unused;
        return Usac::create(problem, points1, points2, params, camera)
            ->run(mask ? *mask : unused, report);
    }
};

inline Case twoViews(ProblemType problem, const SceneOptions& options, double threshold)
{
    const Scene scene = makeScene(problem, options);
    Case result;
    result.problem = problem;
    result.points1 = column(scene.points1).clone();
    result.points2 = column(scene.points2).clone();
    result.camera = Mat(scene.K, true);
    result.truth = Mat(scene.model, true);
    if (problem == AFFINITY || problem == SIMILARITY)
        result.truth = result.truth.rowRange(0, 2).clone();
    result.noise = options.noise * (mapsPoints(problem) ? std::sqrt(2.) : 1);
    result.threshold = threshold;
    return result;
}

//! Matches with 90 % inliers. Each component of an error has a standard deviation of `noise` times
//! about a third of the threshold.
inline Case makeCase(ProblemType problem, int seed, int size = 100, double noise = 1)
{
    if (problem < ABSOLUTE_POSE)
    {
        SceneOptions options;
        options.setSize(size, 0.9);
        options.noise = 0.3 * noise;
        options.seed = seed;
        return twoViews(problem, options, mapsPoints(problem) ? 1.3 : 0.9);
    }
    Case result;
    result.problem = problem;
    if (problem == ABSOLUTE_POSE)
    {
        PoseSceneOptions options;
        options.size = size;
        options.inlierRatio = 0.9;
        options.seed = seed;
        options.noise = 0.3 * noise;
        const PoseScene scene = makePoseScene(options);
        result.points1 = column(scene.object).clone();
        result.points2 = column(scene.image).clone();
        result.camera = Mat(scene.K, true);
        result.truth = Mat(scene.pose, true);
        result.noise = options.noise;
        result.threshold = 1;
        return result;
    }
    RigidSceneOptions options;
    options.size = size;
    options.inlierRatio = 0.9;
    options.seed = seed;
    options.noise *= noise;
    options.modelScale = problem == SIMILARITY_3D ? 1.5 : 1;
    const RigidScene scene = makeRigidScene(options);
    result.points1 = column(scene.points1).clone();
    result.points2 = column(scene.points2).clone();
    result.truth = Mat(scene.motion, true);
    result.noise = options.noise * options.modelScale;
    result.threshold = scene.threshold / noise;
    return result;
}

//! The squared Mahalanobis distance of the true model from `model`. `covariance` is that of `other`
//! if it is given, otherwise that of `model`.
inline double squaredDistance(const Case& scene, const Mat& model, const Mat& covariance,
                              const Mat& other = Mat())
{
    const int n = (int)model.total();
    Mat right = scene.truth.reshape(1, n).clone(), found = model.reshape(1, n), x, solved;
    if (scene.problem == FUNDAMENTAL || scene.problem == ESSENTIAL)
        right *= (right.dot(found) < 0 ? -1 : 1) / cv::norm(right);
    cv::solve(tangentOfModel(scene.problem, other.empty() ? model : other), right - found, x,
              DECOMP_QR);
    Mat scale(x.rows, x.rows, CV_64F, Scalar(0));
    for (int i = 0; i < x.rows; ++i)
        scale.at<double>(i, i) = 1 / std::sqrt(covariance.at<double>(i, i));
    x = scale * x;
    return cv::solve(scale * covariance * scale, x, solved, DECOMP_CHOLESKY) ? x.dot(solved) : NAN;
}

inline bool isNaN(const Mat& matrix)
{
    for (int i = 0; i < (int)matrix.total(); ++i)
        if (!cvIsNaN(matrix.ptr<double>()[i]))
            return false;
    return !matrix.empty();
}

}  // namespace
}  // namespace opencv_test

#endif
