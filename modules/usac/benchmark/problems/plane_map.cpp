// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "plane_map.hpp"

#include <limits>
#include "squared_errors.hpp"

namespace benchmark {

namespace {

//! Converts a model of `rows` rows to a map of homogeneous points; a model of two rows gets the
//! third row 0 0 1. @return false if the shape is wrong or a value is not finite.
bool toMap(const cv::Mat& model, int rows, cv::Matx33d& M)
{
    if (rows == 3)
        return toMatrix(model, M);
    if (model.rows != rows)
        return false;
    cv::Mat whole = cv::Mat::eye(3, 3, CV_64F);
    model.convertTo(whole.rowRange(0, rows), CV_64F);
    return toMatrix(whole, M);
}

cv::Point2d map(const cv::Matx33d& M, const cv::Point2d& point)
{
    const cv::Vec3d p = M * homogeneous(point);
    return cv::Point2d(p[0] / p[2], p[1] / p[2]);
}

double squaredTransferError(const cv::Matx33d& M, const cv::Point2d& point1,
                            const cv::Point2d& point2)
{
    const cv::Point2d d = map(M, point1) - point2;
    return d.dot(d);
}

}  // namespace

double PlaneMap::modelError(const ImagePair& pair, const cv::Mat& model) const
{
    cv::Matx33d M;
    if (!toMap(model, modelSize.height, M))
        return std::numeric_limits<double>::infinity();
    return rootOfMean((int)pair.truth1.size(), [&](int i) {
        const cv::Point2d truth = pair.truthIsHomography ? map(pair.H, pair.truth1[i])
                                                         : pair.truth2[i];
        return squaredTransferError(M, pair.truth1[i], truth);
    });
}

double PlaneMap::failureLimit(const ImagePair& pair) const { return 0.01 * diagonal(pair.size2); }

double PlaneMap::modelCost(const ImagePair& pair, const cv::Mat& model, double threshold_) const
{
    cv::Matx33d M;
    if (!toMap(model, modelSize.height, M))
        return 1;
    return truncatedMean(pair.size(), threshold_, [&](int i) {
        return squaredTransferError(M, pair.points1[i], pair.points2[i]);
    });
}

}  // namespace benchmark
