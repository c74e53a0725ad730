// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "random_geometry.hpp"

#include "opencv2/usac/geometry.hpp"

namespace benchmark {

cv::Vec3d randomDirection(cv::RNG& rng)
{
    cv::Vec3d v;
    do
        v = cv::Vec3d(rng.uniform(-1., 1.), rng.uniform(-1., 1.), rng.uniform(-1., 1.));
    while (cv::norm(v) > 1 || cv::norm(v) < 0.1);
    return v * (1 / cv::norm(v));
}

cv::Matx33d rotationAbout(const cv::Vec3d& axis, double degrees)
{
    cv::Matx33d R;
    cv::Rodrigues(axis * (degrees * CV_PI / 180), R);
    return R;
}

std::vector<int> shuffled(int size, cv::RNG& rng)
{
    std::vector<int> order(size);
    for (int i = 0; i < size; ++i)
    {
        order[i] = i;
        std::swap(order[i], order[rng.uniform(0, i + 1)]);
    }
    return order;
}

}  // namespace benchmark
