// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "known_scene.hpp"

#include "problems/absolute_pose/pose_scenes.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"
#include "support/scenes.hpp"

namespace benchmark {

using namespace cv;
using namespace cv::usacv20;
using namespace opencv_test;

namespace {

bool twoViews(ProblemType problem)
{
    return problem != ABSOLUTE_POSE && problem != RIGID_3D && problem != SIMILARITY_3D;
}

template <class Point>
Mat rowsOf(const std::vector<Point>& points, const std::vector<uchar>& chosen)
{
    std::vector<Point> some;
    for (size_t i = 0; i < points.size(); ++i)
        if (chosen.empty() || chosen[i])
            some.push_back(points[i]);
    return Mat(some, true).reshape(1);
}

const std::vector<uchar> ALL;

//! Standard deviation of the points' noise for which each component of the error has the deviation
//! that the cell states. For homographies, affinities and similarities both images have noise. That
//! of image 1 is mapped to image 2 by a nearly rigid map, so the variances add up.
double noiseOf(const SceneCell& cell)
{
    const bool both = cell.problem == HOMOGRAPHY || cell.problem == AFFINITY ||
                      cell.problem == SIMILARITY;
    return cell.noise * cell.threshold * (both ? std::sqrt(0.5) : 1);
}

}  // namespace

bool KnownScene::has(ProblemType problem, const std::string& shape)
{
    if (problem == FUNDAMENTAL || problem == ESSENTIAL)
        return shape == "general" || shape == "forward" || shape == "plane50" ||
               (shape == "plane95" && problem == ESSENTIAL);
    return shape == "plane" || (shape == "cloud" && !twoViews(problem));
}

KnownScene::KnownScene(const SceneCell& cell_, int seed) : cell(cell_)
{
    if (twoViews(cell.problem))
    {
        SceneOptions options;
        options.setSize(cell.size, cell.ratio);
        options.seed = seed;
        options.noise = noiseOf(cell);
        if (cell.shape == "forward")
        {
            options.motion = MOTION_FORWARD;
            options.angle = 2;
        }
        options.planeFraction = cell.shape == "plane95" ? 0.95 : cell.shape == "plane50" ? 0.5 : 0;
        const Scene scene = makeScene(cell.problem, options);
        points1 = rowsOf(scene.points1, ALL);
        points2 = rowsOf(scene.points2, ALL);
        clean1 = rowsOf(scene.clean1, scene.truth);
        clean2 = rowsOf(scene.clean2, scene.truth);
        K = Mat(scene.K, true);
        truth = Mat(scene.model, true);
        if (cell.problem == AFFINITY || cell.problem == SIMILARITY)
            truth = truth.rowRange(0, 2).clone();
        return;
    }
    if (cell.problem == ABSOLUTE_POSE)
    {
        PoseSceneOptions options;
        options.size = cell.size;
        options.inlierRatio = cell.ratio;
        options.noise = noiseOf(cell);
        options.seed = seed;
        options.shape = cell.shape == "plane" ? POSE_PLANE : POSE_CLOUD;
        const PoseScene scene = makePoseScene(options);
        points1 = rowsOf(scene.object, ALL);
        points2 = rowsOf(scene.image, ALL);
        clean1 = rowsOf(scene.object, scene.truth);
        clean2 = rowsOf(scene.clean, scene.truth);
        K = Mat(scene.K, true);
        truth = Mat(scene.pose, true);
        return;
    }
    RigidSceneOptions options;
    options.size = cell.size;
    options.inlierRatio = cell.ratio;
    options.noise = noiseOf(cell);
    options.seed = seed;
    options.shape = cell.shape == "plane" ? RIGID_PLANE : RIGID_CLOUD;
    const RigidScene scene = makeRigidScene(options);
    points1 = rowsOf(scene.points1, ALL);
    points2 = rowsOf(scene.points2, ALL);
    clean1 = rowsOf(scene.points1, scene.truth);
    clean2 = rowsOf(scene.clean2, scene.truth);
    truth = Mat(scene.motion, true);
}

bool KnownScene::run(const Params& options, double widening)
{
    Params params = options;
    params.threshold = cell.threshold * widening;
    params.covariance = 1;
    const Ptr<Usac> usac = Usac::create(cell.problem, points1, points2, params, K);
    model = usac->run(noArray(), &learned);
    return !model.empty();
}

double KnownScene::squaredDistance() const
{
    const int n = (int)truth.total();
    Mat right = truth.reshape(1, n).clone(), found = model.reshape(1, n);
    if (cell.problem == FUNDAMENTAL || cell.problem == ESSENTIAL)
        right *= (right.dot(found) < 0 ? -1 : 1) / norm(right);
    Mat x;
    solve(tangentOfModel(cell.problem, model), right - found, x, DECOMP_QR);
    Mat scale(x.rows, x.rows, CV_64F, Scalar(0)), inverse;
    for (int i = 0; i < x.rows; ++i)
        scale.at<double>(i, i) = 1 / std::sqrt(learned.covariance.at<double>(i, i));
    x = scale * x;
    if (!solve(scale * learned.covariance * scale, x, inverse, DECOMP_CHOLESKY))
        return NAN;
    return x.dot(inverse);
}

double KnownScene::error() const
{
    const Mat errors = modelErrors(cell.problem, model, clean1, clean2, Params(), K);
    return norm(errors) / std::sqrt((double)errors.rows) / cell.threshold;
}

}  // namespace benchmark
