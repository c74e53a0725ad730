// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_RANDOM_ROTATION_HPP
#define OPENCV_USACV20_TEST_RANDOM_ROTATION_HPP

#include "opencv2/core.hpp"

namespace opencv_test {

//! A random rotation, uniformly distributed among all rotations.
inline cv::Matx33d randomRotation(cv::RNG& rng)
{
    cv::Vec4d q;
    for (int i = 0; i < 4; ++i)
        q[i] = rng.gaussian(1);
    q *= 1 / cv::norm(q);
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    return cv::Matx33d(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
                       2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                       2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y));
}

}  // namespace opencv_test

#endif
