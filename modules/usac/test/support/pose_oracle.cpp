// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/pose_oracle.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include "opencv2/usac/geometry.hpp"
#include "support/lens_oracle.hpp"

using cv::format;
using cv::Mat;
using cv::Matx33d;
using cv::Matx34d;
using cv::Point2d;
using cv::Point3d;
using cv::Vec3d;

namespace opencv_test {

namespace {

enum Answer { NO, YES, UNDECIDED };

class PoseOracle
{
public:
    PoseOracle(const Mat& camera, const Mat& distortion, const Mat& model)
        : K(Matx33d(camera.ptr<double>()) * (1 / camera.at<double>(2, 2))), d(),
          pose(model.ptr<double>())
    {
        for (int i = 0; i < (int)distortion.total(); ++i)
            d[i] = distortion.ptr<double>()[i];
        const double f = (std::abs(K(0, 0)) + std::abs(K(1, 1))) / 2;
        const Matx33d centered(K(0, 0) / f, K(0, 1) / f, 0, K(1, 0) / f, K(1, 1) / f, 0, 0, 0, 1);
        condition = cv::norm(centered) * cv::norm(centered.inv());
    }

    //! Decides whether the point X, seen at `seen`, is an inlier. `error` is its reprojection error
    //! in pixels, or NaN if the error is not needed for the answer.
    Answer isInlier(const Point3d& X, const Point2d& seen, double threshold, double& error) const
    {
        error = NAN;
        Vec3d Y;
        double size = 0;  // upper bound of the sum of the absolute values of the terms of each
                          // entry of Y
        for (int row = 0; row < 3; ++row)
        {
            const long double terms[] = {(long double)pose(row, 0) * X.x,
                                         (long double)pose(row, 1) * X.y,
                                         (long double)pose(row, 2) * X.z, pose(row, 3)};
            Y[row] = (double)(terms[0] + terms[1] + terms[2] + terms[3]);
        }
        size = std::abs(X.x) + std::abs(X.y) + std::abs(X.z) + std::abs(pose(0, 3)) +
               std::abs(pose(1, 3)) + std::abs(pose(2, 3));
        const double moved = ROUNDING * condition * size + DBL_MIN;
        if (!(size < 1e150) || !(std::abs(Y[2]) > 2 * moved) || !(std::abs(Y[2]) > 1e-150))
            return UNDECIDED;
        if (Y[2] < 0)
            return NO;
        const double x = Y[0] / Y[2], y = Y[1] / Y[2], radius = std::sqrt(x * x + y * y);
        const Answer shown = isShown(x, y, radius);
        if (shown != YES)
            return shown;
        return isNear(Point3d(x, y, 1), moved / Y[2], seen, threshold, error);
    }

private:
    //! Distorted radius of a point with radius r, from the radial terms only. NaN at or beyond a
    //! pole.
    double radial(double r) const
    {
        const double q = r * r, below = 1 + q * (d[5] + q * (d[6] + q * d[7]));
        return below > 0 ? r * (1 + q * (d[0] + q * (d[1] + q * d[4]))) / below : NAN;
    }

    //! Returns true if radial() increases strictly between equidistant radii up to `radius`.
    bool grows(double radius) const
    {
        const int steps = 2000;
        double before = 0;
        for (int i = 1; i <= steps; ++i)
        {
            const double now = radial(radius * i / steps);
            if (!(now > before))
                return false;
            before = now;
        }
        return true;
    }

    Answer isShown(double x, double y, double radius) const
    {
        if (!(radius < 1e30))
            return UNDECIDED;
        const double far = radius * (1 + OFF_FOLD), close = radius * (1 - OFF_FOLD);
        const bool straight = d[0] == 0 && d[1] == 0 && d[4] == 0 && d[5] == 0 && d[6] == 0 &&
                              d[7] == 0;
        const bool certain = straight || grows(far);
        if (!certain)
            return grows(close) ? UNDECIDED : NO;
        if (d[12] == 0 && d[13] == 0)
            return YES;
        // For a tilted sensor: the other terms of the lens model move (x, y) to the point `flat`;
        // `depth` is the depth of this point after the tilt.
        const std::vector<Point3d> point(1, Point3d(x, y, 1));
        std::vector<Point2d> flat;
        cv::projectPoints(point, Vec3d(), Vec3d(), Matx33d::eye(),
                          Mat(1, 12, CV_64F, const_cast<double*>(d)), flat);
        const double terms[] = {std::sin(d[13]) * flat[0].x,
                                -std::cos(d[13]) * std::sin(d[12]) * flat[0].y,
                                std::cos(d[13]) * std::cos(d[12])};
        const double depth = terms[0] + terms[1] + terms[2];
        const double size = std::abs(terms[0]) + std::abs(terms[1]) + std::abs(terms[2]);
        return depth > 1e-6 * size ? YES : depth < -1e-6 * size ? NO : UNDECIDED;
    }

