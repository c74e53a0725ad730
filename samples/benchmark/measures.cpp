// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include "opencv2/calib3d.hpp"

namespace benchmark {

namespace {

const double NO_MODEL = std::numeric_limits<double>::infinity();

//! The model in double. A function that returns several stacked models is held to the first.
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

cv::Vec3d homogeneous(const cv::Point2d& point) { return cv::Vec3d(point.x, point.y, 1); }

cv::Point2d map(const cv::Matx33d& H, const cv::Point2d& point)
{
    const cv::Vec3d p = H * homogeneous(point);
    return cv::Point2d(p[0] / p[2], p[1] / p[2]);
}

double squaredTransferError(const cv::Matx33d& H, const cv::Point2d& point1, const cv::Point2d& point2)
{
    const cv::Point2d d = map(H, point1) - point2;
    return d.dot(d);
}

double squaredSampsonDistance(const cv::Matx33d& F, const cv::Point2d& point1, const cv::Point2d& point2)
{
    const cv::Vec3d x1 = homogeneous(point1), x2 = homogeneous(point2);
    const cv::Vec3d line2 = F * x1, line1 = F.t() * x2;
    const double algebraic = x2.dot(line2);
    return algebraic * algebraic /
           (line1[0] * line1[0] + line1[1] * line1[1] + line2[0] * line2[0] + line2[1] * line2[1]);
}

//! In pixels: E becomes F.
bool toPixels(const ImagePair& pair, ProblemType problem, const cv::Mat& model, cv::Matx33d& M)
{
    if (!toMatrix(model, M))
        return false;
    if (problem == cv::usacv20::ESSENTIAL)
        M = pair.K2.inv().t() * M * pair.K1.inv();
    return true;
}

double squaredError(ProblemType problem, const cv::Matx33d& M, const cv::Point2d& point1, const cv::Point2d& point2)
{
    return problem == cv::usacv20::HOMOGRAPHY ? squaredTransferError(M, point1, point2)
                                              : squaredSampsonDistance(M, point1, point2);
}

double diagonal(const cv::Size2d& size) { return std::sqrt(size.width * size.width + size.height * size.height); }

struct Rays
{
    std::vector<cv::Vec3d> rays1, rays2;
};

//! Viewing rays of the inliers, of all correspondences if the mask has none.
Rays raysOf(const ImagePair& pair, const cv::Mat& mask)
{
    const cv::Matx33d inverse1 = pair.K1.inv(), inverse2 = pair.K2.inv();
    const bool all = mask.type() != CV_8UC1 || mask.total() != pair.points1.size() || cv::countNonZero(mask) == 0;
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

//! Correspondences with two positive depths a, b. Of a R x1 + t = b x2 follow (Rx1 x x2) a = x2 x t, (Rx1 x x2) b = Rx1
//! x t.
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

//! From the chord |R1 - R2| = 2 sqrt(2) sin(angle / 2), which is exact for small angles, too.
double angleBetween(const cv::Matx33d& R1, const cv::Matx33d& R2)
{
    return 2 * std::asin(std::min(1., cv::norm(R1 - R2) / (2 * std::sqrt(2.)))) * 180 / CV_PI;
}

double angleBetween(const cv::Vec3d& a, const cv::Vec3d& b)
{
    return std::atan2(cv::norm(a.cross(b)), a.dot(b)) * 180 / CV_PI;
}

}  // namespace

double modelError(const ImagePair& pair, ProblemType problem, const cv::Mat& model)
{
    cv::Matx33d M;
    if (!toPixels(pair, problem, model, M))
        return NO_MODEL;
    double sum = 0;
    for (size_t i = 0; i < pair.truth1.size(); ++i)
    {
        const cv::Point2d truth = pair.truthIsHomography ? map(pair.H, pair.truth1[i]) : pair.truth2[i];
        sum += squaredError(problem, M, pair.truth1[i], truth);
    }
    const double error = std::sqrt(sum / pair.truth1.size());
    return std::isfinite(error) ? error : NO_MODEL;
}

double failureLimit(const ImagePair& pair, ProblemType problem)
{
    if (problem == cv::usacv20::HOMOGRAPHY)
        return 0.01 * diagonal(pair.size2);
    return 0.01 * 0.5 * (diagonal(pair.size1) + diagonal(pair.size2));
}

double modelCost(const ImagePair& pair, ProblemType problem, const cv::Mat& model, double threshold)
{
    cv::Matx33d M;
    if (!toPixels(pair, problem, model, M))
        return 1;
    double sum = 0;
    for (size_t i = 0; i < pair.points1.size(); ++i)
    {
        const double cost = squaredError(problem, M, pair.points1[i], pair.points2[i]) / (threshold * threshold);
        sum += cost < 1 ? cost : 1;  // also for NaN
    }
    return sum / pair.points1.size();
}

double poseError(const ImagePair& pair, ProblemType problem, const Estimate& estimate)
{
    cv::Matx33d E;
    if (!toMatrix(estimate.model, E) || cv::norm(E) == 0)
        return 180;
    if (problem == cv::usacv20::FUNDAMENTAL)
        E = pair.K2.t() * E * pair.K1;

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
