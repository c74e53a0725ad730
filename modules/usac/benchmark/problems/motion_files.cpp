// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "motion_files.hpp"

#include <cmath>
#include "view_files.hpp"

namespace benchmark {

namespace {

//! Root mean square distance of the right points of space 2 from their mean; of all points if it is
//! unknown which are right.
double sizeOf(const ImagePair& pair, const std::vector<int>& right)
{
    const int count = right.empty() ? pair.size() : (int)right.size();
    cv::Point3d mean;
    double squares = 0;
    for (int i = 0; i < count; ++i)
        mean += cv::Point3d(pair.spacePoints2[right.empty() ? i : right[i]]) / count;
    for (int i = 0; i < count; ++i)
    {
        const cv::Point3d d = cv::Point3d(pair.spacePoints2[right.empty() ? i : right[i]]) - mean;
        squares += d.dot(d) / count;
    }
    return std::sqrt(squares);
}

}  // namespace

void readSpacePoints(const std::string& file, ImagePair& pair)
{
    readRows(file, 6, [&](const NumberRow& row) {
        if (row.count != 6)
            failAt(file, row.line, "expected 'X1 Y1 Z1 X2 Y2 Z2'");
        const double* const v = row.values;
        pair.objectPoints.push_back(cv::Point3f((float)v[0], (float)v[1], (float)v[2]));
        pair.spacePoints2.push_back(cv::Point3f((float)v[3], (float)v[4], (float)v[5]));
    });
    if (pair.spacePoints2.empty())
        failAt(file, 1, "no correspondences");
}

void readMotionTruth(const TruthReader& in, char letter, bool scaled, ImagePair& pair)
{
    bool hasR = false, hasT = false;
    in.requireProblem(letter);
    in.read("s", [&](const Json& v) { pair.scale = v.isNull() ? 1 : v.number(); });
    in.read("R", [&](const Json& v) { hasR = toMatrix(v, pair.R); });
    in.read("t", [&](const Json& v) { hasT = toVector(v, pair.t); });
    in.read("gt_mask", [&](const Json& v) { readIndices(v, pair.size(), pair.right); });
    in.require(pair.scale > 0, "s", "expected a number above 0");
    in.require(scaled || pair.scale == 1, "s", std::string("expected 1 for ") + letter);
    in.require(hasR, "R", "needed");
    in.require(hasT, "t", "needed");
    pair.hasPose = true;
    pair.depth = sizeOf(pair, pair.right);
    in.require(pair.depth > 0, "gt_mask",
               "the scene is one point, because all right points of space 2 are equal");
}

}  // namespace benchmark
