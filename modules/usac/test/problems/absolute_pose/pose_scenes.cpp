// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "pose_scenes.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include "opencv2/usac/geometry.hpp"

namespace opencv_test {

using namespace cv;

namespace {

const double WIDTH = POSE_WIDTH, HEIGHT = POSE_HEIGHT, FOCAL = 600, MARGIN = 5;
//! Range of the depths of visible points, and depth of the middle of the object.
const double NEAREST = 4, FARTHEST = 9, MIDDLE = 6;
//! Standard deviation of the noise of POSE_NEAR_PLANE and POSE_NEAR_LINE, in the unit of the
//! depths.
const double ROUGHNESS = 0.02;
const double CLUSTER_RADIUS = 0.1, OUTLIER_RADIUS = 0.5, OUTLIER_SQUARE = 80, SHORTEST_LINE = 200;
//! Standard deviation of the noise of POSE_OUTLIERS_PLACE in pixels.
const double JITTER = 0.4;

Vec3d randomInBall(RNG& rng, double radius)
{
    Vec3d v;
    do
        v = uniformVector(rng, -1., 1.);
    while (v.dot(v) > 1);
    return v * radius;
}

Point2d randomPixel(RNG& rng)
{
    return uniformPoint(rng, MARGIN, WIDTH - MARGIN, MARGIN, HEIGHT - MARGIN);
}

bool inside(const Point2d& p)
{
    return p.x > MARGIN && p.x < WIDTH - MARGIN && p.y > MARGIN && p.y < HEIGHT - MARGIN;
}

//! The point at depth 1 on the ray through a pixel, without distortion.
Vec3d rayOf(const Point2d& pixel)
{
    return Vec3d((pixel.x - WIDTH / 2) / FOCAL, (pixel.y - HEIGHT / 2) / FOCAL, 1);
}

Matx33d rotationOf(const Matx34d& pose) { return pose.get_minor<3, 3>(0, 0); }

Vec3d translationOf(const Matx34d& pose) { return Vec3d(pose(0, 3), pose(1, 3), pose(2, 3)); }

Matx34d poseOf(const Matx33d& R, const Vec3d& t)
{
    Matx34d pose;
    hconcat(R, t, pose);
    return pose;
}

Matx33d rotationAround(const Vec3d& axis, double angle)
{
    Matx33d R;
    Rodrigues(axis * (angle / cv::norm(axis)), R);
    return R;
}

//! Coefficients so small that no two points in the field of view have the same image.
std::vector<double> makeDistortion(int coefficients)
{
    CV_Assert(coefficients == 0 || coefficients == 4 || coefficients == 5 || coefficients == 8 ||
              coefficients == 12 || coefficients == 14);
    const double all[] = {-0.21, 0.07,   0.0011, -0.0008, -0.011, 0.03,  0.014,
                          0.002, 0.0013, -0.001, 0.0017,  0.0006, 0.012, -0.009};
    return std::vector<double>(all, all + coefficients);
}

//! The object in camera coordinates.
class Shape
{
public:
    Shape(PoseShape kind_, RNG& rng) : kind(kind_)
    {
        do
            for (int i = 0; i < 2; ++i)
            {
                const Point2d tilt = uniformPoint(rng, -0.4, 0.4);
                normal[i] = Vec3d(tilt.x, tilt.y, 1) * (1 / MIDDLE);
            }
        while (cv::norm(normal[0] - normal[1]) < 0.4 / MIDDLE);
        Point2d ends[2];
        do
        {
            ends[0] = randomPixel(rng);
            ends[1] = randomPixel(rng);
        } while (cv::norm(ends[0] - ends[1]) < SHORTEST_LINE);
        line[0] = rayOf(ends[0]) * (NEAREST + 1);
        line[1] = rayOf(ends[1]) * (FARTHEST - 1);
        const Point2d middle = uniformPoint(rng, 0.3, 0.7);
        center = rayOf(Point2d(middle.x * WIDTH, middle.y * HEIGHT)) * MIDDLE;
    }

