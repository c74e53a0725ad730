// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/two_view/epipole.hpp"
#include "support/facade.hpp"
#include "two_view/pixels.hpp"

namespace opencv_test {
namespace {

const Matx33d CAMERA(800, 0, 500, 0, 800, 350, 0, 0, 1);

Vec3d pointOfScene(RNG& rng, bool& window)
{
    const double kind = rng.uniform(0., 1.);
    window = kind < 0.6;
    if (window)
        return Vec3d(rng.uniform(0, 12) - 5.5 + rng.uniform(-0.3, 0.3),
                     0.9 * rng.uniform(0, 6) - 3 + rng.uniform(-0.25, 0.25),
                     10 + 0.1 * rng.uniform(0, 3));
    if (kind < 0.8)
        return Vec3d(rng.uniform(-6., 6.), 2.8, rng.uniform(5., 10.));
    const double x = rng.uniform(-5., -2.);
    return Vec3d(x, rng.uniform(-2., 2.5), 7 + 0.3 * (x + 5));
}

Point2d image(const Vec3d& X)
{
    const Vec3d x = CAMERA * X;
    return Point2d(x[0] / x[2], x[1] / x[2]);
}

Point2d noise(RNG& rng)
{
    const double x = rng.gaussian(0.4);
    return Point2d(x, rng.gaussian(0.4));
}

}  // namespace

Facade::Facade(int size, double right, double columns, int seed)
{
    RNG rng(seed);
    Matx31d turn(rng.uniform(-0.05, 0.05), rng.uniform(-0.2, 0.2), rng.uniform(-0.05, 0.05));
    Matx33d R;
    cv::Rodrigues(turn, R);
    const Vec3d t(rng.uniform(-1.5, -0.8), rng.uniform(-0.2, 0.2), rng.uniform(-0.6, 0.6));
    F = CAMERA.inv().t() * crossMatrix(t) * R * CAMERA.inv();
    for (int i = 0; i < size; ++i)
    {
        bool window = false;
        const Vec3d X = pointOfScene(rng, window);
        Vec3d Y = X;
        const double kind = rng.uniform(0., 1.);
        const bool wrong = kind >= right, other = wrong && window && kind < right + columns;
        while (other && (Y[0] == X[0] || std::abs(Y[0]) > 6))
            Y[0] = X[0] + rng.uniform(-11, 12);
        points1.push_back(image(X) + noise(rng));
        points2.push_back(image(R * Y + t) + noise(rng));
        if (wrong && !other)
            points2.back() = Point2d(rng.uniform(0., 1000.), rng.uniform(0., 700.));
        if (!wrong)
        {
            clean1.push_back(image(X));
            clean2.push_back(image(R * X + t));
        }
    }
}

double Facade::error(const Mat& model) const
{
    if (model.empty())
        return 1e9;
    double sum = 0;
    for (double distance : sampsonDistances(model, clean1, clean2))
        sum += distance * distance;
    return std::sqrt(sum / (double)clean1.size());
}

}  // namespace opencv_test
