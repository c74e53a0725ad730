// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "view_scene.hpp"

#include <algorithm>
#include <cmath>
#include "random_geometry.hpp"

namespace benchmark {

using cv::Matx33d;
using cv::Point2d;
using cv::RNG;
using cv::Vec3d;

namespace {

const double WIDTH = opencv_test::SCENE_WIDTH, HEIGHT = opencv_test::SCENE_HEIGHT, FOCAL = 600,
             MARGIN = 5;
const double NEAREST = 4, FARTHEST = 9, MIDDLE = 6.5, LEAST_DEPTH = 1, MOST_DEPTH = 20;
const double MAX_TILT = 50, MIN_TURN = 15,
             MAX_TURN = 40;  //!< degrees: largest tilt of the plane; limits of the rotation between
                             //!< the true pose and that of OUTLIERS_SECOND_MODEL
//! Sides in pixels of the squares of OUTLIERS_CLUSTERED and OUTLIERS_SECOND_MODEL.
const double CLUSTER = 80, PATCH = 160;

struct Square
{
    Point2d corner;
    double side;

    Point2d draw(RNG& rng) const
    {
        return corner + Point2d(rng.uniform(0., side), rng.uniform(0., side));
    }
};

Square randomSquare(RNG& rng, double side)
{
    const Square square = {Point2d(rng.uniform(MARGIN, WIDTH - MARGIN - side),
                                   rng.uniform(MARGIN, HEIGHT - MARGIN - side)),
                           side};
    return square;
}

Point2d randomPixel(RNG& rng)
{
    return Point2d(rng.uniform(MARGIN, WIDTH - MARGIN), rng.uniform(MARGIN, HEIGHT - MARGIN));
}

/** Makes single matches without noise. All random numbers come from the generators that the caller
passes. Points X are in camera coordinates. */
class ViewGeometry
{
public:
    ViewGeometry(const ViewOptions& options_, RNG& rng) : options(options_)
    {
        const double tilt = rng.uniform(0., MAX_TILT), heading = rng.uniform(0., 2 * CV_PI);
        normal = rotationAbout(Vec3d(std::cos(heading), std::sin(heading), 0), tilt) *
                 Vec3d(0, 0, 1);
        turn = rotationAbout(randomDirection(rng), rng.uniform(MIN_TURN, MAX_TURN));
        shift = randomDirection(rng) * 0.5;
        from = randomSquare(rng, CLUSTER);
        to = randomSquare(rng, CLUSTER);
        patch = randomSquare(rng, PATCH);
    }

    //! Makes a point of the object that is visible, and its image.
    void right(RNG& rng, Vec3d& X, Point2d& x) const
    {
        while (!follow(rng, randomPixel(rng), X) || !see(X, x))
            ;
    }

    //! Makes the i-th wrong match. @return true if the caller must add noise to its image point
    bool wrong(int i, RNG& rng, Vec3d& X, Point2d& x) const
    {
        if (options.outlierModel == opencv_test::OUTLIERS_SECOND_MODEL && i < options.inliers / 2 &&
            second(rng, X, x))
            return true;
        if (options.outlierModel == opencv_test::OUTLIERS_CLUSTERED)
        {
            while (!follow(rng, from.draw(rng), X))
                ;
            x = to.draw(rng);
            return true;
        }
        right(rng, X, x);
        x = randomPixel(rng);
        return false;
    }

private:
    //! Makes a point of the object on the ray of a pixel; if the object is a plane with a
    //! thickness, near the ray. @return false if the depth of the point is out of range
    bool follow(RNG& rng, const Point2d& pixel, Vec3d& X) const
    {
        const Vec3d ray((pixel.x - WIDTH / 2) / FOCAL, (pixel.y - HEIGHT / 2) / FOCAL, 1);
        if (!options.onPlane)
        {
            X = ray * rng.uniform(NEAREST, FARTHEST);
            return true;
        }
        X = ray * (normal[2] * MIDDLE / normal.dot(ray));
        if (options.thickness > 0)
            X += normal * rng.gaussian(options.thickness * normal[2] * MIDDLE);
        return X[2] > LEAST_DEPTH && X[2] < MOST_DEPTH;
    }

    //! Projects a point. @return false if the point is too close to the camera or behind it, or if
    //! its projection is outside of the image or less than MARGIN pixels from the border
    bool see(const Vec3d& X, Point2d& x) const
    {
        const Point2d p(X[0] / X[2], X[1] / X[2]);
        const Point2d distorted = p * (1 + options.distortion * p.dot(p));
        x = Point2d(FOCAL * distorted.x + WIDTH / 2, FOCAL * distorted.y + HEIGHT / 2);
        return X[2] > LEAST_DEPTH && x.x > MARGIN && x.x < WIDTH - MARGIN && x.y > MARGIN &&
               x.y < HEIGHT - MARGIN;
    }

    //! Makes an object point whose true image is in the square `patch`, and the image of this point
    //! after another motion of the object. @return false if none of 1000 points is visible after
    //! this motion
    bool second(RNG& rng, Vec3d& X, Point2d& x) const
    {
        const Vec3d middle(0, 0, MIDDLE);
        for (int tries = 0; tries < 1000; ++tries)
            if (follow(rng, patch.draw(rng), X) && see(turn * (X - middle) + middle + shift, x))
                return true;
        return false;
    }

    const ViewOptions& options;
    Vec3d normal;  //!< normal of the plane, which meets the optical axis at the depth MIDDLE
    Matx33d turn;  //!< rotation of the object, about its middle, for the second pose
    Vec3d shift;
    Square from, to, patch;
};

}  // namespace

ViewScene makeViewScene(const ViewOptions& options)
{
    RNG rng(0x6b8b4567 + 7919 * options.seed);
    const ViewGeometry geometry(options, rng);
    ViewScene scene;
    scene.K = Matx33d(FOCAL, 0, WIDTH / 2, 0, FOCAL, HEIGHT / 2, 0, 0, 1);
    scene.R = rotationAbout(randomDirection(rng), rng.uniform(0., 180.));
    scene.t = Vec3d(0, 0, MIDDLE) + randomDirection(rng);
    scene.distortion = options.distortion;

    scene.objectPoints.resize(options.inliers + options.outliers);
    scene.points.resize(scene.objectPoints.size());
    const auto make = [&](int row, int i) {
        Vec3d X;
        Point2d x;
        bool noisy = true;
        if (i < 0)
            geometry.right(rng, X, x);
        else
            noisy = geometry.wrong(i, rng, X, x);
        const double noise = noisy ? options.noise : 0;
        scene.objectPoints[row] = cv::Point3d(scene.R.t() * (X - scene.t));
        scene.points[row] = x + Point2d(rng.gaussian(noise), rng.gaussian(noise));
    };
    const auto copy = [&](int row, int from) {
        scene.objectPoints[row] = scene.objectPoints[from];
        scene.points[row] = scene.points[from];
    };
    scene.truth = makeRows(options.inliers, options.outliers, options.duplicates, rng, make, copy);
    scene.scores = opencv_test::makeScores(scene.truth, options.scoreInformation, options.seed);
    return scene;
}

}  // namespace benchmark
