// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_DIRECTED_NOISE_HPP
#define OPENCV_USACV20_TEST_DIRECTED_NOISE_HPP

#include "significance/model_cases.hpp"

// Scenes for tests of covariances of points, given as Params::sigmas.

namespace opencv_test {
namespace {

//! Coefficients of a strong lens distortion: the derivative of the undistorted point with respect
//! to the distorted point differs from the unit matrix by up to a third.
const double LENS[] = {-0.25, 0.1, 0.002, -0.001, 0.02};

//! The smaller of the two standard deviations of the noise of a point in an image, in pixels.
constexpr double SMALL_NOISE = 0.2;

//! A covariance with standard deviations `a` and `b` in two directions at right angles. `angle` is
//! the angle between the direction of `a` and the x axis, in radians.
inline Matx22d ellipse(double a, double b, double angle)
{
    const Matx22d turn(std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle));
    return turn * Matx22d(a * a, 0, 0, b * b) * turn.t();
}

inline void append(std::vector<float>& sigmas, const Matx22d& covariance)
{
    sigmas.push_back((float)covariance(0, 0));
    sigmas.push_back((float)covariance(0, 1));
    sigmas.push_back((float)covariance(1, 1));
}

inline Vec2d gaussian(const Matx22d& covariance, RNG& rng)
{
    const double p = std::sqrt(covariance(0, 0)), q = covariance(0, 1) / p;
    const double first = rng.gaussian(1);
    return Vec2d(p * first, q * first + std::sqrt(covariance(1, 1) - q * q) * rng.gaussian(1));
}

//! A scene whose points have Gaussian noise, each with a covariance of its own. The ratio of the
//! standard deviations along the two axes of the covariance ellipse is 10 in image 2 and 2 in image
//! 1, if there is noise in image 1.
struct Directed
{
    //! @param both_ true: noise in both images; false, or for poses: noise in image 2 only
    Directed(ProblemType problem, int seed, bool both_)
        : scene(makeCase(problem, seed, 100, 0.01)), both(both_ && problem != ABSOLUTE_POSE)
    {
        RNG rng(seed);
        for (int i = 0; i < scene.points2.rows; ++i)
        {
            second.push_back(ellipse(SMALL_NOISE, 10 * SMALL_NOISE, rng.uniform(0., CV_PI)));
            first.push_back(ellipse(2 * SMALL_NOISE, SMALL_NOISE, rng.uniform(0., CV_PI)));
            disturb(scene.points2, i, second[i], rng);
            append(sigmas, second[i]);
            if (!both)
                continue;
            disturb(scene.points1, i, first[i], rng);
            append(sigmas, first[i]);
        }
    }

    static void disturb(Mat& points, int row, const Matx22d& covariance, RNG& rng)
    {
        const Vec2d off = gaussian(covariance, rng);
        for (int k = 0; k < 2; ++k)
            points.ptr<double>(row)[k] += off[k];
    }

    Ptr<Usac> create(Params params, double threshold, bool noise) const
    {
        params.threshold = threshold;
        if (noise)
            params.sigmas = sigmas;
        return Usac::create(scene.problem, scene.points1, scene.points2, params, scene.camera);
    }

    Case scene;
    const bool both;
    std::vector<Matx22d> first, second;
    std::vector<float> sigmas;
};

}  // namespace
}  // namespace opencv_test

#endif
