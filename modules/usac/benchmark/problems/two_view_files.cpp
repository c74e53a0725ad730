// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "two_view_files.hpp"

#include <stdexcept>

namespace benchmark {

namespace {

void readTruePoints(const Json& json, ImagePair& pair)
{
    if (json.isNull())
        return;
    const std::vector<Json>& rows = json.array();
    for (size_t i = 0; i < rows.size(); ++i)
    {
        const std::vector<Json>& v = rows[i].array();
        if (v.size() != 4)
            throw std::runtime_error("expected [x1, y1, x2, y2]");
        pair.truth1.push_back(cv::Point2d(v[0].number(), v[1].number()));
        pair.truth2.push_back(cv::Point2d(v[2].number(), v[3].number()));
    }
}

}  // namespace

void readCorrespondences(const std::string& file, ImagePair& pair)
{
    readRows(file, 5, [&](const NumberRow& row) {
        if (row.count != 5 && row.count != 4)
            failAt(file, row.line, "expected 'x1 y1 x2 y2 score'");
        const double* const v = row.values;
        pair.points1.push_back(cv::Point2f((float)v[0], (float)v[1]));
        pair.points2.push_back(cv::Point2f((float)v[2], (float)v[3]));
        pair.scores.push_back(row.count == 5 ? (float)v[4] : 1.f);
    });
    if (pair.points1.empty())
        failAt(file, 1, "no correspondences");
}

void readTwoViewTruth(const TruthReader& in, char letter, ImagePair& pair)
{
    bool hasK1 = false, hasK2 = false, hasR = false, hasT = false;
    in.read("size1", [&](const Json& v) { pair.size1 = toSize(v); });
    in.read("size2", [&](const Json& v) { pair.size2 = toSize(v); });
    in.read("H", [&](const Json& v) { pair.hasHomography = toMatrix(v, pair.H); });
    in.read("K1", [&](const Json& v) { hasK1 = toMatrix(v, pair.K1); });
    in.read("K2", [&](const Json& v) { hasK2 = toMatrix(v, pair.K2); });
    in.read("R", [&](const Json& v) { hasR = toMatrix(v, pair.R); });
    in.read("t", [&](const Json& v) { hasT = toVector(v, pair.t); });
    in.read("gt_points", [&](const Json& v) { readTruePoints(v, pair); });
    in.read("gt_kind", [&](const Json& v) {
        pair.truthIsHomography = !v.isNull() && v.string() == "homography";
    });
    in.requireProblem(letter);

    pair.hasCamera1 = hasK1;
    pair.hasCamera2 = hasK2;
    pair.hasPose = hasK1 && hasK2 && hasR && hasT;
}

void checkTruePoints(const TruthReader& in, const ImagePair& pair)
{
    in.require(!pair.truth1.empty(), "gt_points", "none, the error cannot be measured");
    in.require(pair.hasHomography || !pair.truthIsHomography, "H",
               "needed because gt_kind is homography");
}

}  // namespace benchmark