    //! The i-th point. It is visible unless distortion or the margin of the image excludes it.
    Vec3d point(int i, RNG& rng) const
    {
        const Vec3d ray = rayOf(randomPixel(rng));
        switch (kind)
        {
        case POSE_PLANE: return ray * (1 / normal[0].dot(ray));
        case POSE_NEAR_PLANE:
            return ray * (1 / normal[0].dot(ray) + rng.gaussian(ROUGHNESS) / cv::norm(ray));
        case POSE_TWO_PLANES: return ray * (1 / normal[i % 2].dot(ray));
        case POSE_LINE: return onLine(rng);
        case POSE_NEAR_LINE:
        {
            const Vec3d exact = onLine(rng), off = gaussianVector(rng, 1);
            return exact + off * ROUGHNESS;
        }
        case POSE_CLUSTER: return center + randomInBall(rng, CLUSTER_RADIUS);
        default: return ray * rng.uniform(NEAREST, FARTHEST);
        }
    }

private:
    Vec3d onLine(RNG& rng) const { return line[0] + (line[1] - line[0]) * rng.uniform(0., 1.); }

    PoseShape kind;
    Vec3d normal[2];  //!< normals n of the planes n * X = 1
    Vec3d line[2];    //!< end points of the line
    Vec3d center;     //!< center of the cluster
};

//! Makes the matches of one scene.
class Builder
{
public:
    Builder(const PoseSceneOptions& options_, PoseScene& scene_)
        : options(options_), scene(scene_), rng(0x2545f491 + 7919 * options_.seed),
          shape(options_.shape, rng)
    {
        scene.K = Matx33d(FOCAL, 0, WIDTH / 2, 0, FOCAL, HEIGHT / 2, 0, 0, 1);
        scene.distortion = makeDistortion(options.coefficients);
        scene.depth = MIDDLE * options.scale;
        const double angle = rng.uniform(0., CV_PI);
        const Matx33d R = rotationAround(randomInBall(rng, 1), angle);
        // origin of the object coordinates if there is no scale and no offset
        const Vec3d middle = Vec3d(0, 0, MIDDLE) + randomInBall(rng, 1);
        scene.pose = poseOf(R, middle * options.scale - R * options.offset);
        // the object turns around its middle and moves
        const double turned = rng.uniform(0.3, 0.6);
        const Matx33d turn = rotationAround(randomInBall(rng, 1), turned);
        const Vec3d pivot(0, 0, MIDDLE * options.scale),
            moved = randomInBall(rng, 0.5) * options.scale;
        scene.secondPose = poseOf(turn * R,
                                  turn * (translationOf(scene.pose) - pivot) + pivot + moved);
        corner = uniformPoint(rng, MARGIN, WIDTH - OUTLIER_SQUARE - MARGIN, MARGIN,
                              HEIGHT - OUTLIER_SQUARE - MARGIN);
        ball = rayOf(randomPixel(rng)) * MIDDLE;
        for (int i = 0; i < options.places && options.outliers == POSE_OUTLIERS_PLACE; ++i)
            places.push_back(randomPixel(rng));
    }

    void build()
    {
        const int trueOnes = std::max(3, cvRound(options.size * options.inlierRatio));
        const int wrong = options.size - trueOnes,
                  others = wrong - options.behind - options.atCenter;
        CV_Assert(options.size >= 4 && options.copies >= 1 && options.noise >= 0);
        CV_Assert(others >= 0 && options.behind >= 0 && options.atCenter >= 0);
        addSeen(scene.pose, trueOnes, 1);
        addSeen(scene.pose, options.behind, 0);
        for (int i = trueOnes; i < trueOnes + options.behind; ++i)
            scene.object[i] = throughCenter(scene.object[i]);
        for (int i = 0; i < options.atCenter; ++i)
            add(toObject(Vec3d(0, 0, 0)), randomPixel(rng), 0, 0);
        if (options.outliers == POSE_OUTLIERS_SECOND_POSE)
            addSeen(scene.secondPose, others, 0);
        else
            for (int i = 0; i < others; ++i)
                addWrong(i);
        for (int copy = 1; copy < options.copies; ++copy)
            for (int i = 0; i < options.size; ++i)
                repeatRow(i);
        shuffle();
    }

private:
    Point3d toObject(const Vec3d& Y) const
    {
        return Point3d(rotationOf(scene.pose).t() *
                       (Y * options.scale - translationOf(scene.pose)));
    }

    //! The object point behind the camera that has the same image as X.
    Point3d throughCenter(const Point3d& X) const
    {
        const Matx33d R = rotationOf(scene.pose);
        return Point3d(R.t() *
                       (-(R * Vec3d(X) + translationOf(scene.pose)) - translationOf(scene.pose)));
    }

    void add(const Point3d& X, const Point2d& clean, double noise, uchar truth)
    {
        const Point2d noisy = clean + gaussianPoint(rng, noise);
        scene.object.push_back(X);
        scene.image.push_back(noisy);
        scene.clean.push_back(truth ? clean : noisy);
        scene.truth.push_back(truth);
    }

