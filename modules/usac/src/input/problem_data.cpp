// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "input/match_noise.hpp"
#include "input/problem_data.hpp"
#include "input/read_arrays.hpp"
#include "numeric/instruction_set.hpp"
#include "input/robust_frame.hpp"
#include "components/repetitions.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! In each coordinate, the box of the points (Correspondences::lower and upper) extends at most
//! this many mean (or median, see robustFrame()) absolute deviations from the center, however far
//! away the outermost points are. See doc/constants.md.
constexpr double FRAME = 5;
//! Bounds of the threshold of the search, in normalized coordinates: the squared threshold and its
//! inverse must be neither 0 nor infinite as float. The mask uses the caller's threshold unchanged.
constexpr double SMALLEST_THRESHOLD = 1e-18, LARGEST_THRESHOLD = 1e18;

bool finite(double value)
{
    return std::abs(value) <= DBL_MAX;  // NaN is not finite
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
    return zeros[0] + zeros[1] + zeros[2] + zeros[3] == 0;  // NaN or infinity times 0 is NaN
}

template <class T>
void copyColumn(const Mat& rows, int column, double* values)
{
    const T* const from = rows.ptr<T>();
    for (int i = 0; i < rows.rows; ++i)
        values[i] = from[(size_t)i * rows.cols + column];
}

//! A threshold of at least this fraction of the longest side of the box of the points is wide
//! (Report::wideThreshold): along this side, all points are within the threshold of the center. If
//! the fraction were 0.25, a threshold of 160 pixels would be wide in an image of 640 pixels. If it
//! were 1, a threshold of 1.5 pixels would not be wide for points that are wrongly given on the
//! normalized image plane, where a field of view of 90 degrees has a width of 2.
constexpr double WIDE = 0.5;

//! If there are more than ProblemData::SEARCHED points, runs of this many rows stay together,
//! except for the first points. This takes a fraction of the time, because the rows of a run are in
//! the same lines of the cache.
constexpr int RUN = 16;

/** Fisher-Yates shuffle. If there are more than SEARCHED rows, runs of rows are shuffled, and then
the first SEARCHED rows are drawn one by one from all rows. The first n rows are thus a random
sample of all rows for every n, of single rows up to SEARCHED, of runs beyond; only the last rows,
fewer than a run, stay at the end. */
void shuffleRows(int* rows, int size)
{
    Rng rng(0x5c3a9d1e, (uint64)size);
    if (size <= ProblemData::SEARCHED)
    {
        for (int i = size - 1; i > 0; --i)
            std::swap(rows[i], rows[rng.uniform(i + 1)]);
        return;
    }
    for (int i = size / RUN - 1; i > 0; --i)
    {
        const int other = rng.uniform(i + 1);
        if (other != i)
            std::swap_ranges(rows + i * RUN, rows + (i + 1) * RUN, rows + other * RUN);
    }
    for (int i = 0; i < ProblemData::SEARCHED; ++i)
        std::swap(rows[i], rows[i + rng.uniform(size - i)]);
}

//! Number of rows whose errors are computed together for the mask. The value has no effect on the
//! result.
constexpr int ERROR_BLOCK = 1024;

/** Memory in bytes. OF_POINT is for each point: 88 bytes for the point itself and 150 for temporary
data, mostly of polishing and significance. OF_SEARCH is for each point of the search: 62 bytes for
order and graph, 28 for sampler and checks, and a reserve of 24. OF_RUN is for batches, runners-up
and tables, OF_PLANES for the search for planes, and OF_BATCH, with several threads, for the
hypotheses of the largest batch. If a value is too small, the only effect is that another block is
allocated; memory that is never written to costs no time. */
constexpr size_t OF_POINT = 238, OF_SEARCH = 114, OF_RUN = 64 << 10, OF_PLANES = 160 << 10,
                 OF_BATCH = 512 << 10;

