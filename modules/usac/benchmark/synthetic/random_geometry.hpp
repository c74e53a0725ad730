// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_RANDOM_GEOMETRY_HPP
#define OPENCV_USACV20_BENCHMARK_RANDOM_GEOMETRY_HPP

#include <vector>
#include "opencv2/core.hpp"

namespace benchmark {

//! A random vector of unit length.
cv::Vec3d randomDirection(cv::RNG& rng);

//! The matrix of a rotation. @param axis vector of unit length
cv::Matx33d rotationAbout(const cv::Vec3d& axis, double degrees);

//! The numbers 0 to size - 1 in random order.
std::vector<int> shuffled(int size, cv::RNG& rng);

/** Makes the matches of a scene in random order.
@param duplicates number of right matches that are copies of other right matches
@param inliers, outliers numbers of right matches (with the copies) and of wrong matches
@param make `make(row, i)` makes a match: a right one if i < 0, otherwise the i-th wrong one
@param copy `copy(row, from)` makes a match that repeats the match in the row `from`
@return for each row, 1 if it is right */
template <class Make, class Copy>
std::vector<uchar> makeRows(int inliers, int outliers, int duplicates, cv::RNG& rng,
                            const Make& make, const Copy& copy)
{
    const int size = inliers + outliers, own = inliers - duplicates;
    CV_Assert(own > 0);
    const std::vector<int> order = shuffled(size, rng);
    std::vector<uchar> truth(size);
    for (int i = 0; i < size; ++i)
    {
        truth[order[i]] = i < inliers;
        if (i >= own && i < inliers)
            copy(order[i], order[rng.uniform(0, own)]);
        else
            make(order[i], i < own ? -1 : i - inliers);
    }
    return truth;
}

}  // namespace benchmark

#endif
