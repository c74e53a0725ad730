// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "space_scene.hpp"

#include <cmath>
#include "random_geometry.hpp"

namespace benchmark {

using cv::Matx33d;
using cv::RNG;
using cv::Vec3d;

namespace {

//! Width of the cloud of points, and distance of the middle of each cloud from the origin of its
//! space.
const double WIDTH = 200, DISTANCE = 300;
//! Sides of the cubes of OUTLIERS_CLUSTERED and OUTLIERS_SECOND_MODEL.
const double CLUSTER = WIDTH / 8, PATCH = WIDTH / 4;
//! Second motion (OUTLIERS_SECOND_MODEL): limits of its rotation in degrees, length of its shift.
const double MIN_TURN = 15, MAX_TURN = 40, SHIFT = 0.15 * WIDTH;
const double LARGEST_SCALE = 2;

//! A cube within the cloud, or the whole cloud, in coordinates along the axes of the cloud relative
//! to its middle.
struct Cube
{
    Vec3d corner;
    double side;

    Vec3d draw(RNG& rng) const
    {
        return corner + Vec3d(rng.uniform(0., side), rng.uniform(0., side), rng.uniform(0., side));
    }
};

Cube randomCube(RNG& rng, double side)
{
    const double most = WIDTH / 2 - side;
    const Cube cube = {Vec3d(rng.uniform(-WIDTH / 2, most), rng.uniform(-WIDTH / 2, most),
                             rng.uniform(-WIDTH / 2, most)),
                       side};
    return cube;
}

/** Makes single matches without noise. The constructor draws the cloud's pose and the motion, and
writes the motion to `scene`. All random numbers come from the generator that the caller passes. */
class SpaceGeometry
{
public:
    SpaceGeometry(const SpaceOptions& options_, SpaceScene& scene, RNG& rng)
        : options(options_), motion(scene)
    {
        axes = rotationAbout(randomDirection(rng), rng.uniform(0., 180.));
        middle = randomDirection(rng) * DISTANCE;
        scene.scale = options.scaled ? std::pow(LARGEST_SCALE, rng.uniform(-1., 1.)) : 1;
        scene.R = rotationAbout(randomDirection(rng), rng.uniform(0., 180.));
        scene.t = randomDirection(rng) * DISTANCE - scene.scale * (scene.R * middle);
        turn = rotationAbout(randomDirection(rng), rng.uniform(MIN_TURN, MAX_TURN));
        shift = randomDirection(rng) * SHIFT;
        whole = randomCube(rng, WIDTH);
        from = randomCube(rng, CLUSTER);
        to = randomCube(rng, CLUSTER);
        patch = randomCube(rng, PATCH);
    }

    void right(RNG& rng, Vec3d& X1, Vec3d& X2) const
    {
        X1 = draw(rng, whole);
        X2 = move(X1);
    }

    //! Makes the i-th wrong match.
    void wrong(int i, RNG& rng, Vec3d& X1, Vec3d& X2) const
    {
        if (options.outlierModel == opencv_test::OUTLIERS_SECOND_MODEL && i < options.inliers / 2)
        {
            X1 = draw(rng, patch);
            X2 = move(turn * (X1 - middle) + middle + shift);
            return;
        }
        const bool clustered = options.outlierModel == opencv_test::OUTLIERS_CLUSTERED;
        X1 = draw(rng, clustered ? from : whole);
        X2 = move(middle + axes * (clustered ? to : whole).draw(rng));
    }

private:
    Vec3d draw(RNG& rng, const Cube& cube) const
    {
        Vec3d X = cube.draw(rng);
        if (options.flat)
            X[2] = options.thickness > 0 ? rng.gaussian(options.thickness * WIDTH) : 0;
        return middle + axes * X;
    }

    Vec3d move(const Vec3d& X) const { return motion.scale * (motion.R * X) + motion.t; }

    const SpaceOptions& options;
    const SpaceScene& motion;
    Matx33d axes;  //!< columns: axes of the cloud; the third one is the normal of a flat cloud
    Vec3d middle;  //!< middle of the cloud in space 1
    Matx33d turn;  //!< rotation about the middle, for the second motion
    Vec3d shift;
    Cube whole, from, to, patch;
};

}  // namespace

SpaceScene makeSpaceScene(const SpaceOptions& options)
{
    RNG rng(0x5bd1e995 + 7919 * options.seed);
    SpaceScene scene;
    const SpaceGeometry geometry(options, scene, rng);
    scene.points1.resize(options.inliers + options.outliers);
    scene.points2.resize(scene.points1.size());
    const auto make = [&](int row, int i) {
        Vec3d X1, X2;
        if (i < 0)
            geometry.right(rng, X1, X2);
        else
            geometry.wrong(i, rng, X1, X2);
        for (int k = 0; k < 3; ++k)
            X2[k] += rng.gaussian(options.noise);
        scene.points1[row] = cv::Point3d(X1);
        scene.points2[row] = cv::Point3d(X2);
    };
    const auto copy = [&](int row, int source) {
        scene.points1[row] = scene.points1[source];
        scene.points2[row] = scene.points2[source];
    };
    scene.truth = makeRows(options.inliers, options.outliers, options.duplicates, rng, make, copy);
    scene.scores = opencv_test::makeScores(scene.truth, options.scoreInformation, options.seed);
    return scene;
}

}  // namespace benchmark
