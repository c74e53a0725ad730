// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rigid_scenes.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>

namespace opencv_test {

using namespace cv;

namespace {

//! Standard deviation of the noise of RIGID_NEAR_PLANE and RIGID_NEAR_LINE before scaling.
const double ROUGHNESS = 0.02;
const double CLUSTER_RADIUS = 0.1, OUTLIER_RADIUS = 0.3, OUTLIER_SIDE = 4, FARTHEST_MOVED = 3;
//! Standard deviation of the noise of RIGID_OUTLIERS_PLACE, divided by the threshold.
const double JITTER = 0.25;

Vec3d randomInCube(RNG& rng, double half)
{
    const double x = rng.uniform(-half, half), y = rng.uniform(-half, half),
                 z = rng.uniform(-half, half);
    return Vec3d(x, y, z);
}

Vec3d randomInBall(RNG& rng, double radius)
{
    Vec3d v;
    do
        v = randomInCube(rng, 1);
    while (v.dot(v) > 1);
    return v * radius;
}

Vec3d noiseOf(RNG& rng, double sigma)
{
    const double x = rng.gaussian(sigma), y = rng.gaussian(sigma), z = rng.gaussian(sigma);
    return Vec3d(x, y, z);
}

Matx33d linearPart(const Matx34d& motion) { return motion.get_minor<3, 3>(0, 0); }

double scaleOf(const Matx34d& motion) { return cv::norm(linearPart(motion)) / std::sqrt(3.); }

//! Makes the matches of one scene.
class Builder
{
public:
    Builder(const RigidSceneOptions& options_, RigidScene& scene_)
        : options(options_), scene(scene_), rng(0x51b3a70f + 7919 * options_.seed),
          axes(randomRotation(rng))
    {
        const double s = options.modelScale;
        const Vec3d moved1 = randomInBall(rng, FARTHEST_MOVED) * s;
        near = motionFrom(s, randomRotation(rng), moved1);
        const double angle = rng.uniform(0.3, 0.6);
        const Matx33d turn = rotationBy(randomInBall(rng, 1), angle);
        const Vec3d shift = randomInCube(rng, 1);
        other = motionFrom(1, turn * linearPart(near), moved(near, Point3d(0, 0, 0)) + shift * s);
        scene.motion = placed(near);
        scene.secondMotion = placed(other);
        scene.unit = options.unit * s;
        scene.threshold = (options.noise > 0 ? 3.5 * options.noise : 0.035) * scene.unit;
        ball1 = randomInCube(rng, 0.7);
        ball2 = randomInCube(rng, 1) * s + moved(near, Point3d(0, 0, 0));
        for (int i = 0; i < options.places && options.outliers == RIGID_OUTLIERS_PLACE; ++i)
            places.push_back(randomInCube(rng, 1) * s + moved(near, Point3d(0, 0, 0)));
    }

    void build()
    {
        CV_Assert(options.size >= 4 && options.copies >= 1 && options.noise >= 0);
        CV_Assert(options.modelScale > 0 && options.unit > 0);
        const int right = std::max(3, cvRound(options.size * options.inlierRatio));
        for (int i = 0; i < options.size; ++i)
            if (i < right)
                addMoved(near, 1);
            else if (options.outliers == RIGID_OUTLIERS_SECOND_MOTION)
                addMoved(other, 0);
            else
                addWrong(i - right);
        for (int copy = 1; copy < options.copies; ++copy)
            for (int i = 0; i < options.size; ++i)
                repeatRow(i);
        shuffle();
    }

private:
    static Matx33d rotationBy(const Vec3d& axis, double angle)
    {
        const Vec3d a = axis * (1 / cv::norm(axis));
        const double c = std::cos(angle), s = std::sin(angle);
        const Matx33d cross(0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0);
        return Matx33d::eye() * c + cross * s + (a * a.t()) * (1 - c);
    }

    //! Converts a motion in the original coordinates to the same motion in the scaled and
    //! translated coordinates.
    Matx34d placed(const Matx34d& motion) const
    {
        const Matx33d A = linearPart(motion);
        const Vec3d t(motion(0, 3), motion(1, 3), motion(2, 3));
        return motionFrom(1, A, t * options.unit + options.offset2 - A * options.offset1);
    }

    //! A random point of space 1, before scaling and translation.
    Vec3d shapePoint()
    {
        const Vec3d cube = randomInCube(rng, 1);
        switch (options.shape)
        {
        case RIGID_PLANE: return axes * Vec3d(cube[0], cube[1], 0);
        case RIGID_NEAR_PLANE: return axes * Vec3d(cube[0], cube[1], rng.gaussian(ROUGHNESS));
        case RIGID_LINE: return axes * Vec3d(cube[0], 0, 0);
        case RIGID_NEAR_LINE: return axes * Vec3d(cube[0], 0, 0) + noiseOf(rng, ROUGHNESS);
        case RIGID_CLUSTER: return randomInBall(rng, CLUSTER_RADIUS);
        default: return cube;
        }
    }

