// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SQUARED_ERRORS_HPP
#define OPENCV_USACV20_BENCHMARK_SQUARED_ERRORS_HPP

#include <cmath>
#include <limits>
#include "opencv2/core.hpp"

namespace benchmark {

//! Converts a model with three columns to double. Only the first three rows are used, since some
//! functions return several stacked models. @return false if the shape is wrong or a value is not
//! finite.
bool toMatrix(const cv::Mat& model, cv::Matx33d& matrix);

//! Converts the 3x4 model [A | t] to double. @return false if the shape is wrong or a value is not
//! finite.
bool toMotion(const cv::Mat& model, cv::Matx33d& A, cv::Vec3d& t);

inline cv::Vec3d homogeneous(const cv::Point2d& point) { return cv::Vec3d(point.x, point.y, 1); }

inline double diagonal(const cv::Size2d& size)
{
    return std::sqrt(size.width * size.width + size.height * size.height);
}

//! Root mean square of errors, given their squares `errorOf(i)`; infinite if the result is not
//! finite.
template <class Error>
double rootOfMean(int count, const Error& errorOf)
{
    double sum = 0;
    for (int i = 0; i < count; ++i)
        sum += errorOf(i);
    const double error = std::sqrt(sum / count);
    return std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
}

//! Mean of min(1, squared error / threshold^2), given the squared errors `errorOf(i)`.
template <class Error>
double truncatedMean(int count, double threshold, const Error& errorOf)
{
    double sum = 0;
    for (int i = 0; i < count; ++i)
    {
        const double cost = errorOf(i) / (threshold * threshold);
        sum += cost < 1 ? cost : 1;  // NaN costs 1, too
    }
    return sum / count;
}

//! Angle in degrees between two rotations, or between two vectors; accurate for small angles, too.
//! For rotations it follows from |R1 - R2| = 2 sqrt(2) sin(angle / 2).
double angleBetween(const cv::Matx33d& R1, const cv::Matx33d& R2);
double angleBetween(const cv::Vec3d& a, const cv::Vec3d& b);

}  // namespace benchmark

#endif