    //! Adds `count` matches of points of the object that are visible with this pose.
    void addSeen(const Matx34d& pose, int count, uchar truth)
    {
        for (int found = 0, tries = 0; found < count; ++tries)
        {
            CV_Assert(tries < 1000);
            std::vector<Point3d> X;
            for (int i = found; i < count; ++i)
                X.push_back(toObject(shape.point(i, rng)));
            const std::vector<Point2d> seen = project(scene, pose, X);
            for (size_t i = 0; i < X.size(); ++i)
                if (inside(seen[i]) && (pose * Vec4d(X[i].x, X[i].y, X[i].z, 1))[2] > 0)
                {
                    add(X[i], seen[i], options.noise, truth);
                    ++found;
                }
        }
    }

    void addWrong(int i)
    {
        if (options.outliers == POSE_OUTLIERS_CLUSTERED)
        {
            const Point2d pixel = corner + uniformPoint(rng, 0., OUTLIER_SQUARE);
            add(toObject(ball + randomInBall(rng, OUTLIER_RADIUS)), pixel, 0, 0);
        }
        else if (i < options.structured && !places.empty())
            add(toObject(shape.point(i, rng)), places[i % places.size()], JITTER, 0);
        else
        {
            const Point2d pixel = randomPixel(rng);
            add(toObject(shape.point(i, rng)), pixel, 0, 0);
        }
    }

    void repeatRow(int i)
    {
        scene.object.push_back(Point3d(scene.object[i]));
        scene.image.push_back(Point2d(scene.image[i]));
        scene.clean.push_back(Point2d(scene.clean[i]));
        scene.truth.push_back(uchar(scene.truth[i]));
    }

    void shuffle()
    {
        for (int i = scene.size() - 1; i > 0; --i)
        {
            const int other = rng.uniform(0, i + 1);
            std::swap(scene.object[i], scene.object[other]);
            std::swap(scene.image[i], scene.image[other]);
            std::swap(scene.clean[i], scene.clean[other]);
            std::swap(scene.truth[i], scene.truth[other]);
        }
    }

    const PoseSceneOptions& options;
    PoseScene& scene;
    RNG rng;
    Shape shape;
    Point2d corner;               //!< corner of the square of POSE_OUTLIERS_CLUSTERED in the image
    Vec3d ball;                   //!< center of the ball of POSE_OUTLIERS_CLUSTERED
    std::vector<Point2d> places;  //!< image points of POSE_OUTLIERS_PLACE
};

}  // namespace

PoseScene makePoseScene(const PoseSceneOptions& options)
{
    PoseScene scene;
    Builder(options, scene).build();
    scene.scores = makeScores(scene.truth, options.scoreInformation, options.seed);
    return scene;
}

std::vector<Point2d> project(const PoseScene& scene, const Matx34d& pose,
                             const std::vector<Point3d>& object)
{
    std::vector<Point2d> result;
    if (object.empty())
        return result;
    Vec3d r;
    Rodrigues(rotationOf(pose), r);
    projectPoints(object, r, translationOf(pose), scene.K, scene.distortion, result);
    return result;
}

std::vector<double> pixelErrors(const PoseScene& scene, const Matx34d& pose)
{
    const std::vector<Point2d> seen = project(scene, pose, scene.object);
    std::vector<double> result;
    for (int i = 0; i < scene.size(); ++i)
    {
        const Point3d& X = scene.object[i];
        const bool inFront = (pose * Vec4d(X.x, X.y, X.z, 1))[2] > 0;
        result.push_back(inFront ? cv::norm(seen[i] - scene.image[i])
                                 : std::numeric_limits<double>::infinity());
    }
    return result;
}

double rotationError(const PoseScene& scene, const Matx34d& pose)
{
    // the Frobenius norm |R1 - R2| is 2 sqrt(2) sin(angle / 2)
    const double sine = cv::norm(rotationOf(pose) - rotationOf(scene.pose)) / std::sqrt(8.);
    return 2 * std::asin(std::min(1., sine)) * 180 / CV_PI;
}

double centerError(const PoseScene& scene, const Matx34d& pose)
{
    const Vec3d difference = rotationOf(pose).t() * translationOf(pose) -
                             rotationOf(scene.pose).t() * translationOf(scene.pose);
    return cv::norm(difference) / scene.depth;
}

}  // namespace opencv_test
