// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problem_data.hpp"
#include "residuals/simd.hpp"
#include "statistics/robust_frame.hpp"
#include "termination/non_randomness.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Of the search, whose squares and their inverses must be neither 0 nor infinite as float. That of the mask is the
//! caller's.
const double SMALLEST_THRESHOLD = 1e-18, LARGEST_THRESHOLD = 1e18;

/** Any list of points that OpenCV's functions take with one flag or another; one point a row, one coordinate a column,
CV_64F. A matrix with one channel has its points along the longer side (as for OpenCV's USAC flags), with equal sides in
the rows; a single row or column is one point. */
Mat readCoordinates(const Mat& points, const char* name)
{
    const int rows = points.rows, cols = points.cols, channels = points.channels();
    const bool solid = points.dims == 3 && channels == 1 && (points.size[0] == 1 || points.size[1] == 1);
    const bool perColumn = channels == 1 && (cols == 1 || (1 < rows && rows < cols));  // else per row or per element
    const int coordinates = solid ? points.size[2] : channels > 1 ? channels : perColumn ? rows : cols;
    const bool fewCoordinates = solid ||
                                (channels == 1 && (rows == 1 || cols == 1));  // OpenCV takes no more of them here
    if ((points.dims > 2 && !solid) || coordinates < 2 || (fewCoordinates && coordinates > 3))
        CV_Error_(Error::StsBadArg,
                  ("%s: N points are expected as Nx2, Nx3, 2xN or 3xN with 1 channel or with 2 or 3 channels, "
                   "not as %dx%d with %d channel(s) and %d dimensions",
                   name, rows, cols, channels, points.dims));
    Mat values;  // continuous
    if (points.depth() == CV_64F && points.isContinuous())
        values = points;
    else
        points.convertTo(values, CV_64F);
    if (perColumn)
        return values.t();
    return values.reshape(1, (int)(points.total() * channels / coordinates));
}

/** The points as Nx1 CV_64FC2. Three coordinates are homogeneous, as for cv::RANSAC; of more, the first two are the
point, as for OpenCV's USAC flags. */
Mat readPoints(InputArray array, const char* name)
{
    const Mat points = array.getMat();
    if (points.empty())
        return Mat(0, 1, CV_64FC2);
    const Mat values = readCoordinates(points, name);
    if (values.cols == 2)
        return values.reshape(2);
    if (values.cols > 3)
        return values.colRange(0, 2).clone().reshape(2);
    Mat plane;
    convertPointsFromHomogeneous(values, plane);
    for (int i = 0; i < plane.rows; ++i)
        if (values.at<double>(i, 2) == 0)
            plane.at<Vec2d>(i) = Vec2d(INFINITY, INFINITY);  // which OpenCV takes for a finite point
    return plane;
}

/** Tells the allocator how much memory a call needs. At the end of a call glibc gives the top of its heap back to the
system if that is more than twice the largest block freed so far, 128 kB at least; then each page that the next call
writes to is a page fault, together up to a quarter of its time. A block that nobody writes to costs nothing. */
void announceMemory(int points)
{
    enum { BYTES_OF_POINT = 200, BYTES_OF_CALL = 1 << 16, LARGEST = 1 << 23 };
    fastFree(fastMalloc(std::min<size_t>((size_t)points * BYTES_OF_POINT + BYTES_OF_CALL, LARGEST)));
}

bool finite(double value)
{
    return std::abs(value) <= DBL_MAX;  // false for NaN
}

bool allFinite(const double* values, int count)
{
    enum { LANES = 4 };
    double zeros[LANES] = {0};
    const int whole = count - count % LANES;
    for (int i = 0; i < whole; i += LANES)
    {
        USAC_SIMD
        for (int k = 0; k < LANES; ++k)
            zeros[k] += values[i + k] * 0;
    }
    for (int i = whole; i < count; ++i)
        zeros[0] += values[i] * 0;
    return zeros[0] + zeros[1] + zeros[2] + zeros[3] == 0;  // else NaN
}

}  // namespace

ProblemData::ProblemData(const Problem& problem, InputArray points1, InputArray points2, const Params& params)
{
    read(points1, points2);
    params.check(view.inputSize);
    pixelThreshold = params.threshold;
    pixels = problem.toModelCoordinates(input[0], input[1], input[2], input[3], view.inputSize);
    inputThreshold = std::min(pixelThreshold / pixels, DBL_MAX);
    view.problem = &problem;
    shuffle(params);
    scale(params);
    givenThreshold[0] = view.threshold;
    givenThreshold[1] = inputThreshold;
    givenThreshold[2] = pixelThreshold;
}

void ProblemData::restoreThreshold()
{
    view.threshold = givenThreshold[0];
    inputThreshold = givenThreshold[1];
    pixelThreshold = givenThreshold[2];
}

void ProblemData::read(InputArray points1, InputArray points2)
{
    const Mat p1 = readPoints(points1, "points1"), p2 = readPoints(points2, "points2");
    if (p1.rows != p2.rows)
        CV_Error_(Error::StsUnmatchedSizes,
                  ("points1 and points2: lists of the same length are expected, not of %d and %d", p1.rows, p2.rows));
    announceMemory(p1.rows);
    view.inputSize = p1.rows;
    inputRows.create(4, std::max(p1.rows, 1), CV_64F);
    for (int k = 0; k < 4; ++k)
        input[k] = inputRows.ptr<double>(k);
    for (int image = 0; image < 2; ++image)
    {
        const Vec2d* const from = (image == 0 ? p1 : p2).ptr<Vec2d>();
        double* const x = input[2 * image];
        double* const y = input[2 * image + 1];
        for (int i = 0; i < p1.rows; ++i)
        {
            x[i] = from[i][0];
            y[i] = from[i][1];
        }
    }
}

