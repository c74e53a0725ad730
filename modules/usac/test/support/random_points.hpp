// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_RANDOM_POINTS_HPP
#define OPENCV_USACV20_TEST_RANDOM_POINTS_HPP

#include "opencv2/core.hpp"

namespace opencv_test {

// Random points and vectors, the last coordinate drawn first. Compilers evaluate the arguments of a
// call in different orders, so Point2d(rng.uniform(0., 1.), rng.uniform(0., 1.)) would not be the
// same point with all compilers.

inline cv::Point2d uniformPoint(cv::RNG& rng, double left, double right, double top, double bottom)
{
    const double y = rng.uniform(top, bottom);
    return cv::Point2d(rng.uniform(left, right), y);
}

//! Both coordinates are drawn from the same range.
inline cv::Point2d uniformPoint(cv::RNG& rng, double low, double high)
{
    return uniformPoint(rng, low, high, low, high);
}

//! Both coordinates are integers from `low` to `high` - 1.
inline cv::Point2d integerPoint(cv::RNG& rng, int low, int high)
{
    const int y = rng.uniform(low, high);
    return cv::Point2d(rng.uniform(low, high), y);
}

//! All coordinates are integers from `low` to `high` - 1.
inline cv::Vec3d integerVector(cv::RNG& rng, int low, int high)
{
    cv::Vec3d v;
    for (int k = 2; k >= 0; --k)
        v[k] = rng.uniform(low, high);
    return v;
}

//! Both coordinates have mean 0 and the same standard deviation.
inline cv::Point2d gaussianPoint(cv::RNG& rng, double sigma)
{
    const double y = rng.gaussian(sigma);
    return cv::Point2d(rng.gaussian(sigma), y);
}

inline cv::Vec3d uniformVector(cv::RNG& rng, const cv::Vec3d& low, const cv::Vec3d& high)
{
    cv::Vec3d v;
    for (int k = 2; k >= 0; --k)
        v[k] = rng.uniform(low[k], high[k]);
    return v;
}

//! All coordinates are drawn from the same range.
inline cv::Vec3d uniformVector(cv::RNG& rng, double low, double high)
{
    return uniformVector(rng, cv::Vec3d::all(low), cv::Vec3d::all(high));
}

//! All coordinates have mean 0 and the same standard deviation.
inline cv::Vec3d gaussianVector(cv::RNG& rng, double sigma)
{
    cv::Vec3d v;
    for (int k = 2; k >= 0; --k)
        v[k] = rng.gaussian(sigma);
    return v;
}

}  // namespace opencv_test

#endif