//! Number of bytes of arena memory that a run with this many points usually needs.
size_t runMemory(int points, const Params& params)
{
    size_t bytes = (size_t)points * OF_POINT +
                   std::min<int>(points, ProblemData::SEARCHED) * OF_SEARCH + OF_RUN;
    if (params.degeneracy & DEGENERACY_DEGENSAC)
        bytes += OF_PLANES;
    if (params.threads != 1)
        bytes += OF_BATCH;
    return bytes;
}

}  // namespace

ProblemData::ProblemData()
    : view(), part(), givenThreshold(), givenReach(1), currentReach(1), inputThreshold(0),
      pixelThreshold(0), pixels(1), input(), doubles(), floats(), seen(), seenDoubles(),
      seenFloats(), usable(0), different(0), described(0)
{}

void ProblemData::read(const Problem& problem, InputArray points1, InputArray points2,
                       const Params& params, Arena& arena, bool image)
{
    view = Correspondences();  // no points if an exception is thrown below
    usable = different = 0;
    view.problem = &problem;
    for (int array = 0; array < 2; ++array)
        view.coordinates[array] = problem.coordinates(array);
    part = view;
    readRows(points1, points2, params, arena);
    pixelThreshold = params.threshold;
    readNoise(params, arena);
    if (image)
        keepImage(params, arena);
    pixels = problem.toModelCoordinates(input, view.inputSize) / view.meanSigma;
    doubt = problem.doubt(input, view.inputSize);
    inputThreshold = std::min(pixelThreshold / pixels, DBL_MAX);
    shuffle(params, arena);
    scale(params, arena);
    part = view;
    part.size = std::min<int>(view.size, SEARCHED);
    if (image)
        shuffleImage(arena);
    givenReach = currentReach = params.reach;
    givenThreshold[0] = view.threshold;
    givenThreshold[1] = inputThreshold;
    givenThreshold[2] = pixelThreshold;
    arena.keep();
}

void ProblemData::restoreThreshold()
{
    setSearchThreshold(givenThreshold[0]);
    currentReach = givenReach;
    inputThreshold = givenThreshold[1];
    pixelThreshold = givenThreshold[2];
}

void ProblemData::readRows(InputArray points1, InputArray points2, const Params& params,
                           Arena& arena)
{
    const bool two = view.coordinates[1] > 0;
    if (!two && !points2.empty())
        CV_Error_(Error::StsBadArg, ("points2: problem %s has only one list of points",
                                     view.problem->name().c_str()));
    const Mat given[] = {points1.getMat(), two ? points2.getMat() : Mat()};
    size_t most = 0;
    for (int array = 0; array < 2; ++array)
        most = std::max(most, given[array].total() * given[array].channels() /
                                  std::max(view.coordinates[array], 1));
    arena.reset(runMemory((int)std::min<size_t>(most, INT_MAX), params));
    Arena::Scope scope(arena);
    const String names[] = {view.problem->arrayName(0), view.problem->arrayName(1)};
    const Mat lists[] = {
        readPoints(given[0], view.coordinates[0], names[0].c_str(), scope, true),
        two ? readPoints(given[1], view.coordinates[1], names[1].c_str(), scope, true) : Mat()};
    const int count = lists[0].rows;
    if (two && count != lists[1].rows)
        CV_Error_(Error::StsUnmatchedSizes,
                  ("%s and %s: lists of the same length are expected, not of %d and %d",
                   names[0].c_str(), names[1].c_str(), count, lists[1].rows));
    params.check(count);
    checkNoise(params, count);
    view.inputSize = count;
    for (int array = 0, k = 0; array < 2; ++array)
        for (int c = 0; c < view.coordinates[array]; ++c, ++k)
        {
            input[k] = arena.take<double>(count);
            if (lists[array].depth() == CV_32F)
                copyColumn<float>(lists[array], c, input[k]);
            else
                copyColumn<double>(lists[array], c, input[k]);
        }
}

