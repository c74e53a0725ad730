// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "epipolar.hpp"

#include <algorithm>
#include <limits>
#include "opencv2/usac/geometry.hpp"
#include "squared_errors.hpp"

namespace benchmark {

namespace {

double squaredSampsonDistance(const cv::Matx33d& F, const cv::Point2d& point1,
                              const cv::Point2d& point2)
{
    const cv::Vec3d x1 = homogeneous(point1), x2 = homogeneous(point2);
    const cv::Vec3d line2 = F * x1, line1 = F.t() * x2;
    const double algebraic = x2.dot(line2);
    return algebraic * algebraic /
           (line1[0] * line1[0] + line1[1] * line1[1] + line2[0] * line2[0] + line2[1] * line2[1]);
}

struct Rays
{
    std::vector<cv::Vec3d> rays1, rays2;
};

//! Viewing rays of the inliers; of all correspondences if the mask has no inliers, or if it is not
//! a mask of type CV_8U with one entry for each correspondence.
Rays raysOf(const ImagePair& pair, const cv::Mat& mask)
{
    const cv::Matx33d inverse1 = pair.K1.inv(), inverse2 = pair.K2.inv();
    const bool all = mask.type() != CV_8UC1 || mask.total() != pair.points1.size() ||
                     cv::countNonZero(mask) == 0;
    Rays result;
    for (size_t i = 0; i < pair.points1.size(); ++i)
    {
        if (!all && !mask.at<uchar>((int)i))
            continue;
        result.rays1.push_back(inverse1 * homogeneous(pair.points1[i]));
        result.rays2.push_back(inverse2 * homogeneous(pair.points2[i]));
    }
    return result;
}

//! Number of correspondences whose depths a (camera 1) and b (camera 2) are both positive. For
//! viewing rays x1, x2 with the third entry 1, it follows from a R x1 + t = b x2 that
//! a cross(R x1, x2) = cross(x2, t) and b cross(R x1, x2) = cross(R x1, t).
int countInFront(const Rays& rays, const cv::Matx33d& R, const cv::Vec3d& t)
{
    int count = 0;
    for (size_t i = 0; i < rays.rays1.size(); ++i)
    {
        const cv::Vec3d x1 = R * rays.rays1[i], x2 = rays.rays2[i];
        const cv::Vec3d normal = x1.cross(x2);
        count += normal.dot(x2.cross(t)) > 0 && normal.dot(x1.cross(t)) > 0;
    }
    return count;
}

}  // namespace

double Epipolar::modelError(const ImagePair& pair, const cv::Mat& model) const
{
    cv::Matx33d M;
    if (!toMatrix(model, M))
        return std::numeric_limits<double>::infinity();
    const cv::Matx33d F = toFundamental(pair, M);
    return rootOfMean((int)pair.truth1.size(), [&](int i) {
        return squaredSampsonDistance(F, pair.truth1[i], pair.truth2[i]);
    });
}

double Epipolar::failureLimit(const ImagePair& pair) const
{
    return 0.01 * 0.5 * (diagonal(pair.size1) + diagonal(pair.size2));
}

double Epipolar::modelCost(const ImagePair& pair, const cv::Mat& model, double threshold_) const
{
    cv::Matx33d M;
    if (!toMatrix(model, M))
        return 1;
    const cv::Matx33d F = toFundamental(pair, M);
    return truncatedMean(pair.size(), threshold_, [&](int i) {
        return squaredSampsonDistance(F, pair.points1[i], pair.points2[i]);
    });
}

double Epipolar::poseError(const ImagePair& pair, const Estimate& estimate) const
{
    if (!pair.hasPose)
        return -1;
    cv::Matx33d E;
    if (!toMatrix(estimate.model, E) || cv::norm(E) == 0)
        return 180;
    E = toEssential(pair, E);

    cv::Matx33d rotations[2];
    cv::Vec3d translation;
    cv::decomposeEssentialMat(E, rotations[0], rotations[1], translation);
    const Rays rays = raysOf(pair, estimate.mask);
    double error = 180;
    int most = -1;
    for (int i = 0; i < 4; ++i)
    {
        const cv::Matx33d& R = rotations[i / 2];
        const cv::Vec3d t = i % 2 ? -translation : translation;
        const int count = countInFront(rays, R, t);
        if (count <= most)
            continue;
        most = count;
        error = std::max(angleBetween(R, pair.R), angleBetween(t, pair.t));
    }
    return error;
}

}  // namespace benchmark