    void add(const Vec3d& x1, const Vec3d& x2, double noise, uchar truth)
    {
        const Vec3d noisy = x2 + noiseOf(rng, noise * options.modelScale);
        scene.points1.push_back(Point3d(x1 * options.unit + options.offset1));
        scene.points2.push_back(Point3d(noisy * options.unit + options.offset2));
        scene.clean2.push_back(truth ? Point3d(x2 * options.unit + options.offset2)
                                     : scene.points2.back());
        scene.truth.push_back(truth);
    }

    void addMoved(const Matx34d& motion, uchar truth)
    {
        const Vec3d x = shapePoint();
        add(x, moved(motion, Point3d(x)), options.noise, truth);
    }

    void addWrong(int i)
    {
        const double s = options.modelScale;
        if (options.outliers == RIGID_OUTLIERS_CLUSTERED)
        {
            const Vec3d from = ball1 + randomInBall(rng, OUTLIER_RADIUS);
            add(from, ball2 + randomInBall(rng, OUTLIER_RADIUS * s), 0, 0);
            return;
        }
        const Vec3d from = shapePoint();
        if (i < options.structured && !places.empty())
            add(from, places[i % places.size()], JITTER * scene.threshold / scene.unit, 0);
        else
            add(from, moved(near, Point3d(0, 0, 0)) + randomInCube(rng, 0.5 * OUTLIER_SIDE * s), 0,
                0);
    }

    void repeatRow(int i)
    {
        scene.points1.push_back(Point3d(scene.points1[i]));
        scene.points2.push_back(Point3d(scene.points2[i]));
        scene.clean2.push_back(Point3d(scene.clean2[i]));
        scene.truth.push_back(uchar(scene.truth[i]));
    }

    void shuffle()
    {
        for (int i = scene.size() - 1; i > 0; --i)
        {
            const int k = rng.uniform(0, i + 1);
            std::swap(scene.points1[i], scene.points1[k]);
            std::swap(scene.points2[i], scene.points2[k]);
            std::swap(scene.clean2[i], scene.clean2[k]);
            std::swap(scene.truth[i], scene.truth[k]);
        }
    }

    const RigidSceneOptions& options;
    RigidScene& scene;
    RNG rng;
    const Matx33d axes;         //!< axes of the plane or the line
    Matx34d near, other;        //!< true and second motion before scaling and translation
    Vec3d ball1, ball2;         //!< centers of the balls of RIGID_OUTLIERS_CLUSTERED
    std::vector<Vec3d> places;  //!< points of space 2 for RIGID_OUTLIERS_PLACE
};

}  // namespace

RigidScene makeRigidScene(const RigidSceneOptions& options)
{
    RigidScene scene;
    Builder(options, scene).build();
    scene.scores = makeScores(scene.truth, options.scoreInformation, options.seed);
    return scene;
}

Vec3d moved(const Matx34d& motion, const Point3d& point)
{
    return motion * Vec4d(point.x, point.y, point.z, 1);
}

std::vector<double> distancesOf(const RigidScene& scene, const Matx34d& motion)
{
    std::vector<double> result;
    for (int i = 0; i < scene.size(); ++i)
        result.push_back(cv::norm(moved(motion, scene.points1[i]) - Vec3d(scene.points2[i])));
    return result;
}

double rotationError(const RigidScene& scene, const Matx34d& motion)
{
    // the Frobenius norm |R1 - R2| is 2 sqrt(2) sin(angle / 2)
    const Matx33d difference = linearPart(motion) * (1 / scaleOf(motion)) -
                               linearPart(scene.motion) * (1 / scaleOf(scene.motion));
    return 2 * std::asin(std::min(1., cv::norm(difference) / std::sqrt(8.))) * 180 / CV_PI;
}

double motionError(const RigidScene& scene, const Matx34d& motion)
{
    double squares = 0;
    int count = 0;
    for (int i = 0; i < scene.size(); ++i)
        if (scene.truth[i])
        {
            const Vec3d off = moved(motion, scene.points1[i]) -
                              moved(scene.motion, scene.points1[i]);
            squares += off.dot(off);
            ++count;
        }
    return std::sqrt(squares / count) / scene.unit;
}

Matx34d motionFrom(double scale, const Matx33d& R, const Vec3d& t)
{
    const Matx33d A = R * scale;
    return Matx34d(A(0, 0), A(0, 1), A(0, 2), t[0], A(1, 0), A(1, 1), A(1, 2), t[1], A(2, 0),
                   A(2, 1), A(2, 2), t[2]);
}

}  // namespace opencv_test
