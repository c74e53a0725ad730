// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "fuzz/fuzz_input.hpp"

#include <algorithm>
#include "fuzz/fuzz_bytes.hpp"
#include "fuzz/fuzz_pose.hpp"
#include "fuzz/fuzz_rigid.hpp"
#include "support/params_fields.hpp"
#include "support/scenes.hpp"

using namespace cv::usacv20;
using cv::Mat;
using cv::Point2d;

namespace opencv_test {

namespace {

Params preset(int number)
{
    static Params (*const presets[])() = {
        Params::usacV20,   Params::fast,          Params::accurate, Params::sorted,
        Params::parallel,  Params::ransac,        Params::msac,     Params::lmeds,
        Params::mlesac,    Params::prosac,        Params::loRansac, Params::floRansac,
        Params::gcRansac,  Params::usac2013,      Params::magsac,   Params::magsacPlusPlus,
        Params::automatic, Params::trustedScores, Params::paper};
    // numbers below 192 never select the last three presets, which are newer than the stored inputs
    return presets[number < 192 ? number % 16 : number > 250 ? 18 : 16 + number % 2]();
}

//! Reduces a valid value (from `low` to `high`) that exceeds `most` to less than `low` + `most`. An
//! invalid value does not change.
void reduce(int& value, int low, int high, int most)
{
    if (value >= low && value <= high && value > most)
        value = low + value % most;
}

Params readParams(Bytes& bytes)
{
    Params params = preset(bytes.byte());
    params.maxIterations = 20;
    static const Fields fields;
    const int ints = (int)fields.ints.size();
    for (int changes = bytes.below(8); changes > 0; --changes)
    {
        const int field = bytes.below(ints + (int)fields.doubles.size());
        if (field < ints)
            Assignment(params, fields.ints[field].name, bytes.integer());
        else
            Assignment(params, fields.doubles[field - ints].name, bytes.number());
    }
    reduce(params.maxIterations, 1, INT_MAX, 100);
    reduce(params.localIterations, 1, 1000, 10);
    reduce(params.localSamples, 0, 1000, 10);
    reduce(params.threads, 0, 1024, 3);
    return params;
}

void readScores(Bytes& bytes, size_t count, Params& params)
{
    const int kind = bytes.byte();
    if (kind < 160)
        return;
    if (kind > 250)
        ++count;
    for (size_t i = 0; i < count; ++i)
        params.scores.push_back(kind < 220 ? (float)bytes.byte() / 16 : (float)bytes.number());
}

Mat readCamera(Bytes& bytes)
{
    cv::Matx33d K(500, 0, 320, 0, 500, 240, 0, 0, 1);
    for (int changes = std::max(bytes.below(8) - 3, 0); changes > 0; --changes)
    {
        const int entry = bytes.below(9);
        K.val[entry] = bytes.number();
    }
    return Mat(K, true);
}

Mat readDistortion(Bytes& bytes)
{
    static const int lengths[] = {0, 0, 0, 0, 0, 0, 4, 5, 8, 12, 14, 3};
    Mat coefficients(1, lengths[bytes.below(12)], CV_64F);
    for (int i = 0; i < coefficients.cols; ++i)
    {
        const int value = bytes.value<schar>();
        coefficients.at<double>(i) = value == SCHAR_MIN
                                         ? bytes.number()
                                         : value * value * value / (1e6 * (i > 3 ? 100 : 1));
    }
    return coefficients;
}

//! Reads the options of a scene with true and wrong matches, and makes this scene.
void readScene(Bytes& bytes, FuzzInput& input)
{
    SceneOptions options;
    options.inliers = 1 + bytes.below(60);
    options.outliers = bytes.below(40);
    options.noise = bytes.below(8) / 4.;
    options.seed = (uint64)bytes.byte();
    options.planeFraction = bytes.below(5) / 4.;
    options.duplicates = bytes.below(8) * options.inliers / 8;
    options.angle = bytes.below(3) * 12;
    const Scene scene = makeScene(input.problem, options);
    input.points1 = scene.points1;
    input.points2 = scene.points2;
}

//! Makes at most one change: of one or two rows, of all rows, or of the number of rows.
void edit(Bytes& bytes, std::vector<Point2d>& points1, std::vector<Point2d>& points2)
{
    if (points1.empty() || points2.empty())
        return;
    const int kind = bytes.below(8);
    std::vector<Point2d>& points = bytes.below(2) ? points1 : points2;
    const int row = bytes.byte() % (int)points.size(), other = bytes.byte() % (int)points.size();
    if (kind == 0)
        (other % 2 ? points[row].x : points[row].y) = bytes.number();
    else if (kind == 1)
        points[row] = points[other];
    else if (kind == 2)
        for (int i = 0; i < other % 64; ++i)
        {
            points1.push_back(points1[row % points1.size()]);
            points2.push_back(points2[row % points2.size()]);
        }
    else if (kind == 3)
        points.resize(bytes.below(16) == 0 ? other : points.size());
    else if (kind == 4)
        std::swap(points[row], points[other]);
    else
    {
        const double number = bytes.number();
        for (size_t i = 0; i < points.size(); ++i)
            points[i] = kind == 5   ? points[i] * number
                        : kind == 6 ? points[i] + Point2d(number, 0)
                                    : Point2d(points[i].x, number);
    }
}

void readPoints(Bytes& bytes, FuzzInput& input)
{
    const int kind = bytes.kindOfPoints(), edits = std::max(bytes.below(16) - 4, 0),
              most = bytes.below(120);
    if (kind > 5)
        readScene(bytes, input);
    for (int i = 0; i < most && bytes.left() > 0; ++i)
    {
        const double x1 = bytes.coordinate(kind % 6), y1 = bytes.coordinate(kind % 6);
        const double x2 = bytes.coordinate(kind % 6), y2 = bytes.coordinate(kind % 6);
        input.points1.push_back(Point2d(x1, y1));
        input.points2.push_back(Point2d(x2, y2));
    }
    for (int i = 0; i < edits; ++i)
        edit(bytes, input.points1, input.points2);
}

}  // namespace

FuzzInput readFuzzInput(const uchar* data, size_t size)
{
    Bytes bytes(data, size);
    FuzzInput input;
    // not the byte modulo the number of problems, because the stored inputs depend on this mapping
    const int problem = bytes.byte();
    const bool space = problem == 6 || problem == 7 || (problem > 64 && problem < 89);
    input.problem = space ? (problem % 2 ? SIMILARITY_3D : RIGID_3D)
                    : problem == 5 || (problem > 96 && problem < 128) ? ABSOLUTE_POSE
                    : problem == 3 || problem == 4 || (problem >= 128 && problem < 240)
                        ? (ProblemType)(problem % 2 ? AFFINITY : SIMILARITY)
                        : (ProblemType)(problem % 3);
    input.otherThreads = bytes.below(8) == 7 ? 3 : 1;
    input.params = readParams(bytes);
    if (input.problem == ESSENTIAL || input.problem == ABSOLUTE_POSE)
    {
        input.K1 = readCamera(bytes);
        if (input.problem == ESSENTIAL && bytes.below(2))
            input.K2 = readCamera(bytes);
        input.d1 = readDistortion(bytes);
        if (input.problem == ESSENTIAL)
            input.d2 = readDistortion(bytes);
    }
    if (input.problem == ABSOLUTE_POSE)
        readPosePoints(bytes, input);
    else if (space)
        readSpacePoints(bytes, input);
    else
        readPoints(bytes, input);
    readScores(bytes, space ? input.space2.size() : input.points2.size(), input.params);
    return input;
}

}  // namespace opencv_test
