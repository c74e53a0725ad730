// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "pose_samples.hpp"
#include "problems/random_rotation.hpp"
#include "support/random_points.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace opencv_test {

using namespace cv;

const char* const POSE_SAMPLE_NAMES[POSE_SAMPLE_KINDS] = {"cube",
                                                          "frontal plane",
                                                          "near plane",
                                                          "depth 100 times the size",
                                                          "depth 10 000 times the size",
                                                          "close",
                                                          "5 degrees",
                                                          "120 degrees",
                                                          "flat triangle"};

namespace {

Vec3d randomPoint(PoseSampleKind kind, RNG& rng)
{
    const double x = rng.uniform(-1., 1.), y = rng.uniform(-1., 1.), z = rng.uniform(-1., 1.);
    switch (kind)
    {
    case FRONTAL_PLANE: return Vec3d(x, y, 3);
    case NEAR_PLANE: return Vec3d(x, y, 3 + 1e-4 * z);
    case FAR_AWAY: return Vec3d(x, y, 200 + z);
    case VERY_FAR: return Vec3d(x, y, 20000 + z);
    case CLOSE: return Vec3d(x, y, 0.505 + 0.495 * z);
    case NARROW:
    case WIDE:
    {
        const double slope = std::tan((kind == NARROW ? 2.5 : 60) * CV_PI / 180);
        return Vec3d(x * slope, y * slope, 1) * (2 + z);
    }
    default: return Vec3d(x, y, 3 + z);
    }
}

}  // namespace

PoseSample poseSampleOf(const Vec3d (&Y)[3], RNG& rng)
{
    PoseSample s;
    const Matx33d R = randomRotation(rng);
    const Vec3d mean = (Y[0] + Y[1] + Y[2]) * (1. / 3);
    s.size = std::max(std::max(cv::norm(Y[0] - mean), cv::norm(Y[1] - mean)),
                      cv::norm(Y[2] - mean));
    const Vec3d t = mean + s.size * uniformVector(rng, -1., 1.);
    hconcat(R, t, s.pose);
    for (int i = 0; i < 3; ++i)
    {
        s.X[i] = R.t() * (Y[i] - t);
        long double seen[3];
        for (int r = 0; r < 3; ++r)
        {
            seen[r] = t[r];
            for (int c = 0; c < 3; ++c)
                seen[r] += (long double)R(r, c) * s.X[i][c];
        }
        s.image[i] = Point2d((double)(seen[0] / seen[2]), (double)(seen[1] / seen[2]));
    }
    return s;
}

double flatness(const Vec3d (&Y)[3])
{
    double result = 90;
    for (int i = 0; i < 3; ++i)
    {
        const Vec3d a = Y[(i + 1) % 3] - Y[i], b = Y[(i + 2) % 3] - Y[i];
        const double angle = std::atan2(cv::norm(a.cross(b)), a.dot(b)) * 180 / CV_PI;
        result = std::min(result, std::min(angle, 180 - angle));
    }
    return result;
}

PoseSample randomPoseSample(PoseSampleKind kind, RNG& rng)
{
    Vec3d Y[3];
    do
    {
        for (int i = 0; i < 3; ++i)
            Y[i] = randomPoint(kind, rng);
        // the third point is nearly on the line segment between the other two
        if (kind == FLAT_TRIANGLE)
        {
            const Vec3d side = Y[1] - Y[0];
            Vec3d up = side.cross(Y[2] - Y[0]);
            up *= cv::norm(side) / cv::norm(up);
            const double at = rng.uniform(0.1, 0.9),
                         slope = std::tan(rng.uniform(1., 2.) * CV_PI / 180);
            Y[2] = Y[0] + side * at + up * (std::max(at, 1 - at) * slope);
        }
    } while (flatness(Y) < 1);
    return poseSampleOf(Y, rng);
}

PoseSample triangleSeenFrom(const Vec3d& center, const double (&angles)[3], RNG& rng)
{
    const Vec3d forward = -center * (1 / cv::norm(center));
    Vec3d right = forward.cross(Vec3d(0.3, 0.8, 0.5));
    right *= 1 / cv::norm(right);
    const Vec3d down = forward.cross(right);
    Vec3d Y[3];
    for (int i = 0; i < 3; ++i)
    {
        const Vec3d x = Vec3d(std::cos(angles[i]), std::sin(angles[i]), 0) - center;
        Y[i] = Vec3d(right.dot(x), down.dot(x), forward.dot(x));
    }
    return poseSampleOf(Y, rng);
}

double reprojectionError(const PoseSample& s, const Matx34d& pose)
{
    double largest = 0;
    for (int i = 0; i < 3; ++i)
    {
        const Vec3d y = pose * Vec4d(s.X[i][0], s.X[i][1], s.X[i][2], 1);
        const double error = cv::norm(Point2d(y[0] / y[2], y[1] / y[2]) - s.image[i]);
        largest = std::max(largest, y[2] > 0 && error == error ? error : DBL_MAX);
    }
    return largest;
}

double poseDistance(const PoseSample& s, const Matx34d& a, const Matx34d& b)
{
    const Matx34d d = a - b;
    return std::max(cv::norm(d.get_minor<3, 3>(0, 0)), cv::norm(d.col(3)) / s.size);
}

}  // namespace opencv_test
