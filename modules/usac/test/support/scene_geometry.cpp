// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/scene_geometry.hpp"
#include "support/random_points.hpp"

#include <cmath>
#include "opencv2/usac/geometry.hpp"

namespace opencv_test {

using namespace cv;
using namespace cv::usacv20;

namespace {

const double FOCAL = 600;

Matx33d crossMatrix(const Vec3d& v)
{
    return Matx33d(0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0);
}

Vec3d randomDirection(RNG& rng)
{
    Vec3d v;
    do
        v = uniformVector(rng, -1., 1.);
    while (cv::norm(v) > 1 || cv::norm(v) < 0.1);
    return v * (1 / cv::norm(v));
}

//! Rotates camera 2, whose center is `center`, toward (0, 0, 6), the middle of what both cameras
//! see.
void turnTowards(Scene& scene, const Vec3d& center)
{
    const Vec3d seen = scene.R * (Vec3d(0, 0, 6) - center);
    Vec3d axis = seen.cross(Vec3d(0, 0, 1));
    const double turn = std::atan2(cv::norm(axis), seen[2]);
    Matx33d towards = Matx33d::eye();
    if (cv::norm(axis) > 1e-12)
        Rodrigues(axis * (turn / cv::norm(axis)), towards);
    scene.R = towards * scene.R;
}

//! Draws the rotation and the unit translation between the cameras.
void makeMotion(Scene& scene, RNG& rng, const SceneOptions& options)
{
    const double angle = options.angle * CV_PI / 180;
    if (options.motion == MOTION_GENERAL)
    {
        Rodrigues(randomDirection(rng) * angle, scene.R);
        Vec3d center = randomDirection(rng);
        center[2] *= 0.3;  // so that the motion is mostly sideways
        center *= 1 / cv::norm(center);
        turnTowards(scene, center * options.baseline);
        scene.t = -(scene.R * center);
        return;
    }
    const bool horizontal = options.motion == MOTION_PLANAR || options.motion == MOTION_CAR;
    const double turn = options.motion == MOTION_CAR ? rng.uniform(-angle, angle) : angle;
    Rodrigues(horizontal ? Vec3d(0, turn, 0)
                         : randomDirection(rng) * (options.motion == MOTION_RECTIFIED ? 0 : turn),
              scene.R);
    const double heading = rng.uniform(0., 2 * CV_PI);
    switch (options.motion)
    {
    case MOTION_FORWARD: scene.t = Vec3d(0, 0, -1); break;
    case MOTION_SIDEWAYS: scene.t = Vec3d(std::cos(heading), std::sin(heading), 0); break;
    case MOTION_PLANAR: scene.t = Vec3d(std::cos(heading), 0, std::sin(heading)); break;
    case MOTION_CAR: scene.t = Vec3d(std::sin(turn / 2), 0, -std::cos(turn / 2)); break;
    default: scene.t = Vec3d(-1, 0, 0);
    }
}

//! The affine map, similarity or translation that approximates the homography H. Affine maps and
//! similarities agree with H at the middle of image 1. The middle hardly moves between the images,
//! so a translation instead agrees with H at a quarter of the width and height.
Matx33d flattened(ProblemType problem, const Matx33d& H)
{
    const double part = problem == TRANSLATION_2D ? 4 : 2;
    const Vec3d middle(SCENE_WIDTH / part, SCENE_HEIGHT / part, 1), y = H * middle;
    Matx22d J;
    for (int k = 0; k < 4; ++k)
        J.val[k] = (H(k / 2, k % 2) - y[k / 2] / y[2] * H(2, k % 2)) / y[2];
    if (problem == TRANSLATION_2D)
        J = Matx22d::eye();
    if (problem == SIMILARITY)
        J = Matx22d(J(0, 0) + J(1, 1), J(0, 1) - J(1, 0), J(1, 0) - J(0, 1), J(0, 0) + J(1, 1)) *
            0.5;
    const Vec2d t = Vec2d(y[0] / y[2], y[1] / y[2]) - J * Vec2d(middle[0], middle[1]);
    return Matx33d(J(0, 0), J(0, 1), t[0], J(1, 0), J(1, 1), t[1], 0, 0, 1);
}

}  // namespace

bool isAffine(ProblemType problem)
{
    return problem == AFFINITY || problem == SIMILARITY || problem == TRANSLATION_2D;
}

bool inside(const Point2d& p)
{
    return p.x > SCENE_MARGIN && p.x < SCENE_WIDTH - SCENE_MARGIN && p.y > SCENE_MARGIN &&
           p.y < SCENE_HEIGHT - SCENE_MARGIN;
}

Point2d randomPixel(RNG& rng)
{
    return uniformPoint(rng, SCENE_MARGIN, SCENE_WIDTH - SCENE_MARGIN, SCENE_MARGIN,
                        SCENE_HEIGHT - SCENE_MARGIN);
}

Vec3d makeGeometry(Scene& scene, RNG& rng, const SceneOptions& options)
{
    scene.K = Matx33d(FOCAL, 0, SCENE_WIDTH / 2, 0, FOCAL, SCENE_HEIGHT / 2, 0, 0, 1);
    makeMotion(scene, rng, options);
    const Matx33d Kinv = scene.K.inv();
    const Matx33d E = crossMatrix(scene.t) * scene.R;
    scene.F = Kinv.t() * E * Kinv;
    scene.F *= 1 / cv::norm(scene.F);
    const double tiltY = rng.uniform(-0.4, 0.4), tiltX = rng.uniform(-0.4, 0.4);
    const Vec3d normal = (options.frontalPlane ? Vec3d(0, 0, 1) : Vec3d(tiltX, tiltY, 1)) *
                         (1. / 6);
    if (mapsPoints(scene.problem))
    {
        const Vec3d t = scene.t * options.baseline;
        const Matx33d tn(t[0] * normal[0], t[0] * normal[1], t[0] * normal[2], t[1] * normal[0],
                         t[1] * normal[1], t[1] * normal[2], t[2] * normal[0], t[2] * normal[1],
                         t[2] * normal[2]);
        scene.model = scene.K * (scene.R + tn) * Kinv;
        scene.model *= 1 / scene.model(2, 2);
        if (isAffine(scene.problem))
            scene.model = flattened(scene.problem, scene.model);
    }
    else
        scene.model = scene.problem == FUNDAMENTAL ? scene.F : E * (1 / cv::norm(E));
    return normal;
}

bool follow(const Geometry& g, bool plane, RNG& rng, const Point2d& p1, Point2d& p2)
{
    const Vec3d ray = g.scene.K.inv() * Vec3d(p1.x, p1.y, 1);
    const double depth = plane ? 1 / g.normal.dot(ray)
                               : rng.uniform(g.options.nearest, g.options.farthest);
    const Vec3d X2 = g.scene.R * (ray * depth) + g.scene.t * g.options.baseline;
    const Vec3d x2 = isAffine(g.scene.problem) ? g.scene.model * Vec3d(p1.x, p1.y, 1)
                                               : g.scene.K * X2;
    p2 = X2[2] > 0.5 ? Point2d(x2[0] / x2[2], x2[1] / x2[2]) : Point2d(-1, -1);
    return inside(p2);
}

void seenPoint(const Geometry& g, bool plane, RNG& rng, Point2d& p1, Point2d& p2)
{
    do
        p1 = randomPixel(rng);
    while (!follow(g, plane, rng, p1, p2));
}

}  // namespace opencv_test