    //! Compares the reprojection error of `point` with the threshold; `point` has depth 1, and its
    //! coordinates have rounding errors of up to `moved`.
    Answer isNear(const Point3d& point, double moved, const Point2d& seen, double threshold,
                  double& error) const
    {
        const std::vector<Point3d> points(1, point);
        std::vector<Point2d> image;
        Mat J;  // derivatives of the image point with respect to rvec, tvec, focal lengths,
                // principal point and coefficients
        cv::projectPoints(points, Vec3d(), Vec3d(), Matx33d::eye(),
                          Mat(1, 14, CV_64F, const_cast<double*>(d)), image, J);
        // cv::projectPoints ignores the skew, so K is applied here
        const Point2d there(K(0, 0) * image[0].x + K(0, 1) * image[0].y + K(0, 2),
                            K(1, 0) * image[0].x + K(1, 1) * image[0].y + K(1, 2));
        double byPosition = 0, byCoefficients = 0;
        for (int row = 0; row < 2; ++row)
        {
            for (int k = 3; k < 6; ++k)
                byPosition += std::abs(J.at<double>(row, k));
            for (int k = 10; k < J.cols; ++k)
                byCoefficients += std::abs(J.at<double>(row, k) * d[k - 10]);
        }
        const double linear = std::abs(K(0, 0)) + std::abs(K(0, 1)) + std::abs(K(1, 0)) +
                              std::abs(K(1, 1));
        const double rounding = linear * (byPosition * moved +
                                          ROUNDING * (byCoefficients +
                                                      byPosition * (1 + std::abs(point.x) +
                                                                    std::abs(point.y)))) +
                                ROUNDING * (std::abs(there.x) + std::abs(there.y) +
                                            std::abs(seen.x) + std::abs(seen.y) +
                                            std::abs(K(0, 2)) + std::abs(K(1, 2)) + threshold);
        error = cv::norm(there - seen);
        if (!(std::abs(error - threshold) > rounding))  // also if the error is NaN
            return UNDECIDED;
        return error <= threshold ? YES : NO;
    }

    const Matx33d K;
    double d[14];
    const Matx34d pose;
    double condition;  //!< condition number of K / focal length, without the principal point
};

bool finite(const Point3d& X, const Point2d& x)
{
    return std::abs(X.x) <= DBL_MAX && std::abs(X.y) <= DBL_MAX && std::abs(X.z) <= DBL_MAX &&
           std::abs(x.x) <= DBL_MAX && std::abs(x.y) <= DBL_MAX;
}

}  // namespace

std::string brokenPose(const EstimatorCall& call, double threshold, const Mat& model,
                       const Mat& mask)
{
    if (model.size() != cv::Size(4, 3) || model.type() != CV_64FC1)
        return format("the pose is %d x %d, type %d", model.rows, model.cols, model.type());
    if (!cv::checkRange(model))
        return "the pose is not finite";
    const Matx33d R(model.colRange(0, 3));
    const double off = cv::norm(R * R.t() - Matx33d::eye(), cv::NORM_INF);
    if (!(off <= 1e-9) || !(cv::determinant(R) > 0))
        return format("not a rotation: |R R^T - I| is %g, the determinant %g", off,
                      cv::determinant(R));
    const PoseOracle oracle(call.K1, call.d1, model);
    for (int i = 0; i < mask.rows; ++i)
    {
        const int given = mask.at<uchar>(i);
        if (given > 1)
            return format("row %d of the mask is %d", i, given);
        double error = NAN;
        const bool whole = finite(call.object[i], call.points2[i]);
        const Answer right = whole ? oracle.isInlier(call.object[i], call.points2[i], threshold,
                                                     error)
                                   : NO;
        if (right != UNDECIDED && given != (right == YES))
            return format("row %d of the mask is %d, the error %.17g, the threshold %.17g", i,
                          given, error, threshold);
    }
    return "";
}

}  // namespace opencv_test
