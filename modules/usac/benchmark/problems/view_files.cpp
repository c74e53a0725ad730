// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "view_files.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace benchmark {

namespace {

void readDistortion(const Json& json, std::vector<double>& distortion)
{
    if (json.isNull())
        return;
    for (const Json& value : json.array())
        distortion.push_back(value.number());
    const size_t count = distortion.size();
    if (count != 4 && count != 5 && count != 8 && count != 12 && count != 14)
        throw std::runtime_error("expected 4, 5, 8, 12 or 14 coefficients");
}

//! Median depth of the right matches along the camera's axis; of all matches if it is unknown which
//! are right.
double depthOf(const ImagePair& pair, const std::vector<int>& right)
{
    std::vector<double> depths;
    for (size_t i = 0; i < (right.empty() ? pair.objectPoints.size() : right.size()); ++i)
    {
        const cv::Point3d X = pair.objectPoints[right.empty() ? (int)i : right[i]];
        depths.push_back(pair.R(2, 0) * X.x + pair.R(2, 1) * X.y + pair.R(2, 2) * X.z + pair.t[2]);
    }
    std::nth_element(depths.begin(), depths.begin() + depths.size() / 2, depths.end());
    return depths[depths.size() / 2];
}

}  // namespace

void readObjectPoints(const std::string& file, ImagePair& pair)
{
    readRows(file, 5, [&](const NumberRow& row) {
        if (row.count != 5)
            failAt(file, row.line, "expected 'X Y Z u v'");
        const double* const v = row.values;
        pair.objectPoints.push_back(cv::Point3f((float)v[0], (float)v[1], (float)v[2]));
        pair.points2.push_back(cv::Point2f((float)v[3], (float)v[4]));
    });
    if (pair.points2.empty())
        failAt(file, 1, "no correspondences");
}

void readScores(const std::string& file, ImagePair& pair)
{
    pair.scores.assign(pair.size(), 1.f);
    if (!std::ifstream(file.c_str()))
        return;
    size_t count = 0;
    int last = 1;
    readRows(file, 1, [&](const NumberRow& row) {
        if (row.count != 1)
            failAt(file, row.line, "expected a score");
        if (count < pair.scores.size())
            pair.scores[count] = (float)row.values[0];
        ++count;
        last = row.line;
    });
    if (count != pair.scores.size())
        failAt(file, last,
               cv::format("%d scores, but %d correspondences", (int)count, pair.size()));
}

void readIndices(const Json& json, int size, std::vector<int>& indices)
{
    if (json.isNull())
        return;
    for (const Json& value : json.array())
    {
        const double index = value.number();
        if (!(index >= 0 && index < size && index == (int)index))
            throw std::runtime_error("expected numbers of matches, counted from 0");
        indices.push_back((int)index);
    }
}

void readViewTruth(const TruthReader& in, char letter, ImagePair& pair)
{
    bool hasR = false, hasT = false;
    std::vector<int> right, near;
    in.requireProblem(letter);
    in.read("K", [&](const Json& v) { pair.hasCamera2 = toMatrix(v, pair.K2); });
    in.read("distCoeffs", [&](const Json& v) { readDistortion(v, pair.distortion); });
    in.read("R", [&](const Json& v) { hasR = toMatrix(v, pair.R); });
    in.read("t", [&](const Json& v) { hasT = toVector(v, pair.t); });
    in.read("gt_mask", [&](const Json& v) { readIndices(v, pair.size(), right); });
    in.read("gt_inliers_3px", [&](const Json& v) { readIndices(v, pair.size(), near); });
    in.require(pair.hasCamera2, "K", "needed");
    in.require(hasR, "R", "needed");
    in.require(hasT, "t", "needed");
    pair.hasPose = true;
    pair.depth = depthOf(pair, right.empty() ? near : right);
    in.require(pair.depth > 0, "t", "the scene is behind the camera");
}

}  // namespace benchmark
