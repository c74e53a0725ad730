// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/result_oracle.hpp"
#include "support/bounded.hpp"
#include "support/lens_oracle.hpp"
#include "support/pose_oracle.hpp"
#include "support/rigid_oracle.hpp"
#include "support/scene_geometry.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

using namespace cv::usacv20;
using cv::Mat;
using cv::Matx33d;
using cv::Point2d;
using cv::format;

namespace opencv_test {

namespace {

struct BoundedPoint
{
    Bounded x, y;
    LensOracle::Answer seen;
};

bool finite(const Point2d& p) { return std::abs(p.x) <= DBL_MAX && std::abs(p.y) <= DBL_MAX; }

//! Multiplies M by the homogeneous vector (x, y, 1) of the point.
void multiply(const Bounded* M, const BoundedPoint& point, Bounded* result)
{
    for (int i = 0; i < 3; ++i)
        result[i] = M[3 * i] * point.x + M[3 * i + 1] * point.y + M[3 * i + 2];
}

BoundedPoint project(const Bounded* M, const BoundedPoint& point)
{
    Bounded p[3];
    multiply(M, point, p);
    const BoundedPoint result = {p[0] / p[2], p[1] / p[2], LensOracle::SEEN};
    return result;
}

//! The adjugate of m, which is its inverse up to a factor.
void adjugate(const Bounded* m, Bounded* a)
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
        {
            const int r = (j + 1) % 3, s = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
            a[3 * i + j] = m[3 * r + c] * m[3 * s + d] - m[3 * r + d] * m[3 * s + c];
        }
}

Bounded squaredDistance(const BoundedPoint& a, const BoundedPoint& b)
{
    const Bounded x = a.x - b.x, y = a.y - b.y;
    return x * x + y * y;
}

Bounded modelError(const EstimatorCall& call, const Bounded* M, const BoundedPoint& p1,
                   const BoundedPoint& p2)
{
    const bool symmetric = call.params.residual == RESIDUAL_SYMMETRIC;
    Bounded other[9];
    if (mapsPoints(call.problem))
    {
        adjugate(M, other);
        const Bounded there = squaredDistance(project(M, p1), p2);
        return squareRoot(symmetric ? there + squaredDistance(project(other, p2), p1) : there);
    }
    for (int i = 0; i < 9; ++i)
        other[i] = M[i % 3 * 3 + i / 3];
    Bounded line2[3], line1[3];
    multiply(M, p1, line2);
    multiply(other, p2, line1);
    const Bounded r = p2.x * line2[0] + p2.y * line2[1] + line2[2], one(1);
    const Bounded n1 = line1[0] * line1[0] + line1[1] * line1[1],
                  n2 = line2[0] * line2[0] + line2[1] * line2[1];
    return squareRoot(symmetric ? r * r * (one / n1 + one / n2) : r * r / (n1 + n2));
}

//! Points of one image in the coordinates in which the errors of the problem are computed: with a
//! camera, on the normalized image plane without distortion; otherwise unchanged. A point that the
//! lens does not show has `seen` == NOT_SEEN.
std::vector<BoundedPoint> imagePoints(const std::vector<Point2d>& points, const Mat& camera,
                                      const Mat& distortion)
{
    std::vector<BoundedPoint> result(points.size());
    for (size_t i = 0; i < points.size(); ++i)
    {
        result[i].x = Bounded(points[i].x);
        result[i].y = Bounded(points[i].y);
        result[i].seen = LensOracle::SEEN;
    }
    if (camera.empty() || points.empty())
        return result;
    Bounded K[9], inverse[9];
    for (int i = 0; i < 9; ++i)
        K[i] = Bounded(camera.at<double>(i / 3, i % 3));
    adjugate(K, inverse);
    const LensOracle lens(distortion);
    const bool distorted = !distortion.empty() && cv::countNonZero(distortion) > 0;
    for (size_t i = 0; i < points.size(); ++i)
    {
        result[i] = project(inverse, result[i]);
        if (distorted && finite(points[i]))
            result[i].seen = lens.invert(result[i].x, result[i].y);
    }
    return result;
}

//! Half of 1 / f, where f is the mean of the two focal lengths. K is allowed to be a multiple of
//! the camera matrix whose last row is 0 0 1.
Bounded halfPixel(const Mat& K)
{
    return Bounded(std::abs(K.at<double>(2, 2))) /
           (Bounded(std::abs(K.at<double>(0, 0))) + Bounded(std::abs(K.at<double>(1, 1))));
}

std::string brokenMask(const EstimatorCall& call, double threshold, const Matx33d& model,
                       const Mat& mask)
{
    const Mat &K1 = call.K1, &K2 = call.K2.empty() ? K1 : call.K2;
    Bounded limit(threshold, UNIT * threshold), M[9];
    if (call.problem == ESSENTIAL)
        limit = limit * (halfPixel(K1) + halfPixel(K2));
    for (int i = 0; i < 9; ++i)
        M[i] = Bounded(model.val[i]);
    const std::vector<BoundedPoint> points1 = imagePoints(call.points1, K1, call.d1);
    const std::vector<BoundedPoint> points2 = imagePoints(call.points2, K2, call.d2);
    for (int i = 0; i < mask.rows; ++i)
    {
        const bool inlier = mask.at<uchar>(i) != 0;
        if (mask.at<uchar>(i) > 1)
            return format("row %d of the mask is %d", i, mask.at<uchar>(i));
        if (!finite(call.points1[i]) || !finite(call.points2[i]))
        {
            if (inlier)
                return format("row %d is an inlier, but not finite", i);
            continue;
        }
        if (points1[i].seen == LensOracle::NOT_SEEN || points2[i].seen == LensOracle::NOT_SEEN)
        {
            if (inlier)
                return format("row %d is an inlier, but a lens does not show its point", i);
            continue;
        }
        if (points1[i].seen == LensOracle::UNDECIDED || points2[i].seen == LensOracle::UNDECIDED)
            continue;
        const Bounded error = modelError(call, M, points1[i], points2[i]);
        const bool decided = std::abs(error.value - limit.value) >
                             error.error + limit.error;  // false if the error is NaN
        if (decided && inlier != (error.value <= limit.value))
            return format("row %d of the mask is %d, the error %.17Lg, the threshold %.17Lg", i,
                          (int)inlier, error.value, limit.value);
    }
    return "";
}

std::string brokenModel(ProblemType problem, const Matx33d& M)
{
    for (int i = 0; i < 9; ++i)
        if (!(std::abs(M.val[i]) <= DBL_MAX))
            return "the model is not finite";
    const double size = cv::norm(M);
    if (problem == SIMILARITY && (M(0, 0) != M(1, 1) || M(0, 1) != -M(1, 0)))
        return format("%g %g, %g %g is not a rotation with a scale", M(0, 0), M(0, 1), M(1, 0),
                      M(1, 1));
    if (problem == TRANSLATION_2D && (M(0, 0) != 1 || M(0, 1) != 0 || M(1, 0) != 0 || M(1, 1) != 1))
        return format("%g %g, %g %g is not 1 0, 0 1", M(0, 0), M(0, 1), M(1, 0), M(1, 1));
    if (isAffine(problem))
        return M(0, 0) != 0 || M(0, 1) != 0 || M(1, 0) != 0 || M(1, 1) != 0
                   ? ""
                   : "the model is of rank 0";
    if (problem == HOMOGRAPHY)
        return M(2, 2) == 1 || std::abs(size - 1) < 1e-12
                   ? ""
                   : format("h33 is %g, the norm of H %g", M(2, 2), size);
    Mat w;
    cv::SVD::compute(Mat(M), w, cv::SVD::NO_UV);
    const double* s = w.ptr<double>();
    if (std::abs(size - 1) > 1e-12)
        return format("the norm of the model is %.17g", size);
    if (s[2] > 1e-10 || !(s[1] > 0))
        return format("the rank is not 2: singular values %g, %g, %g", s[0], s[1], s[2]);
    if (problem == ESSENTIAL && std::abs(s[0] - s[1]) > 1e-10)
        return format("E has unequal singular values %.17g, %.17g", s[0], s[1]);
    return "";
}

std::string brokenReport(const Report& report, int inliers)
{
    const bool right = !report.describe().empty() && report.inliers == inliers &&
                       report.cost >= 0 && report.cost <= 1 && report.chance >= 0 &&
                       report.chance <= 1 && report.threshold > 0 && report.threshold <= DBL_MAX &&
                       report.independentInliers >= 0 &&
                       report.independentInliers <= inliers;  // false if a number is NaN
    return right ? ""
                 : format("%d inliers in the mask; cost %g, chance %g, threshold %g, %d "
                          "independent inliers; ",
                          inliers, report.cost, report.chance, report.threshold,
                          report.independentInliers) +
                       report.describe();
}

}  // namespace

