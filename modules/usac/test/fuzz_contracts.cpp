// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "fuzz_contracts.hpp"

#include <cfloat>
#include <cmath>
#include <cstring>
#include "opencv2/calib3d.hpp"

using namespace cv::usacv20;
using cv::Mat;
using cv::Matx33d;
using cv::Point2d;
using cv::format;

namespace opencv_test {

namespace {

/** A number with a bound of what rounding to double may have changed in it: for sums and products in any order, some times the
error of this one. So there is no tolerance to choose. Infinite where an intermediate result leaves the range of double. */
struct Bounded
{
    Bounded(long double v = 0, long double e = 0) : value(v), error(e)
    {
        if (!(std::abs(value) + error < DBL_MAX))
            error = HUGE_VALL;
    }
    long double value, error;
};

const long double UNIT = 8 * DBL_EPSILON;

Bounded operator+(const Bounded& a, const Bounded& b)
{
    const long double v = a.value + b.value;
    return Bounded(v, a.error + b.error + UNIT * std::abs(v));
}

Bounded operator-(const Bounded& a, const Bounded& b)
{
    return a + Bounded(-b.value, b.error);
}

Bounded operator*(const Bounded& a, const Bounded& b)
{
    const long double v = a.value * b.value;
    return Bounded(v, std::abs(a.value) * b.error + (std::abs(b.value) + b.error) * a.error + UNIT * std::abs(v) + DBL_MIN);
}

Bounded operator/(const Bounded& a, const Bounded& b)
{
    const long double least = std::abs(b.value) - b.error;
    if (!(least > DBL_MIN))
        return Bounded(0, HUGE_VALL);
    const long double v = a.value / b.value;
    return Bounded(v, (a.error + std::abs(v) * b.error) / least + UNIT * std::abs(v) + DBL_MIN);
}

Bounded squareRoot(const Bounded& a)
{
    const long double high = std::sqrt(std::max(a.value, 0.L) + a.error), low = std::sqrt(std::max(a.value - a.error, 0.L));
    return Bounded((high + low) / 2, (high - low) / 2 + UNIT * high);
}

struct BoundedPoint
{
    Bounded x, y;
};

//! The third coordinate of `point` is 1.
void multiply(const Bounded* M, const BoundedPoint& point, Bounded* result)
{
    for (int i = 0; i < 3; ++i)
        result[i] = M[3 * i] * point.x + M[3 * i + 1] * point.y + M[3 * i + 2];
}

BoundedPoint project(const Bounded* M, const BoundedPoint& point)
{
    Bounded p[3];
    multiply(M, point, p);
    const BoundedPoint result = {p[0] / p[2], p[1] / p[2]};
    return result;
}

//! The inverse up to a factor.
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

Bounded modelError(const FuzzInput& input, const Bounded* M, const BoundedPoint& p1, const BoundedPoint& p2)
{
    const bool symmetric = input.params.residual == RESIDUAL_SYMMETRIC;
    Bounded other[9];
    if (input.problem == HOMOGRAPHY)
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
    const Bounded n1 = line1[0] * line1[0] + line1[1] * line1[1], n2 = line2[0] * line2[0] + line2[1] * line2[1];
    return squareRoot(symmetric ? r * r * (one / n1 + one / n2) : r * r / (n1 + n2));
}

/** Points of one image as the errors of the problem see them. What cv::undistortPoints makes of a point has no bound: then it gets
the same doubles as the module's. */
std::vector<BoundedPoint> imagePoints(const std::vector<Point2d>& points, const Mat& camera, const Mat& distortion)
{
    std::vector<BoundedPoint> result(points.size());
    for (size_t i = 0; i < points.size(); ++i)
    {
        result[i].x = Bounded(points[i].x);
        result[i].y = Bounded(points[i].y);
    }
    if (camera.empty() || points.empty())
        return result;
    if (!distortion.empty() && cv::countNonZero(distortion) > 0)
    {
        const Matx33d K(camera.ptr<double>()), rays = (K * (1 / K(2, 2))).inv();
        std::vector<Point2d> flat(points.size());
        for (size_t i = 0; i < points.size(); ++i)
        {
            const cv::Vec3d p = rays * cv::Vec3d(points[i].x, points[i].y, 1);
            flat[i] = Point2d(p[0] / p[2], p[1] / p[2]);
        }
        cv::undistortPoints(flat, flat, Matx33d::eye(), distortion);
        for (size_t i = 0; i < points.size(); ++i)
        {
            result[i].x = Bounded(flat[i].x);
            result[i].y = Bounded(flat[i].y);
        }
        return result;
    }
    Bounded K[9], inverse[9];
    for (int i = 0; i < 9; ++i)
        K[i] = Bounded(camera.at<double>(i / 3, i % 3));
    adjugate(K, inverse);
    for (size_t i = 0; i < points.size(); ++i)
        result[i] = project(inverse, result[i]);
    return result;
}

//! Mean of the two focal lengths, halved; a camera matrix may be a multiple of the one with 0 0 1 in its last row.
double halfFocal(const Mat& K)
{
    return (std::abs(K.at<double>(0, 0) / K.at<double>(2, 2)) + std::abs(K.at<double>(1, 1) / K.at<double>(2, 2))) / 4;
}

bool finite(const Point2d& p)
{
    return std::abs(p.x) <= DBL_MAX && std::abs(p.y) <= DBL_MAX;
}

std::string brokenMask(const FuzzInput& input, const Matx33d& model, const Mat& mask, const Report& report)
{
    const Mat& K1 = input.K1, &K2 = input.K2.empty() ? K1 : input.K2;
    Bounded limit(report.threshold, UNIT * report.threshold), M[9];
    if (input.problem == ESSENTIAL)
        limit = limit / Bounded(halfFocal(K1) + halfFocal(K2));
    for (int i = 0; i < 9; ++i)
        M[i] = Bounded(model.val[i]);
    const std::vector<BoundedPoint> points1 = imagePoints(input.points1, K1, input.d1);
    const std::vector<BoundedPoint> points2 = imagePoints(input.points2, K2, input.d2);
    for (int i = 0; i < mask.rows; ++i)
    {
        const bool inlier = mask.at<uchar>(i) != 0;
        if (mask.at<uchar>(i) > 1)
            return format("row %d of the mask is %d", i, mask.at<uchar>(i));
        if (!finite(input.points1[i]) || !finite(input.points2[i]))
        {
            if (inlier)
                return format("row %d is not finite and an inlier", i);
            continue;
        }
        const Bounded error = modelError(input, M, points1[i], points2[i]);
        const bool decided = std::abs(error.value - limit.value) > error.error + limit.error;  // false for NaN
        if (decided && inlier != (error.value <= limit.value))
            return format("row %d of the mask is %d, the error %.17Lg, the threshold %.17Lg", i, (int)inlier, error.value,
                          limit.value);
    }
    return "";
}

std::string brokenModel(ProblemType problem, const Matx33d& M)
{
    for (int i = 0; i < 9; ++i)
        if (!(std::abs(M.val[i]) <= DBL_MAX))
            return "the model is not finite";
    const double size = cv::norm(M);
    if (problem == HOMOGRAPHY)
        return M(2, 2) == 1 || std::abs(size - 1) < 1e-12 ? "" : format("h33 is %g, the norm of H %g", M(2, 2), size);
    Mat w;
    cv::SVD::compute(Mat(M), w, cv::SVD::NO_UV);
    const double* s = w.ptr<double>();
    if (std::abs(size - 1) > 1e-12)
        return format("norm %.17g", size);
    if (s[2] > 1e-10 || !(s[1] > 0))
        return format("rank: singular values %g, %g, %g", s[0], s[1], s[2]);
    if (problem == ESSENTIAL && std::abs(s[0] - s[1]) > 1e-10)
        return format("singular values %.17g, %.17g", s[0], s[1]);
    return "";
}

struct Answer
{
    Mat model, mask;
    Report report;
    std::string exception;
};

Answer run(const FuzzInput& input, int threads)
{
    Answer answer;
    Params params = input.params;
    if (params.threads == 1)  // else what the input has
        params.threads = threads;
    try
    {
        if (input.problem == HOMOGRAPHY)
            answer.model = estimateHomography(input.points1, input.points2, params, answer.mask, answer.report);
        else if (input.problem == FUNDAMENTAL)
            answer.model = estimateFundamental(input.points1, input.points2, params, answer.mask, answer.report);
        else
            answer.model = estimateEssential(input.points1, input.points2, input.K1, input.K2, input.d1, input.d2, params,
                                             answer.mask, answer.report);
    }
    catch (const cv::Exception& e)
    {
        answer.exception = e.err;
    }
    return answer;
}

//! 1: a wrong camera, 0: a right one, -1: between.
int wrongCamera(const Mat& K)
{
    if (K.empty())
        return 0;
    const double *k = K.ptr<double>(), det = std::abs(cv::determinant(K)), scale = std::abs(k[0] * k[4] * k[8]);
    if (!cv::checkRange(K) || k[0] == 0 || k[4] == 0 || k[8] == 0 || k[6] != 0 || k[7] != 0)
        return 1;
    return det > 1e-10 * scale && det <= DBL_MAX && scale <= DBL_MAX ? 0 : -1;
}

bool wrongDistortion(const Mat& d)
{
    return d.total() == 3 || !cv::checkRange(d);  // no other wrong length in a FuzzInput
}

//! 1: the call has to be refused, 0: it must not, -1: either.
int wrongArguments(const FuzzInput& input)
{
    int wrong = input.points1.size() != input.points2.size();
    try
    {
        input.params.check((int)input.points1.size());
    }
    catch (const cv::Exception&)
    {
        wrong = 1;
    }
    if (wrong == 1 || input.problem != ESSENTIAL)
        return wrong;
    const int camera1 = wrongCamera(input.K1), camera2 = wrongCamera(input.K2);
    if (camera1 == 1 || camera2 == 1)
        return 1;
    if (wrongDistortion(input.d1) || wrongDistortion(input.d2))
        return 1;
    return camera1 == 0 && camera2 == 0 ? 0 : -1;
}

bool namesAnArgument(const std::string& message)
{
    static const char* const names[] = {
        "threshold", "confidence", "maxIterations", "threads", "sampler", "prior", "scores", "scoreOrder", "neighbourhood",
        "neighbours", "neighbourRadius", "residual", "quality", "reach", "verification", "tddPoints", "localOptimization",
        "localIterations", "localSampleMultiple", "localSamples", "spatialWeight", "termination", "relaxation", "degeneracy",
        "polishing", "points1", "points2", "cameraMatrix1", "cameraMatrix2", "distCoeffs1", "distCoeffs2"};
    for (size_t i = 0; i < sizeof(names) / sizeof(names[0]); ++i)
        if (message.compare(0, std::strlen(names[i]), names[i]) == 0)
            return true;
    return false;
}

bool sameBits(const Mat& a, const Mat& b)
{
    return a.size() == b.size() && a.type() == b.type() &&
           (a.empty() || std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0);
}

bool sameBits(const std::vector<Point2d>& a, const std::vector<Point2d>& b)
{
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

std::string brokenRepetition(const Answer& a, const Answer& b)
{
    const Report &r = a.report, &s = b.report;
    if (a.exception != b.exception)
        return "another exception the second time: " + b.exception;
    if (!sameBits(a.model, b.model) || !sameBits(a.mask, b.mask))
        return "another result the second time";
    const bool same = r.stop == s.stop && r.iterations == s.iterations && r.models == s.models && r.inliers == s.inliers &&
                      r.independentInliers == s.independentInliers && r.cost == s.cost && r.chance == s.chance &&
                      r.threshold == s.threshold && r.localOptimizations == s.localOptimizations;
    return same ? "" : "another report the second time: " + s.describe();
}

std::string brokenAnswer(const FuzzInput& input, const Answer& answer)
{
    const int wrong = wrongArguments(input);
    if (!answer.exception.empty())
        return wrong == 0 ? "refused without a reason: " + answer.exception :
               !namesAnArgument(answer.exception) ? "no argument is named: " + answer.exception : "";
    return wrong == 1 ? "a wrong argument is not refused" : brokenResult(input, answer.model, answer.mask, answer.report);
}

} // namespace

std::string brokenResult(const FuzzInput& input, const Mat& model, const Mat& mask, const Report& report)
{
    const int count = (int)input.points1.size();
    if (mask.rows != count || (count > 0 && (mask.cols != 1 || mask.type() != CV_8UC1)))
        return format("the mask is %d x %d, type %d", mask.rows, mask.cols, mask.type());
    const int inliers = count ? cv::countNonZero(mask) : 0;
    if (inliers != report.inliers)
        return format("%d inliers in the mask, %d in the report", inliers, report.inliers);
    if (model.empty())
        return inliers > 0 ? "inliers without a model" :
               report.stop != STOP_TOO_FEW_POINTS && report.stop != STOP_NO_MODEL ? "no reason for no model" : "";
    if (report.stop < STOP_MAX_ITERATIONS || inliers == 0 || !(report.cost >= 0 && report.cost <= 1) ||
        !(report.chance >= 0 && report.chance <= 1))
        return format("report: chance %g, %s", report.chance, report.describe().c_str());
    if (input.params.quality != QUALITY_LMEDS && std::abs(report.threshold / input.params.threshold - 1) > 1e-12)
        return format("the threshold is %g", report.threshold);
    const Matx33d M(model.ptr<double>());
    const std::string broken = brokenModel(input.problem, M);
    return broken.empty() ? brokenMask(input, M, mask, report) : broken;
}

std::string brokenContract(const FuzzInput& input)
{
    const std::vector<Point2d> before1 = input.points1, before2 = input.points2;
    const Mat K1 = input.K1.clone(), K2 = input.K2.clone();
    const Answer first = run(input, 1), second = run(input, input.otherThreads);
    if (!sameBits(before1, input.points1) || !sameBits(before2, input.points2) || !sameBits(K1, input.K1) ||
        !sameBits(K2, input.K2))
        return "the input has changed";
    const std::string broken = brokenAnswer(input, first);
    return broken.empty() ? brokenRepetition(first, second) : broken;
}

} // namespace opencv_test