//! Raises a cv::Exception if Params::sigmas cannot be the noise of `count` matches, or if they
//! describe points that were read before and had a different number of matches.
void ProblemData::checkNoise(const Params& params, int count)
{
    MatchNoise::columnsOf(*view.problem, params.sigmas, count);
    if (described > 0 && !params.sigmas.empty() && count != described)
        CV_Error_(Error::StsUnmatchedSizes,
                  ("sigmas: they describe %d correspondences, not %d", described, count));
    described = count;
}

//! Stores the noise of the matches if there are Params::sigmas. Its unit is
//! Correspondences::meanSigma, so that the volume (area, length) of the errors within the
//! threshold, averaged over the matches, is the same as if all sigmas were equal to meanSigma.
//! Problem::randomInlierRatio therefore needs no change.
void ProblemData::readNoise(const Params& params, Arena& arena)
{
    view.meanSigma = 1;
    view.noise = MatchNoise::columnsOf(*view.problem, params.sigmas, view.inputSize);
    if (view.noise == 0)
        return;
    const MatchNoise given(*view.problem, params.sigmas, view.inputSize);
    view.meanSigma = given.mean();
    double** const columns = input + view.columns();
    for (int k = 0; k < view.noise; ++k)
        columns[k] = arena.take<double>(view.inputSize);
    given.toColumns(input, false, columns, arena);
}

//! Stores the original image points and, if there are Params::sigmas, the noise of the matches.
void ProblemData::keepImage(const Params& params, Arena& arena)
{
    double* columns[MAX_COLUMNS];
    const int first = view.coordinates[0], count = view.inputSize;
    for (int k = 0; k < view.noise; ++k)
        seen[view.coordinates[1] + k] = arena.take<double>(count);
    if (view.noise > 0)
        MatchNoise(*view.problem, params.sigmas, count)
            .toColumns(input, true, seen + view.coordinates[1], arena);
    std::copy(input, input + first, columns);
    for (int k = 0; k < view.coordinates[1]; ++k)
    {
        columns[first + k] = seen[k] = arena.take<double>(count);
        std::copy(input[first + k], input[first + k] + count, seen[k]);
    }
    view.problem->toImageCoordinates(columns, count);
}

//! Stores the original image points and the noise of the matches with the rows, order and
//! normalization of points().
void ProblemData::shuffleImage(Arena& arena)
{
    const Frame& frame = view.frame[1];
    for (int k = 0; k < view.coordinates[1] + view.noise; ++k)
    {
        const bool point = k < view.coordinates[1];
        const double center = point ? frame.center[k] : 0, factor = point ? frame.scale : 1;
        double* const exact = arena.take<double>(usable);
        float* const single = arena.take<float>(usable);
        for (int i = 0; i < usable; ++i)
        {
            exact[i] = (seen[k][view.inputIndex[i]] - center) * factor;
            single[i] = (float)exact[i];
        }
        seenDoubles[k] = exact;
        seenFloats[k] = single;
    }
}

Correspondences ProblemData::imagePoints() const
{
    Correspondences points = view;
    for (int k = 0; k < view.coordinates[1] + view.noise; ++k)
    {
        points.exact[view.coordinates[0] + k] = seenDoubles[k];
        points.column[view.coordinates[0] + k] = seenFloats[k];
    }
    return points;
}

//! True if all numbers of a row are finite and, if there are covariances, that of the point in the
//! last array is not singular.
bool ProblemData::usableRow(int row) const
{
    bool all = true;
    for (int k = 0; k < view.numbers(); ++k)
        all = all && finite(input[k][row]);
    const int root = view.columns();
    return all && (view.noise < 2 || (input[root][row] > 0 && input[root + 2][row] > 0));
}

//! Lists the usable rows in ascending order. @return their number
int ProblemData::usableRows(int* rows) const
{
    bool all = view.noise < 2;
    for (int k = 0; k < view.columns(); ++k)
        all = all && allFinite(input[k], view.inputSize);
    int size = 0;
    for (int i = 0; i < view.inputSize; ++i)
        if (all || usableRow(i))
            rows[size++] = i;
    return size;
}

