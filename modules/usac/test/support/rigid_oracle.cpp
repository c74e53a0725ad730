// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/rigid_oracle.hpp"
#include "support/bounded.hpp"

using cv::format;
using cv::Mat;
using cv::Matx33d;
using cv::Point3d;

namespace opencv_test {

namespace {

bool finite(const Point3d& X)
{
    return std::abs(X.x) <= DBL_MAX && std::abs(X.y) <= DBL_MAX && std::abs(X.z) <= DBL_MAX;
}

Bounded distance(const double* motion, const Point3d& from, const Point3d& to)
{
    const double target[] = {to.x, to.y, to.z};
    Bounded sum;
    for (int row = 0; row < 3; ++row)
    {
        const double* const m = motion + 4 * row;
        const Bounded off = Bounded(m[0]) * from.x + Bounded(m[1]) * from.y +
                            Bounded(m[2]) * from.z + m[3] - target[row];
        sum = sum + off * off;
    }
    return squareRoot(sum);
}

std::string brokenRotation(const EstimatorCall& call, const Mat& model)
{
    const Matx33d A(model.colRange(0, 3));
    double largest = 0;
    for (int k = 0; k < 9; ++k)
        largest = std::max(largest, std::abs(A.val[k]));
    if (!(largest > 0))
        return "the linear part is zero";
    const Matx33d unit = A * (1 / largest);  // so that squares neither overflow nor all underflow
    const double scale = cv::norm(unit) / std::sqrt(3.);
    const Matx33d R = unit * (1 / scale);
    const double off = cv::norm(R * R.t() - Matx33d::eye(), cv::NORM_INF);
    if (!(off <= 1e-9) || !(cv::determinant(R) > 0))
        return format("not a rotation: |R R^T - I| is %g, the determinant %g", off,
                      cv::determinant(R));
    if (call.problem == cv::usacv20::RIGID_3D && !(std::abs(scale * largest - 1) <= 1e-9))
        return format("the scale of a rigid motion is %.17g", scale * largest);
    return "";
}

}  // namespace

std::string brokenMotion(const EstimatorCall& call, double threshold, const Mat& model,
                         const Mat& mask)
{
    if (model.size() != cv::Size(4, 3) || model.type() != CV_64FC1)
        return format("the motion is %d x %d, type %d", model.rows, model.cols, model.type());
    if (!cv::checkRange(model))
        return "the motion is not finite";
    const std::string broken = brokenRotation(call, model);
    if (!broken.empty())
        return broken;
    const Bounded limit(threshold, UNIT * threshold);
    for (int i = 0; i < mask.rows; ++i)
    {
        const int given = mask.at<uchar>(i);
        if (given > 1)
            return format("row %d of the mask is %d", i, given);
        if (!finite(call.object[i]) || !finite(call.space2[i]))
        {
            if (given)
                return format("row %d of the mask is 1, the points are not finite", i);
            continue;
        }
        const Bounded error = distance(model.ptr<double>(), call.object[i], call.space2[i]);
        const bool decided = std::abs(error.value - limit.value) >
                             error.error + limit.error;  // false if the error is NaN
        if (decided && (given != 0) != (error.value <= limit.value))
            return format("row %d of the mask is %d, the error %.17Lg, the threshold %.17Lg", i,
                          given, error.value, limit.value);
    }
    return "";
}

}  // namespace opencv_test
