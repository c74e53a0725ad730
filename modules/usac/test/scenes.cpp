// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include "opencv2/calib3d.hpp"

namespace opencv_test {

using namespace cv;
using namespace cv::usacv20;

namespace {

const double WIDTH = SCENE_WIDTH, HEIGHT = SCENE_HEIGHT, FOCAL = 600, MARGIN = 5;
//! Of OUTLIERS_LOCAL, pixels.
const double MIN_SHIFT = 5, MAX_SHIFT = 50;
//! Of OUTLIERS_MANY_TO_ONE.
const int MATCHES_OF_ONE_POINT = 10;

Matx33d crossMatrix(const Vec3d& v)
{
    return Matx33d(0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0);
}

Vec3d randomDirection(RNG& rng)
{
    Vec3d v;
    do
        v = Vec3d(rng.uniform(-1., 1.), rng.uniform(-1., 1.), rng.uniform(-1., 1.));
    while (cv::norm(v) > 1 || cv::norm(v) < 0.1);
    return v * (1 / cv::norm(v));
}

bool inside(const Point2d& p)
{
    return p.x > MARGIN && p.x < WIDTH - MARGIN && p.y > MARGIN && p.y < HEIGHT - MARGIN;
}

Point2d randomPixel(RNG& rng)
{
    return Point2d(rng.uniform(MARGIN, WIDTH - MARGIN), rng.uniform(MARGIN, HEIGHT - MARGIN));
}

//! Cameras, and a plane n X = 1 in front of the first one.
Vec3d makeGeometry(Scene& scene, RNG& rng, double angle)
{
    scene.K = Matx33d(FOCAL, 0, WIDTH / 2, 0, FOCAL, HEIGHT / 2, 0, 0, 1);
    Rodrigues(randomDirection(rng) * (angle * CV_PI / 180), scene.R);
    Vec3d centre = randomDirection(rng);
    centre[2] *= 0.3;  // mostly sideways
    centre *= 1 / cv::norm(centre);
    // the camera turns to what both are to see, at distance 6
    const Vec3d seen = scene.R * (Vec3d(0, 0, 6) - centre);
    Vec3d axis = seen.cross(Vec3d(0, 0, 1));
    const double turn = std::atan2(cv::norm(axis), seen[2]);
    Matx33d towards = Matx33d::eye();
    if (cv::norm(axis) > 1e-12)
        Rodrigues(axis * (turn / cv::norm(axis)), towards);
    scene.R = towards * scene.R;
    scene.t = -(scene.R * centre);
    const Matx33d Kinv = scene.K.inv();
    const Matx33d E = crossMatrix(scene.t) * scene.R;
    scene.F = Kinv.t() * E * Kinv;
    scene.F *= 1 / cv::norm(scene.F);
    const Vec3d normal = Vec3d(rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4), 1) * (1. / 6);
    if (scene.problem == HOMOGRAPHY)
    {
        const Vec3d& t = scene.t;
        const Matx33d tn(t[0] * normal[0], t[0] * normal[1], t[0] * normal[2], t[1] * normal[0], t[1] * normal[1],
                         t[1] * normal[2], t[2] * normal[0], t[2] * normal[1], t[2] * normal[2]);
        scene.model = scene.K * (scene.R + tn) * Kinv;
        scene.model *= 1 / scene.model(2, 2);
    }
    else
        scene.model = scene.problem == FUNDAMENTAL ? scene.F : E * (1 / cv::norm(E));
    return normal;
}

//! A point that both cameras see; on the plane if `plane`.
void seenPoint(const Scene& scene, const Vec3d& normal, bool plane, RNG& rng, Point2d& p1, Point2d& p2)
{
    const Matx33d Kinv = scene.K.inv();
    do
    {
        p1 = randomPixel(rng);
        const Vec3d ray = Kinv * Vec3d(p1.x, p1.y, 1);
        const double depth = plane ? 1 / normal.dot(ray) : rng.uniform(4., 9.);
        const Vec3d X2 = scene.R * (ray * depth) + scene.t;
        const Vec3d x2 = scene.K * X2;
        p2 = X2[2] > 0.5 ? Point2d(x2[0] / x2[2], x2[1] / x2[2]) : Point2d(-1, -1);
    }
    while (!inside(p2));
}

//! A match as from repeated texture close by: right but for a shift in image 2.
void shiftedPoint(const Scene& scene, const Vec3d& normal, RNG& rng, Point2d& p1, Point2d& p2)
{
    do
    {
        seenPoint(scene, normal, scene.problem == HOMOGRAPHY, rng, p1, p2);
        const double direction = rng.uniform(0., 2 * CV_PI), length = rng.uniform(MIN_SHIFT, MAX_SHIFT);
        p2 += Point2d(std::cos(direction), std::sin(direction)) * length;
    }
    while (!inside(p2) || pixelError(scene, scene.model, p1, p2) < MIN_SHIFT);
}

//! With numbers of their own, so that the points do not depend on them.
void makeScores(Scene& scene, const SceneOptions& options)
{
    const double q = options.scoreInformation;
    CV_Assert(q > 0 && q <= 1);
    RNG rng(0x9e3779b9 + 7919 * options.seed);
    for (int i = 0; i < scene.size(); ++i)
    {
        const double u = rng.uniform(0., 1.);
        scene.scores.push_back((float)(scene.truth[i] ? 1 - std::pow(u, (1 - q) / q) : u));
    }
}

} // namespace