/** Copies the usable rows (usableRow()), as doubles, in a fixed pseudo-random order, see
shuffleRows(). The search, polishing and significance rely on this order: they use the first points
as a random sample of all points. Repetitions of frequent matches come last. */
void ProblemData::shuffle(const Params& params, Arena& arena)
{
    const int count = view.inputSize;
    int* const indices = arena.take<int>(count);
    const int size = usable = different = usableRows(indices);
    shuffleRows(indices, size);
    int frequent[MOST_FREQUENT];
    const int repeated = params.degeneracy & DEGENERACY_REPEATED
                             ? frequentMatches(input, view.numbers(), indices,
                                               std::min<int>(size, SEARCHED), frequent)
                             : 0;
    if (repeated > 0)
    {
        const auto notRepeated = [&](int row) {
            return !repeatsAny(input, view.numbers(), row, frequent, repeated);
        };
        usableRows(indices);
        different = (int)(std::partition(indices, indices + size, notRepeated) - indices);
        shuffleRows(indices, different);
    }
    view.size = different;
    const int padded = alignSize(std::max(size, 1), 16);
    for (int k = 0; k < view.numbers(); ++k)
    {
        double* const shuffled = doubles[k] = arena.take<double>(padded);
        floats[k] = arena.take<float>(padded);
        for (int i = 0; i < size; ++i)
            shuffled[i] = input[k][indices[i]];
        std::fill(shuffled + size, shuffled + padded, 0.);
        std::fill(floats[k] + size, floats[k] + padded, 0.f);
    }
    float* scores = 0;
    if (!params.scores.empty() && size > 0)
    {
        scores = arena.take<float>(size);
        const float sign = params.scoreOrder == SCORES_HIGHER_IS_BETTER ? -1.f : 1.f;
        for (int i = 0; i < size; ++i)
        {
            const float score = sign * params.scores[indices[i]];
            scores[i] = score == score ? score : FLT_MAX;
        }
    }
    view.inputIndex = indices;
    view.scores = scores;
}

