// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problem_data.hpp"
#include "read_points.hpp"
#include "residuals/simd.hpp"
#include "statistics/robust_frame.hpp"
#include "termination/non_randomness.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Of the search, whose squares and their inverses must be neither 0 nor infinite as float. That of the mask is the
//! caller's.
const double SMALLEST_THRESHOLD = 1e-18, LARGEST_THRESHOLD = 1e18;

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
    view = Correspondences();
    view.problem = &problem;
    for (int array = 0; array < 2; ++array)
        view.coordinates[array] = problem.coordinates(array);
    read(points1, points2);
    params.check(view.inputSize);
    pixelThreshold = params.threshold;
    pixels = problem.toModelCoordinates(input, view.inputSize);
    inputThreshold = std::min(pixelThreshold / pixels, DBL_MAX);
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
    const bool two = view.coordinates[1] > 0;
    if (!two && !points2.empty())
        CV_Error_(Error::StsBadArg, ("points2: problem %s has only one list of points", view.problem->name().c_str()));
    const Mat lists[] = {readPoints(points1, view.coordinates[0], "points1"),
                         two ? readPoints(points2, view.coordinates[1], "points2") : Mat()};
    const int count = lists[0].rows;
    if (two && count != lists[1].rows)
        CV_Error_(
            Error::StsUnmatchedSizes,
            ("points1 and points2: lists of the same length are expected, not of %d and %d", count, lists[1].rows));
    view.inputSize = count;
    inputRows.create(view.columns(), std::max(count, 1), CV_64F);
    for (int array = 0, k = 0; array < 2; ++array)
        for (int c = 0; c < view.coordinates[array]; ++c, ++k)
        {
            input[k] = inputRows.ptr<double>(k);
            const double* const from = lists[array].ptr<double>();
            for (int i = 0; i < count; ++i)
                input[k][i] = from[(size_t)i * view.coordinates[array] + c];
        }
}

bool ProblemData::finiteRow(int row) const
{
    bool all = true;
    for (int k = 0; k < view.columns(); ++k)
        all = all && finite(input[k][row]);
    return all;
}

/** Keeps the finite rows in a fixed pseudo-random order (Fisher-Yates), as doubles. */
void ProblemData::shuffle(const Params& params)
{
    const int count = view.inputSize;
    indices.resize(count);
    for (int i = 0; i < count; ++i)
        indices[i] = i;
    int size = count;
    const int columns = view.columns();
    bool all = true;
    for (int k = 0; k < columns; ++k)
        all = all && allFinite(input[k], count);
    if (!all)
    {
        size = 0;
        for (int i = 0; i < count; ++i)
            if (finiteRow(i))
                indices[size++] = i;
        indices.resize(size);
    }
    Rng rng(0x5c3a9d1e, (uint64)size);
    for (int i = size - 1; i > 0; --i)
        std::swap(indices[i], indices[rng.uniform(i + 1)]);

    const int padded = alignSize(std::max(size, 1), 16);
    doubles.create(columns, padded, CV_64F);
    floats.create(columns, padded, CV_32F);
    for (int k = 0; k < columns; ++k)
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
    const int normalization = view.problem->normalization(params.residual), columns = view.columns();
    const int begin[] = {0, view.coordinates[0], columns};
    double center[MAX_COLUMNS], deviation[MAX_COLUMNS], low[MAX_COLUMNS], high[MAX_COLUMNS];
    for (int k = 0; k < columns; ++k)
        robustFrame(doubles.ptr<double>(k), view.size, center[k], deviation[k], low[k], high[k]);
    for (int array = 0; array < 2; ++array)
    {
        Frame& frame = view.frame[array] = Frame();
        if (normalization == SCALE_NONE)
            continue;
        const int source = view.coordinates[array] ? array : 0;
        double size = 0;
        for (int k = begin[source]; k < begin[source + 1]; ++k)
        {
            frame.center[k - begin[source]] = center[k];
            size += deviation[k];
        }
        size /= view.coordinates[source];
        frame.scale = size > 1e-300 ? 1 / size : 1;
    }
    if (normalization == SCALE_COMMON)
        view.frame[0].scale = view.frame[1].scale = std::sqrt(view.frame[0].scale * view.frame[1].scale);
    for (int k = 0; k < columns; ++k)
    {
        const int array = k >= begin[1];
        const double shift = view.frame[array].center[k - begin[array]], factor = view.frame[array].scale;
        scaleColumn(k, shift, factor);
        const double middle = (center[k] - shift) * factor, reach = 5 * deviation[k] * factor;
        view.lower[k] = (float)std::max((low[k] - shift) * factor, middle - reach);
        view.upper[k] = (float)std::min((high[k] - shift) * factor, middle + reach);
    }
    view.threshold = std::min(std::max(inputThreshold * params.reach * view.frame[1].scale, SMALLEST_THRESHOLD),
                              LARGEST_THRESHOLD);
}

void ProblemData::scaleColumn(int k, double shift, double factor)
{
    double* const values = doubles.ptr<double>(k);
    float* const single = floats.ptr<float>(k);
    for (int i = 0; i < view.size; ++i)
    {
        values[i] = (values[i] - shift) * factor;
        single[i] = (float)values[i];
    }
    view.column[k] = single;
    view.exact[k] = values;
}

//! Exact data may ask for 0, which is below the rounding of the errors.
void ProblemData::setThreshold(double threshold)
{
    if (threshold == view.threshold)
        return;
    view.threshold = std::max(threshold, 1e-6);
    inputThreshold = view.threshold / view.frame[1].scale;
    pixelThreshold = inputThreshold * pixels;
}

int ProblemData::independentInliers(const std::vector<uchar>& mask) const
{
    return usacv20::independentInliers(input, view.coordinates, mask.data(), view.inputSize,
                                       view.problem->commonUnit() ? inputThreshold : 0, inputThreshold);
}

int ProblemData::mask(const Residual& residual, const Model& model, std::vector<uchar>& mask) const
{
    const int count = view.inputSize;
    std::vector<double> errors(count);
    residual.squaredErrors(model, input, count, errors.data());
    mask.assign(count, 0);
    int inliers = 0;
    for (int i = 0; i < count; ++i)
        inliers += mask[i] = std::sqrt(errors[i]) <= inputThreshold;  // false for NaN
    return inliers;
}

}  // namespace usacv20
}  // namespace cv