void SceneOptions::setSize(int size, double inlierRatio)
{
    inliers = cvRound(size * inlierRatio);
    outliers = size - inliers;
}

Scene makeScene(ProblemType problem, const SceneOptions& options)
{
    Scene scene;
    scene.problem = problem;
    RNG rng(0x2545f491 + 7919 * options.seed);
    const Vec3d normal = makeGeometry(scene, rng, options.angle);
    const int size = options.inliers + options.outliers, own = options.inliers - options.duplicates;
    CV_Assert(own > 0);
    const int shared = std::min(own, options.outliers / MATCHES_OF_ONE_POINT + 1);
    const int planar = problem == HOMOGRAPHY ? own : cvRound(own * options.planeFraction);
    std::vector<int> order(size);
    for (int i = 0; i < size; ++i)
        order[i] = i;
    for (int i = size - 1; i > 0; --i)
        std::swap(order[i], order[rng.uniform(0, i + 1)]);
    scene.points1.resize(size);
    scene.truth.assign(size, 0);
    scene.onPlane.assign(size, 0);
    scene.points2 = scene.clean1 = scene.clean2 = scene.points1;
    for (int i = 0; i < size; ++i)
    {
        const int row = order[i];
        if (i >= own && i < options.inliers)
        {
            const int other = order[rng.uniform(0, own)];
            scene.points1[row] = scene.points1[other];
            scene.points2[row] = scene.points2[other];
            scene.clean1[row] = scene.clean1[other];
            scene.clean2[row] = scene.clean2[other];
            scene.truth[row] = 1;
            scene.onPlane[row] = scene.onPlane[other];
            continue;
        }
        Point2d &p1 = scene.clean1[row], &p2 = scene.clean2[row];
        scene.truth[row] = i < own;
        scene.onPlane[row] = i < planar;
        if (i < own)
            seenPoint(scene, normal, i < planar, rng, p1, p2);
        else if (options.outlierModel == OUTLIERS_LOCAL)
            shiftedPoint(scene, normal, rng, p1, p2);
        else if (options.outlierModel == OUTLIERS_MANY_TO_ONE)
        {
            p1 = randomPixel(rng);
            p2 = scene.points2[order[rng.uniform(0, shared)]];
        }
        else
        {
            p1 = randomPixel(rng);
            p2 = randomPixel(rng);
        }
        const double noise = i < own ? options.noise : 0;
        scene.points1[row] = p1 + Point2d(rng.gaussian(noise), rng.gaussian(noise));
        scene.points2[row] = p2 + Point2d(rng.gaussian(noise), rng.gaussian(noise));
    }
    makeScores(scene, options);
    return scene;
}

