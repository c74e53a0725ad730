// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_contracts.hpp"

namespace opencv_test {

const char* nameOf(ProblemType problem)
{
    static const char* names[] = {"homography", "fundamental", "essential"};
    return names[problem];
}

Matx33d sceneCamera()
{
    return makeScene(ESSENTIAL).K;
}

Mat estimatePoints(ProblemType problem, InputArray points1, InputArray points2, const Params& params,
                   OutputArray mask, Report& report, InputArray K)
{
    if (problem == HOMOGRAPHY)
        return estimateHomography(points1, points2, params, mask, report);
    if (problem == FUNDAMENTAL)
        return estimateFundamental(points1, points2, params, mask, report);
    return estimateEssential(points1, points2, K, params, mask, report);
}

bool sameBits(const Mat& a, const Mat& b)
{
    if (a.empty() || b.empty())
        return a.empty() && b.empty();
    const Mat x = a.clone(), y = b.clone();  // continuous
    return x.type() == y.type() && x.size() == y.size() && std::memcmp(x.data, y.data, x.total() * x.elemSize()) == 0;
}

namespace {

bool isFinite(double value)
{
    return value == value && std::abs(value) <= std::numeric_limits<double>::max();
}

void checkNormalisation(ProblemType problem, const Matx33d& M)
{
    for (int k = 0; k < 9; ++k)
        ASSERT_TRUE(isFinite(M.val[k]));
    if (problem == HOMOGRAPHY)
    {
        EXPECT_TRUE(M(2, 2) == 1 || std::abs(cv::norm(M) - 1) < 1e-12) << "h33 = " << M(2, 2) << ", norm " << cv::norm(M);
        EXPECT_NE(0, determinant(M));
        return;
    }
    Mat w;
    SVD::compute(Mat(M), w, SVD::NO_UV);
    EXPECT_NEAR(1, cv::norm(M), 1e-12);
    EXPECT_LE(w.at<double>(2), 1e-10) << "rank";
    if (problem == ESSENTIAL)
    {
        EXPECT_NEAR(w.at<double>(0), w.at<double>(1), 1e-10) << "singular values";
    }
    else
    {
        EXPECT_GT(w.at<double>(1), 0) << "rank";
    }
}

typedef long double Real;

//! An error and how far that of a computation in double can be from it.
struct Bounded
{
    Real error, rounding;
};

/** Written anew, with other operations than the module's and in a longer type where there is one. M x1, M^T x2 and the sums of
the sizes of their terms, which say what rounding can do. */
Bounded independentError(ProblemType problem, const Matx33d& M, const Real* x1, const Real* x2)
{
    const Real unit = 16 * std::numeric_limits<double>::epsilon();
    Real y[3] = {0, 0, 0}, z[3] = {0, 0, 0}, sizeY[3] = {0, 0, 0}, sizeZ[3] = {0, 0, 0};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
        {
            y[i] += M(i, j) * x1[j];
            sizeY[i] += std::abs(M(i, j) * x1[j]);
            z[i] += M(j, i) * x2[j];
            sizeZ[i] += std::abs(M(j, i) * x2[j]);
        }
    Bounded result;
    if (problem == HOMOGRAPHY)
    {
        const Real u = y[0] / y[2], v = y[1] / y[2], w = std::abs(y[2]);
        result.error = std::hypot(u - x2[0], v - x2[1]);
        result.rounding = unit * ((sizeY[0] + sizeY[1] + (std::abs(u) + std::abs(v)) * sizeY[2]) / w + std::abs(x2[0]) +
                                  std::abs(x2[1]) + result.error);
        return result;
    }
    Real residual = 0, size = 0;
    for (int i = 0; i < 3; ++i)
    {
        residual += x2[i] * y[i];
        size += std::abs(x2[i]) * sizeY[i];
    }
    const Real gradient = std::hypot(std::hypot(y[0], y[1]), std::hypot(z[0], z[1]));
    result.error = std::abs(residual) / gradient;
    result.rounding = unit * (size + result.error * (sizeY[0] + sizeY[1] + sizeZ[0] + sizeZ[1])) / gradient;
    return result;
}

/** mask == (error <= threshold); only where rounding decides both are right. For E the points are normalised with K, which has no
skew here. */
void checkMask(ProblemType problem, const std::vector<Point2d>& points1, const std::vector<Point2d>& points2,
               double pixels, const Matx33d& M, const Mat& mask, const Matx33d& K)
{
    const bool essential = problem == ESSENTIAL;
    const Matx33d camera = essential ? K : Matx33d::eye(), rays = camera.inv();
    const Real limit = essential ? pixels / (0.5L * (std::abs(K(0, 0)) + std::abs(K(1, 1)))) : pixels;
    const Real unit = 8 * std::numeric_limits<double>::epsilon();
    const Real shift = essential ? unit * (std::abs(rays(0, 2)) + std::abs(rays(1, 2)) + std::abs(rays(0, 1))) : 0;
    int wrong = 0, row = -1;
    for (int i = 0; i < mask.rows; ++i)
    {
        ASSERT_LE(mask.at<uchar>(i), 1);
        const Point2d p[2] = {points1[i], points2[i]};
        Real x[2][3];
        for (int k = 0; k < 2; ++k)
        {
            x[k][0] = rays(0, 0) * (Real)p[k].x + rays(0, 1) * (Real)p[k].y + rays(0, 2);
            x[k][1] = rays(1, 1) * (Real)p[k].y + rays(1, 2);
            x[k][2] = 1;
        }
        const Bounded b = independentError(problem, M, x[0], x[1]);
        const bool open = std::abs(b.error - limit) <= b.rounding + shift + unit * limit;
        if (!open && (mask.at<uchar>(i) != 0) != (b.error <= limit))
        {
            ++wrong;
            row = i;
        }
    }
    EXPECT_EQ(0, wrong) << "rows of the mask, one of them " << row;
}

} // namespace

void checkResult(ProblemType problem, const std::vector<Point2d>& points1, const std::vector<Point2d>& points2,
                 double pixels, const Mat& model, const Mat& mask, const Report& report, const Matx33d& K)
{
    const int count = (int)points1.size();
    ASSERT_EQ(count, mask.rows);
    ASSERT_TRUE(count == 0 || mask.cols == 1);
    ASSERT_TRUE(count == 0 || mask.type() == CV_8UC1);
    EXPECT_FALSE(report.describe().empty());
    const int inliers = count ? countNonZero(mask) : 0;
    EXPECT_EQ(inliers, report.inliers);
    EXPECT_TRUE(report.cost >= 0 && report.cost <= 1) << report.cost;  // false for NaN
    EXPECT_TRUE(report.chance >= 0 && report.chance <= 1) << report.chance;
    EXPECT_TRUE(report.threshold > 0 && isFinite(report.threshold)) << report.threshold;
    EXPECT_TRUE(report.independentInliers >= 0 && report.independentInliers <= inliers) << report.independentInliers;
    if (model.empty())
    {
        EXPECT_EQ(0, inliers);
        EXPECT_TRUE(report.stop == STOP_TOO_FEW_POINTS || report.stop == STOP_NO_MODEL) << report.stop;
        return;
    }
    EXPECT_GE(report.stop, STOP_MAX_ITERATIONS);
    EXPECT_GT(inliers, 0);
    ASSERT_EQ(Size(3, 3), model.size());
    ASSERT_EQ(CV_64FC1, model.type());
    const Matx33d M(model.ptr<double>());
    checkNormalisation(problem, M);
    checkMask(problem, points1, points2, pixels, M, mask, K);
}

void checkResult(const Scene& scene, double pixels, const Mat& model, const Mat& mask, const Report& report)
{
    checkResult(scene.problem, scene.points1, scene.points2, pixels, model, mask, report, scene.K);
}

std::vector<NamedPreset> allPresets()
{
    const NamedPreset all[] = {
        {"usacV20", Params::usacV20()}, {"fast", Params::fast()}, {"accurate", Params::accurate()},
        {"sorted", Params::sorted()}, {"parallel", Params::parallel()}, {"ransac", Params::ransac()},
        {"msac", Params::msac()}, {"lmeds", Params::lmeds()}, {"mlesac", Params::mlesac()}, {"prosac", Params::prosac()},
        {"loRansac", Params::loRansac()}, {"floRansac", Params::floRansac()}, {"gcRansac", Params::gcRansac()},
        {"usac2013", Params::usac2013()}, {"magsac", Params::magsac()}, {"magsacPlusPlus", Params::magsacPlusPlus()}};
    return std::vector<NamedPreset>(all, all + sizeof(all) / sizeof(all[0]));
}

namespace {

//! The find functions with a flag, in all forms; the answer must be that of the estimate function.
void checkFlag(UsacV20Method flag, ProblemType problem, InputArray points1, InputArray points2, const Params& params,
               const Matx33d& K, const Mat& model, const Mat& mask)
{
    Mat m, other;
    if (problem == HOMOGRAPHY)
        m = findHomography(points1, points2, flag, params.threshold, other, params.maxIterations, params.confidence);
    else if (problem == FUNDAMENTAL)
        m = findFundamentalMat(points1, points2, flag, params.threshold, params.confidence, params.maxIterations, other);
    else
        m = findEssentialMat(points1, points2, K, flag, params.confidence, params.threshold, params.maxIterations, other);
    EXPECT_TRUE(sameBits(model, m) && sameBits(mask, other)) << "flag " << (int)flag;
    if (problem == ESSENTIAL && K(0, 0) == K(1, 1) && K(0, 1) == 0)
    {
        m = findEssentialMat(points1, points2, K(0, 0), Point2d(K(0, 2), K(1, 2)), flag, params.confidence, params.threshold,
                             params.maxIterations, other);
        EXPECT_TRUE(sameBits(model, m) && sameBits(mask, other)) << "flag " << (int)flag << ", focal length";
    }
}

} // namespace

std::vector<Mat> checkEveryWay(ProblemType problem, const std::vector<Point2d>& points1, const std::vector<Point2d>& points2,
                               double pixels, int maxIterations, const Matx33d& K)
{
    const std::vector<NamedPreset> presets = allPresets();
    std::vector<Mat> models;
    for (size_t i = 0; i < presets.size(); ++i)
    {
        SCOPED_TRACE(cv::format("%s, preset %s", nameOf(problem), presets[i].name));
        Params params = presets[i].params;
        params.threshold = pixels;
        params.maxIterations = maxIterations;
        Mat mask, other;
        Report report;
        models.push_back(estimatePoints(problem, points1, points2, params, mask, report, K));
        const bool found = params.quality == QUALITY_LMEDS;
        checkResult(problem, points1, points2, found ? report.threshold : pixels, models[i], mask, report, K);
        EXPECT_TRUE(found || report.threshold == pixels) << report.threshold;
        EXPECT_TRUE(sameBits(models[i], Usac::create(problem, points1, points2, params, K)->run(other)));
        EXPECT_TRUE(sameBits(mask, other)) << "Usac::create";
        const int flags[] = {USACV20, USACV20_FAST, USACV20_ACCURATE, USACV20_PROSAC, USACV20_MAGSAC, USACV20_PARALLEL};
        const char* names[] = {"usacV20", "fast", "accurate", "sorted", "magsacPlusPlus", "parallel"};
        for (int f = 0; f < 6; ++f)
            if (std::string(names[f]) == presets[i].name)
                checkFlag(methodFromInt(flags[f]), problem, points1, points2, params, K, models[i], mask);
    }
    return models;
}

} // namespace opencv_test