std::string brokenResult(const EstimatorCall& call, const Mat& model, const Mat& mask,
                         const Report& report)
{
    const bool pose = call.problem == ABSOLUTE_POSE;
    const bool space = call.problem == RIGID_3D || call.problem == SIMILARITY_3D;
    const int count = (int)(pose || space ? call.object.size() : call.points1.size());
    if (mask.rows != count || (count > 0 && (mask.cols != 1 || mask.type() != CV_8UC1)))
        return format("the mask is %d x %d, type %d", mask.rows, mask.cols, mask.type());
    const int inliers = count ? cv::countNonZero(mask) : 0;
    std::string broken = brokenReport(report, inliers);
    if (!broken.empty())
        return broken;
    if (model.empty())
    {
        const bool reason = report.stop == STOP_TOO_FEW_POINTS || report.stop == STOP_NO_MODEL ||
                            report.stop == STOP_NOT_SIGNIFICANT ||
                            (report.stop == STOP_TIME && call.params.maxTime > 0);
        return inliers > 0 ? "the mask has inliers, but there is no model"
               : reason    ? ""
                           : "there is no model, but Report::stop does not say why";
    }
    if (report.stop < STOP_MAX_ITERATIONS ||
        (inliers == 0 && call.params.widestReach <= call.params.reach))
        return "there is a model, but the mask has no inliers or Report::stop denies the model: " +
               report.describe();
    if (!findsThreshold(call.params) &&
        std::abs(report.threshold / call.params.threshold - 1) > 1e-12)
        return format("the threshold is %.17g", report.threshold);
    if (pose)
        return brokenPose(call, report.threshold, model, mask);
    if (space)
        return brokenMotion(call, report.threshold, model, mask);
    const int rows = isAffine(call.problem) ? 2 : 3;
    if (model.size() != cv::Size(3, rows) || model.type() != CV_64FC1)
        return format("the model is %d x %d, type %d", model.rows, model.cols, model.type());
    const Matx33d M = squareModel(model);
    broken = brokenModel(call.problem, M);
    return broken.empty() ? brokenMask(call, report.threshold, M, mask) : broken;
}

}  // namespace opencv_test
