// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/absolute_pose/p3p.hpp"
#include "problems/absolute_pose/absolute_pose.hpp"
#include "problems/absolute_pose/triangle_depths.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** A triangle in its own coordinate frame: corner 2 is the origin, corner 3 is at (length, 0), and
corner 1 is at (along, height) with height >= 0. */
struct TriangleFrame
{
    //! @param side3, side1 vectors from corner 2 to corner 3 and to corner 1
    TriangleFrame(const Vec3d& side3, const Vec3d& side1)
    {
        length = std::sqrt(side3.dot(side3));
        x = side3 * (1 / length);
        along = side1.dot(x);
        Vec3d across = side1 - along * x;
        across -= across.dot(x) * x;  // rounding leaves a part along x if the triangle is flat
        height = std::sqrt(across.dot(across));
        y = across * (1 / height);
        z = x.cross(y);
    }

    double length, along, height;
    Vec3d x, y, z;  //!< the axes
};

//! There is no model if the height of the triangle is at most LEAST_HEIGHT times its longest side
//! or at most LEAST_EXTENT times the largest coordinate: the corners are then collinear up to
//! rounding.
constexpr double LEAST_HEIGHT = 1e-9, LEAST_EXTENT = 1e-13;
//! Unit vectors of two rays are equal up to rounding if their distance is at most this value.
constexpr double LEAST_DISTANCE = 4e-15;
//! Largest reprojection error of a point of the sample, on the plane z = 1, with which a pose is
//! accepted. The error is estimated from rounding errors and from the misfit between the triangle
//! of the object points and the triangle of the same points in camera coordinates.
constexpr double MISFIT = 1e-6;

//! Three points, reordered so that the first one lies opposite the longest side.
struct PoseSample
{
    PoseSample(const Correspondences& p, const int* sample, const Matx33d& inverse)
    {
        Vec3d given[3];
        for (int i = 0; i < 3; ++i)
            given[i] = Vec3d(p.exact[0][sample[i]], p.exact[1][sample[i]], p.exact[2][sample[i]]);
        double longest = -1;
        int first = 0;
        largest = 0;
        for (int i = 0; i < 3; ++i)
        {
            for (int k = 0; k < 3; ++k)
                largest = std::max(largest, std::abs(given[i][k]));
            const Vec3d side = given[(i + 2) % 3] - given[(i + 1) % 3];
            const double squared = side.dot(side);
            if (squared > longest)
            {
                longest = squared;
                first = i;
            }
        }
        for (int i = 0; i < 3; ++i)
        {
            const int from = (first + i) % 3;
            const double x = p.exact[3][sample[from]], y = p.exact[4][sample[from]];
            const double u = inverse(0, 0) * x + inverse(0, 1) * y,
                         v = inverse(1, 0) * x + inverse(1, 1) * y;
            X[i] = given[from];
            length[i] = std::sqrt(u * u + v * v + 1);
            const double unit = 1 / length[i];
            ray[i] = Vec3d(u * unit, v * unit, unit);
        }
    }

    Vec3d X[3], ray[3];
    double length[3];  //!< lengths of the rays from the camera center to the plane z = 1
    double largest;    //!< largest absolute coordinate of the object points
};

//! Computes [R t] that maps the object's triangle to the triangle in camera coordinates. False if
//! the two triangles are not congruent up to rounding, or if a point is so close to the camera
//! center that its image is undetermined.
bool poseOf(const PoseSample& sample, const TriangleFrame& object, const TriangleDepths& depths,
            double sigma, Model& model)
{
    const double w2 = depths.w / sigma + depths.p, unit = object.length;
    const Vec3d *ray = sample.ray, *X = sample.X;
    const Vec3d side3 = ((depths.q - depths.p) * ray[2] + w2 * (ray[2] - ray[1])) * unit;
    const Vec3d side1 = (w2 * (ray[0] - ray[1]) - depths.p * ray[0]) * unit;
    const TriangleFrame camera(side3, side1);
    const double d[3] = {depths.w / sigma, w2, depths.w / sigma + depths.q};
    double misfit = 4 * DBL_EPSILON *
                    (sample.largest +
                     unit * std::max(std::max(d[0], d[1]), d[2]));  // rounding error of t
    misfit += std::abs(camera.length - object.length) + std::abs(camera.along - object.along) +
              std::abs(camera.height - object.height);
    for (int i = 0; i < 3; ++i)
        if (!(misfit * sample.length[i] * sample.length[i] <=
              MISFIT * unit * d[i]))  // NaN is rejected, too
            return false;
    const Vec3d center = X[1] + ((X[0] - X[1]) + (X[2] - X[1])) * (1. / 3);
    const Vec3d moved = (unit * w2) * ray[1] + (side3 + side1) * (1. / 3);
    model = Model(3, 4);
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j)
            model(i, j) = camera.x[i] * object.x[j] + camera.y[i] * object.y[j] +
                          camera.z[i] * object.z[j];
        model(i, 3) = moved[i] -
                      (model(i, 0) * center[0] + model(i, 1) * center[1] + model(i, 2) * center[2]);
    }
    return true;
}

//! Replaces [R t] with `camera` [R t].
void withCamera(const Matx33d& camera, Model& model)
{
    for (int k = 0; k < 4; ++k)
    {
        const double x = model(0, k), y = model(1, k);
        model(0, k) = camera(0, 0) * x + camera(0, 1) * y;
        model(1, k) = camera(1, 0) * x + camera(1, 1) * y;
    }
}

}  // namespace

int P3PSolver::sampleSize() const { return 3; }

int P3PSolver::solve(const Correspondences& points, const int* sample, Model* models) const
{
    const PoseSample s(points, sample, inverse);
    const TriangleFrame object(s.X[2] - s.X[1], s.X[0] - s.X[1]);
    if (!(object.height > LEAST_HEIGHT * object.length &&
          object.height > LEAST_EXTENT * s.largest))  // NaN is rejected, too
        return 0;
    const Vec3d r12 = s.ray[0] - s.ray[1], r13 = s.ray[0] - s.ray[2], r23 = s.ray[1] - s.ray[2];
    const double s12 = r12.dot(r12), s13 = r13.dot(r13), s23 = r23.dot(r23);
    const double squared = std::max(std::max(s12, s13), s23);
    if (!(std::min(std::min(s12, s13), s23) > LEAST_DISTANCE * LEAST_DISTANCE))
        return 0;
    const double a = object.along / object.length, h = object.height / object.length;
    Triangle triangle;
    triangle.sigma = std::sqrt(squared);
    triangle.a12 = a * a + h * h;
    triangle.a13 = (1 - a) * (1 - a) + h * h;
    triangle.s12 = s12 / squared;
    triangle.s13 = s13 / squared;
    triangle.s23 = s23 / squared;
    TriangleDepths depths[MAX_TRIANGLE_DEPTHS];
    const int count = solveTriangle(triangle, depths);
    int found = 0;
    for (int i = 0; i < count; ++i)
        if (poseOf(s, object, depths[i], triangle.sigma, models[found]))
            withCamera(camera, models[found++]);
    return found;
}

Ptr<MinimalSolver> createP3PSolver(const Matx33d& camera) { return makePtr<P3PSolver>(camera); }

}  // namespace usacv20
}  // namespace cv