/** Keeps the finite rows in a fixed pseudo-random order (Fisher-Yates), as doubles. */
void ProblemData::shuffle(const Params& params)
{
    const int count = view.inputSize;
    indices.resize(count);
    for (int i = 0; i < count; ++i)
        indices[i] = i;
    int size = count;
    if (!allFinite(input[0], count) || !allFinite(input[1], count) || !allFinite(input[2], count) ||
        !allFinite(input[3], count))
    {
        size = 0;
        for (int i = 0; i < count; ++i)
            if (finite(input[0][i]) && finite(input[1][i]) && finite(input[2][i]) && finite(input[3][i]))
                indices[size++] = i;
        indices.resize(size);
    }
    Rng rng(0x5c3a9d1e, (uint64)size);
    for (int i = size - 1; i > 0; --i)
        std::swap(indices[i], indices[rng.uniform(i + 1)]);

    const int padded = alignSize(std::max(size, 1), 16);
    doubles.create(4, padded, CV_64F);
    floats.create(4, padded, CV_32F);
    for (int k = 0; k < 4; ++k)
    {
        double* const shuffled = doubles.ptr<double>(k);
        for (int i = 0; i < size; ++i)
            shuffled[i] = input[k][indices[i]];
        std::fill(shuffled + size, shuffled + padded, 0.);
        std::fill(floats.ptr<float>(k) + size, floats.ptr<float>(k) + padded, 0.f);
    }
    if (!params.scores.empty())
    {
        scores.resize(size);
        const float sign = params.scoreOrder == SCORES_HIGHER_IS_BETTER ? -1.f : 1.f;
        for (int i = 0; i < size; ++i)
        {
            const float score = sign * params.scores[indices[i]];
            scores[i] = score == score ? score : FLT_MAX;
        }
    }
    view.size = size;
    view.inputIndex = indices.data();
    view.scores = scores.empty() ? 0 : scores.data();
}

//! Moves the points to the center and to unit scale, as far as the problem allows.
void ProblemData::scale(const Params& params)
{
    const int normalization = view.problem->normalization(params.residual);
    double center[4], deviation[4], s[2] = {1, 1}, low[4], high[4];
    for (int k = 0; k < 4; ++k)
        robustFrame(doubles.ptr<double>(k), view.size, center[k], deviation[k], low[k], high[k]);
    if (normalization != SCALE_NONE)
    {
        for (int image = 0; image < 2; ++image)
        {
            const double size = (deviation[2 * image] + deviation[2 * image + 1]) / 2;
            s[image] = size > 1e-300 ? 1 / size : 1;
        }
        if (normalization == SCALE_COMMON)
            s[0] = s[1] = std::sqrt(s[0] * s[1]);
    }
    for (int k = 0; k < 4; ++k)
    {
        const double shift = normalization == SCALE_NONE ? 0 : center[k], factor = s[k / 2];
        double* const values = doubles.ptr<double>(k);
        float* const single = floats.ptr<float>(k);
        for (int i = 0; i < view.size; ++i)
        {
            values[i] = (values[i] - shift) * factor;
            single[i] = (float)values[i];
        }
        const double middle = (center[k] - shift) * factor, reach = 5 * deviation[k] * factor;
        view.lower[k] = (float)std::max((low[k] - shift) * factor, middle - reach);
        view.upper[k] = (float)std::min((high[k] - shift) * factor, middle + reach);
    }
    view.T1 = view.T2 = Matx33d::eye();
    if (normalization != SCALE_NONE)
    {
        view.T1 = Matx33d(s[0], 0, -s[0] * center[0], 0, s[0], -s[0] * center[1], 0, 0, 1);
        view.T2 = Matx33d(s[1], 0, -s[1] * center[2], 0, s[1], -s[1] * center[3], 0, 0, 1);
    }
    view.threshold = std::min(std::max(inputThreshold * params.reach * s[1], SMALLEST_THRESHOLD), LARGEST_THRESHOLD);
    view.x1 = floats.ptr<float>(0);
    view.y1 = floats.ptr<float>(1);
    view.x2 = floats.ptr<float>(2);
    view.y2 = floats.ptr<float>(3);
    view.dx1 = doubles.ptr<double>(0);
    view.dy1 = doubles.ptr<double>(1);
    view.dx2 = doubles.ptr<double>(2);
    view.dy2 = doubles.ptr<double>(3);
}

//! Exact data may ask for 0, which is below the rounding of the errors.
void ProblemData::setThreshold(double threshold)
{
    if (threshold == view.threshold)
        return;
    view.threshold = std::max(threshold, 1e-6);
    inputThreshold = view.threshold / view.T2(0, 0);
    pixelThreshold = inputThreshold * pixels;
}

int ProblemData::independentInliers(const std::vector<uchar>& mask) const
{
    return usacv20::independentInliers(input[0], input[1], input[2], input[3], mask.data(), view.inputSize,
                                       inputThreshold, inputThreshold);
}

int ProblemData::mask(const Residual& residual, const Matx33d& model, std::vector<uchar>& mask) const
{
    const int count = view.inputSize;
    std::vector<double> errors(count);
    residual.squaredErrors(model, input[0], input[1], input[2], input[3], count, errors.data());
    mask.assign(count, 0);
    int inliers = 0;
    for (int i = 0; i < count; ++i)
        inliers += mask[i] = std::sqrt(errors[i]) <= inputThreshold;  // false for NaN
    return inliers;
}

}  // namespace usacv20
}  // namespace cv