//! Centers the points and scales them to unit size, as far as Problem::normalization allows.
void ProblemData::scale(const Params& params, Arena& arena)
{
    const int normalization = view.problem->normalization(params.residual),
              columns = view.columns();
    const int begin[] = {0, view.coordinates[0], columns};
    double center[MAX_COLUMNS], deviation[MAX_COLUMNS], low[MAX_COLUMNS], high[MAX_COLUMNS];
    for (int k = 0; k < columns; ++k)
        robustFrame(doubles[k], std::min<int>(view.size, SEARCHED), center[k], deviation[k], low[k],
                    high[k], arena);
    for (int array = 0; array < 2; ++array)
    {
        Frame& frame = view.frame[array] = Frame();
        const int source = view.coordinates[array] ? array : 0;
        if (normalization == SCALE_NONE || (normalization == SCALE_FIRST && source == 1))
            continue;
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
        view.frame[0].scale = view.frame[1].scale = std::sqrt(view.frame[0].scale *
                                                              view.frame[1].scale);
    for (int k = 0; k < columns; ++k)
    {
        const int array = k >= begin[1];
        const double shift = view.frame[array].center[k - begin[array]],
                     factor = view.frame[array].scale;
        scaleColumn(k, shift, factor);
        const double middle = (center[k] - shift) * factor, reach = FRAME * deviation[k] * factor;
        view.lower[k] = (float)std::max((low[k] - shift) * factor, middle - reach);
        view.upper[k] = (float)std::min((high[k] - shift) * factor, middle + reach);
    }
    for (int k = 0; k < view.noise; ++k)  // the last three of six are for array 0
        scaleColumn(columns + k, 0, k < 3 ? 1 : view.frame[0].scale / view.frame[1].scale);
    view.unit = view.frame[1].scale / pixels;
    view.threshold = std::min(
        std::max(inputThreshold * params.reach * view.frame[1].scale, SMALLEST_THRESHOLD),
        LARGEST_THRESHOLD);
}

void ProblemData::scaleColumn(int k, double shift, double factor)
{
    double* const values = doubles[k];
    float* const single = floats[k];
    for (int i = 0; i < usable; ++i)
    {
        values[i] = (values[i] - shift) * factor;
        single[i] = (float)values[i];
    }
    view.column[k] = single;
    view.exact[k] = values;
}

//! The lower bound 1e-6 is for noise-free data, for which a threshold below the rounding errors
//! might be estimated. The upper bounds DBL_MAX prevent an overflow if the points are so far apart
//! that their scale is 0.
void ProblemData::setThreshold(double threshold)
{
    if (threshold == view.threshold)
        return;
    setSearchThreshold(std::max(threshold, 1e-6));
    inputThreshold = std::min(view.threshold / view.frame[1].scale, DBL_MAX);
    pixelThreshold = std::min(inputThreshold * pixels, DBL_MAX);
}

void ProblemData::scaleThreshold(double factor)
{
    setSearchThreshold(std::max(givenThreshold[0] * factor, std::min(givenThreshold[0], 1e-6)));
    inputThreshold = givenThreshold[1] * factor;
    pixelThreshold = givenThreshold[2] * factor;
}

bool ProblemData::wideThreshold() const
{
    const int first = view.coordinates[1] ? view.coordinates[0] : 0;
    double longest = 0;
    for (int k = first; k < view.columns(); ++k)
        longest = std::max(longest, (double)view.upper[k] - view.lower[k]);
    return view.size > 0 && maskThreshold() >= WIDE * longest;
}

int ProblemData::independentInliers(const uchar* mask, Arena& arena) const
{
    const double side = inliersAreNearAPoint(*view.problem) ? 0 : inputThreshold;
    return usacv20::independentInliers(input, view.coordinates, mask, view.inputSize,
                                       view.problem->commonUnit() ? side : 0, side, arena);
}

void ProblemData::tell(const uchar* mask, bool independent, Arena& arena, Report& report) const
{
    report.inlierRatio = view.inputSize > 0 ? (double)report.inliers / view.inputSize : 0;
    report.threshold = threshold();
    report.wideThreshold = report.stop != STOP_TOO_FEW_POINTS && wideThreshold();
    report.warning = doubt;
    if (report.wideThreshold)
        report.warning += String(doubt.empty() ? "" : "; ") +
                          "the threshold is as large as the extent of all points: is it in their "
                          "unit?";
    if (independent)
        report.independentInliers = independentInliers(mask, arena);
}

int ProblemData::mask(const Residual& residual, const Model& model, bool image, uchar* mask) const
{
    int inliers = 0;
    for (int first = 0; first < view.inputSize; first += ERROR_BLOCK)
    {
        const int count = std::min(view.inputSize - first, ERROR_BLOCK);
        double distances[ERROR_BLOCK];
        errors(residual, model, image, first, count, distances);
        for (int i = 0; i < count; ++i)  // NaN does not count as an inlier
            inliers += mask[first + i] = distances[i] <= pixelThreshold;
    }
    return inliers;
}

void ProblemData::errors(const Residual& residual, const Model& model, bool image,
                         double* distances) const
{
    errors(residual, model, image, 0, view.inputSize, distances);
}

void ProblemData::errors(const Residual& residual, const Model& model, bool image, int first,
                         int count, double* distances) const
{
    const double* columns[MAX_COLUMNS];
    std::copy(input, input + view.numbers(), columns);
    if (image)
        std::copy(seen, seen + view.coordinates[1] + view.noise, columns + view.coordinates[0]);
    for (int k = 0; k < view.numbers(); ++k)
        columns[k] += first;
    residual.squaredErrors(model, columns, count, distances);
    for (int i = 0; i < count; ++i)
        distances[i] = std::sqrt(distances[i]) * pixels;
}

}  // namespace usacv20
}  // namespace cv
