// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "sequence.hpp"

#include <cmath>
#include "opencv2/usac/geometry.hpp"
#include "opencv2/usac.hpp"

namespace benchmark {

using cv::Matx33d;
using cv::Point2d;
using cv::Vec3d;

namespace {

const double WIDTH = 640, HEIGHT = 480, FOCAL = 600, DISTANCE = 6.5;
const double BOX_X = 3, BOX_Y = 2.2, BOX_Z = 1.5;  //!< half the side lengths of the box
const Matx33d CAMERA(FOCAL, 0, WIDTH / 2, 0, FOCAL, HEIGHT / 2, 0, 0, 1);

Matx33d rotationOf(const Vec3d& vector)
{
    Matx33d R;
    cv::Rodrigues(vector, R);
    return R;
}

Point2d randomPixel(cv::RNG& rng)
{
    return Point2d(rng.uniform(0., WIDTH), rng.uniform(0., HEIGHT));
}

bool isInside(const Point2d& p) { return p.x >= 0 && p.x < WIDTH && p.y >= 0 && p.y < HEIGHT; }

Point2d project(const Matx33d& M, const Vec3d& X)
{
    const Vec3d x = M * X;
    return x[2] > 0 ? Point2d(x[0] / x[2], x[1] / x[2]) : Point2d(-1, -1);
}

}  // namespace

void Sequence::setPose(int number, ImagePair& pair) const
{
    const double time = number * options.speed;
    const Vec3d turn(0.25 * std::sin(0.021 * time + 0.5), 0.35 * std::sin(0.017 * time),
                     0.3 * std::sin(0.013 * time + 1));
    pair.R = rotationOf(turn);
    pair.t = Vec3d(0.8 * std::sin(0.023 * time), 0.6 * std::sin(0.019 * time + 2),
                   DISTANCE + 1.2 * std::sin(0.011 * time));
    if (number >= options.jump)
    {
        pair.R = rotationOf(Vec3d(0.2, 0.1, 0.6)) * pair.R;
        pair.t += Vec3d(0.5, -0.4, 0.3);
    }
    pair.K2 = CAMERA;
    pair.hasCamera2 = pair.hasPose = true;
    pair.depth = DISTANCE;
    pair.size1 = pair.size2 = cv::Size2d(WIDTH, HEIGHT);
}

ImagePair Sequence::frame(int number) const
{
    ImagePair pair;
    setPose(number, pair);
    cv::RNG rng(0x51ed270b + 7919 * (uint64)options.seed + 104729 * (uint64)number);
    const bool plane = options.problem == cv::usacv20::HOMOGRAPHY;
    // `place` maps pixels of the picture (image 1) to the plane Z = 0; the picture shows this plane
    // as seen by a camera without rotation at (0, 0, -DISTANCE), the middle of the camera's path
    const Matx33d place(DISTANCE / FOCAL, 0, -WIDTH / 2 * DISTANCE / FOCAL, 0, DISTANCE / FOCAL,
                        -HEIGHT / 2 * DISTANCE / FOCAL, 0, 0, 1);
    const Matx33d& R = pair.R;
    pair.H = CAMERA *
             Matx33d(R(0, 0), R(0, 1), pair.t[0], R(1, 0), R(1, 1), pair.t[1], R(2, 0), R(2, 1),
                     pair.t[2]) *
             place;
    pair.hasHomography = pair.truthIsHomography = plane;
    const int right = cvRound(options.size * options.inliers);
    for (int i = 0; i < options.size; ++i)
    {
        Point2d x(-1, -1), x1;
        Vec3d X;
        while (!isInside(x))
        {
            x1 = randomPixel(rng);
            X = Vec3d(rng.uniform(-BOX_X, BOX_X), rng.uniform(-BOX_Y, BOX_Y),
                      rng.uniform(-BOX_Z, BOX_Z));
            x = plane ? project(pair.H, Vec3d(x1.x, x1.y, 1))
                      : project(CAMERA, pair.R * X + pair.t);
        }
        if (i < right && plane)
        {
            pair.truth1.push_back(x1);
            pair.truth2.push_back(x);
        }
        if (i < right)
            x += Point2d(rng.gaussian(options.noise), rng.gaussian(options.noise));
        else
            x = randomPixel(rng);
        if (plane)
            pair.points1.push_back(x1);
        else
            pair.objectPoints.push_back(cv::Point3d(X));
        pair.points2.push_back(x);
    }
    return pair;
}

}  // namespace benchmark
