// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "known_scene.hpp"

#include "problems/absolute_pose/pose_scenes.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"
#include "support/scenes.hpp"

#include <limits>

namespace benchmark {

using namespace cv;
using namespace cv::usacv20;
using namespace opencv_test;

namespace {

bool twoViews(ProblemType problem)
{
    return problem != ABSOLUTE_POSE && problem != RIGID_3D && problem != SIMILARITY_3D;
}

//! True if models are 2 x 3 matrices that map image 1 to image 2.
bool affine(ProblemType problem)
{
    return problem == AFFINITY || problem == SIMILARITY || problem == TRANSLATION_2D;
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

//! Standard deviation of the points' noise for which each component of the error has the standard
//! deviation that SceneCell::noise states. For homographies and affine maps both images have noise,
//! and a nearly rigid map transfers that of image 1 to image 2, so the variances add up.
double noiseOf(const SceneCell& cell)
{
    const bool both = cell.problem == HOMOGRAPHY || affine(cell.problem);
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
        inliers = scene.truth;
        spreadNoise(rowsOf(scene.clean1, ALL), rowsOf(scene.clean2, ALL), seed);
        K = Mat(scene.K, true);
        truth = Mat(scene.model, true);
        if (affine(cell.problem))
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
        inliers = scene.truth;
        spreadNoise(points1, rowsOf(scene.clean, ALL), seed);
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
    inliers = scene.truth;
    spreadNoise(points1, rowsOf(scene.clean2, ALL), seed);
    truth = Mat(scene.motion, true);
}

//! Multiplies the noise of every second match by SceneCell::spread or, with SceneCell::directed,
//! that of each image point along a random direction. Sets `sigmas`. Does nothing if `spread` is 1.
//! Wrong matches have no noise, so their points do not change.
//! @param exact1, exact2 the points without noise
//! @param seed of the random directions
void KnownScene::spreadNoise(const Mat& exact1, const Mat& exact2, int seed)
{
    if (cell.spread == 1)
        return;
    RNG rng(seed);
    for (int i = 0; cell.directed && i < points2.rows; ++i)
    {
        stretchNoise(exact2, i, rng.uniform(0., CV_PI), points2);
        if (twoViews(cell.problem))
            stretchNoise(exact1, i, rng.uniform(0., CV_PI), points1);
    }
    if (cell.directed)
        return;
    sigmas.assign(points1.rows, 1.f);
    for (int i = 1; i < points1.rows; i += 2)
    {
        sigmas[i] = (float)cell.spread;
        points1.row(i) = exact1.row(i) + cell.spread * (points1.row(i) - exact1.row(i));
        points2.row(i) = exact2.row(i) + cell.spread * (points2.row(i) - exact2.row(i));
    }
}

//! Multiplies the noise of a point along one direction by SceneCell::spread and appends the
//! covariance of the point to `sigmas`. Its unit is the variance that each component of the error
//! of a match would have with `spread` 1.
//! @param exact `points` without noise
//! @param angle between the direction and the x axis, radians
void KnownScene::stretchNoise(const Mat& exact, int row, double angle, Mat& points)
{
    const double unit = noiseOf(cell) / (cell.noise * cell.threshold), x = std::cos(angle),
                 y = std::sin(angle), more = cell.spread * cell.spread - 1;
    const Mat noise = points.row(row) - exact.row(row);
    const double along = noise.at<double>(0) * x + noise.at<double>(1) * y;
    points.at<double>(row, 0) += (cell.spread - 1) * along * x;
    points.at<double>(row, 1) += (cell.spread - 1) * along * y;
    sigmas.push_back((float)(unit * unit * (1 + more * x * x)));
    sigmas.push_back((float)(unit * unit * more * x * y));
    sigmas.push_back((float)(unit * unit * (1 + more * y * y)));
}

Ptr<Usac> KnownScene::create(const Params& options, double threshold) const
{
    Params params = options;
    params.threshold = threshold;
    params.covariance = 1;
    return Usac::create(cell.problem, points1, points2, params, K);
}

bool KnownScene::run(const Params& options, double widening)
{
    Params params = options;
    params.sigmas = sigmas;
    model = create(params, cell.threshold * widening)->run(noArray(), &learned);
    return !model.empty();
}

double KnownScene::errorWithoutSigmas(const Params& options, double widening) const
{
    return error(create(options, cell.threshold * widening * cell.spread)->run());
}

double KnownScene::errorOfFit() const
{
    Params params;
    params.sigmas = sigmas;
    return error(create(params, cell.threshold)->fit(noArray(), Mat(inliers)));
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

double KnownScene::error(const Mat& found) const
{
    if (found.empty())
        return std::numeric_limits<double>::infinity();
    const Mat errors = modelErrors(cell.problem, found, clean1, clean2, Params(), K);
    return norm(errors) / std::sqrt((double)errors.rows) / cell.threshold;
}

}  // namespace benchmark
