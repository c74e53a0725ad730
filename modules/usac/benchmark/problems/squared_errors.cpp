// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "squared_errors.hpp"

#include <algorithm>

namespace benchmark {

bool toMatrix(const cv::Mat& model, cv::Matx33d& matrix)
{
    if (model.cols != 3 || model.rows < 3)
        return false;
    cv::Mat converted;
    model.rowRange(0, 3).convertTo(converted, CV_64F);
    matrix = cv::Matx33d((const double*)converted.data);
    for (int i = 0; i < 9; ++i)
        if (!std::isfinite(matrix.val[i]))
            return false;
    return true;
}

bool toMotion(const cv::Mat& model, cv::Matx33d& A, cv::Vec3d& t)
{
    if (model.rows != 3 || model.cols != 4)
        return false;
    cv::Mat right;
    model.col(3).convertTo(right, CV_64F);
    for (int i = 0; i < 3; ++i)
        t[i] = right.at<double>(i);
    return toMatrix(model.colRange(0, 3), A) && std::isfinite(t[0] + t[1] + t[2]);
}

double angleBetween(const cv::Matx33d& R1, const cv::Matx33d& R2)
{
    return 2 * std::asin(std::min(1., cv::norm(R1 - R2) / (2 * std::sqrt(2.)))) * 180 / CV_PI;
}

double angleBetween(const cv::Vec3d& a, const cv::Vec3d& b)
{
    return std::atan2(cv::norm(a.cross(b)), a.dot(b)) * 180 / CV_PI;
}

}  // namespace benchmark