double pixelError(const Scene& scene, const Matx33d& model, const Point2d& p1, const Point2d& p2)
{
    const Vec3d x1(p1.x, p1.y, 1), x2(p2.x, p2.y, 1);
    if (scene.problem == HOMOGRAPHY)
    {
        const Vec3d y = model * x1;
        return cv::norm(Point2d(y[0] / y[2], y[1] / y[2]) - p2);
    }
    const Matx33d Kinv = scene.K.inv();
    const Matx33d F = scene.problem == FUNDAMENTAL ? model : Kinv.t() * model * Kinv;
    const Vec3d a = F * x1, b = F.t() * x2;
    return std::abs(x2.dot(a)) / std::sqrt(a[0] * a[0] + a[1] * a[1] + b[0] * b[0] + b[1] * b[1]);
}

double modelError(const Scene& scene, const Mat& model, ScenePart part)
{
    if (model.rows != 3 || model.cols != 3 || model.type() != CV_64F)
        return std::numeric_limits<double>::infinity();
    const Matx33d M(model.ptr<double>());
    double sum = 0;
    int count = 0;
    for (int i = 0; i < scene.size(); ++i)
    {
        if (!scene.truth[i] || (part != TRUE_MATCHES && (scene.onPlane[i] != 0) != (part == ON_PLANE)))
            continue;
        const double error = pixelError(scene, M, scene.clean1[i], scene.clean2[i]);
        sum += error * error;
        ++count;
    }
    const double result = std::sqrt(sum / count);
    return result == result ? result : std::numeric_limits<double>::infinity();
}

Ptr<Usac> createUsac(const Scene& scene, const Params& params)
{
    if (scene.problem == ESSENTIAL)
        return Usac::create(ESSENTIAL, scene.points1, scene.points2, params, scene.K);
    return Usac::create(scene.problem, scene.points1, scene.points2, params);
}

Mat estimate(const Scene& scene, const Params& params, OutputArray mask, Report* report)
{
    return createUsac(scene, params)->run(mask, report);
}

Matx33d toInternal(const Correspondences& points, const Matx33d& model)
{
    const Matx33d M = points.problem == HOMOGRAPHY ? points.T2 * model * points.T1.inv()
                                                   : points.T2.inv().t() * model * points.T1.inv();
    return M * (1 / cv::norm(M));
}

double modelDistance(const Matx33d& a, const Matx33d& b)
{
    return std::min(cv::norm(a - b), cv::norm(a + b));
}

OwnPoints::OwnPoints(ProblemType problem, const std::vector<Point2d>& points1, const std::vector<Point2d>& points2,
                     double inlierThreshold)
{
    const int size = (int)points1.size();
    floats = Mat::zeros(4, (int)alignSize(std::max(size, 1), 16), CV_32F);
    for (int k = 0; k < 4; ++k)
        doubles[k].resize(size);
    for (int i = 0; i < size; ++i)
    {
        const double p[4] = {points1[i].x, points1[i].y, points2[i].x, points2[i].y};
        for (int k = 0; k < 4; ++k)
        {
            doubles[k][i] = p[k];
            floats.at<float>(k, i) = (float)p[k];
        }
        index.push_back(i);
    }
    points.problem = problem;
    points.size = points.inputSize = size;
    points.x1 = floats.ptr<float>(0);
    points.y1 = floats.ptr<float>(1);
    points.x2 = floats.ptr<float>(2);
    points.y2 = floats.ptr<float>(3);
    points.dx1 = doubles[0].data();
    points.dy1 = doubles[1].data();
    points.dx2 = doubles[2].data();
    points.dy2 = doubles[3].data();
    points.inputIndex = index.data();
    points.scores = 0;
    points.threshold = inlierThreshold;
    points.T1 = points.T2 = Matx33d::eye();
    for (int k = 0; k < 4; ++k)
    {
        points.lower[k] = size ? *std::min_element(floats.ptr<float>(k), floats.ptr<float>(k) + size) : 0;
        points.upper[k] = size ? *std::max_element(floats.ptr<float>(k), floats.ptr<float>(k) + size) : 0;
    }
}

} // namespace opencv_test
