// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/real_set.hpp"

#include <fstream>

namespace opencv_test {

RealSet::RealSet(const std::string& name)
{
    const std::string base = std::string(USAC_TEST_DATA_DIR) + "/" + name;
    std::ifstream in((base + ".txt").c_str());
    double x1, y1, x2, y2, score;
    while (in >> x1 >> y1 >> x2 >> y2 >> score)
    {
        points1.push_back(Point2d(x1, y1));
        points2.push_back(Point2d(x2, y2));
        scores.push_back((float)score);
    }
    CV_Assert(!points1.empty());
    FileStorage fs(base + ".yml", FileStorage::READ);
    CV_Assert(fs.isOpened());
    const String kind = (String)fs["problem"];
    problem = kind == "H" ? HOMOGRAPHY : kind == "F" ? FUNDAMENTAL : ESSENTIAL;
    Mat rows;
    fs["check"] >> rows;
    for (int i = 0; i < rows.rows; ++i)
    {
        check1.push_back(Point2d(rows.at<float>(i, 0), rows.at<float>(i, 1)));
        check2.push_back(Point2d(rows.at<float>(i, 2), rows.at<float>(i, 3)));
    }
    CV_Assert(check1.size() > 50);
    fs["model"] >> model;
    fs["K1"] >> K1;
    fs["K2"] >> K2;
    fs["d1"] >> d1;
    fs["d2"] >> d2;
}

double RealSet::error(const Mat& estimated) const
{
    if (estimated.empty())
        return 1e9;
    const Matx33d M(estimated.ptr<double>());
    std::vector<Point2d> p1 = check1, p2 = check2;
    double scale = 1, sum = 0;
    if (problem == ESSENTIAL)
    {
        undistortPoints(check1, p1, K1, d1);
        undistortPoints(check2, p2, K2, d2);
        scale = (K1.at<double>(0, 0) + K1.at<double>(1, 1) + K2.at<double>(0, 0) +
                 K2.at<double>(1, 1)) /
                4;
    }
    for (size_t i = 0; i < p1.size(); ++i)
    {
        const Vec3d x1(p1[i].x, p1[i].y, 1), x2(p2[i].x, p2[i].y, 1), y = M * x1, z = M.t() * x2;
        sum += problem == HOMOGRAPHY
                   ? std::hypot(y[0] / y[2] - x2[0], y[1] / y[2] - x2[1])
                   : scale * std::abs(x2.dot(y)) /
                         std::sqrt(y[0] * y[0] + y[1] * y[1] + z[0] * z[0] + z[1] * z[1]);
    }
    return sum / p1.size();
}

Mat RealSet::find(UsacV20Method flag, double pixels, OutputArray mask) const
{
    if (problem == HOMOGRAPHY)
        return findHomography(points1, points2, flag, pixels, mask, 10000, 0.99);
    if (problem == FUNDAMENTAL)
        return findFundamentalMat(points1, points2, flag, pixels, 0.99, 1000, mask);
    return findEssentialMat(points1, points2, K1, d1, K2, d2, flag, 0.99, pixels, mask);
}

Mat RealSet::estimateWith(const Params& params, OutputArray mask, Report& report) const
{
    if (problem == HOMOGRAPHY)
        return estimateHomography(points1, points2, params, mask, report);
    if (problem == FUNDAMENTAL)
        return estimateFundamental(points1, points2, params, mask, report);
    return estimateEssential(points1, points2, K1, K2, d1, d2, params, mask, report);
}

RealSet RealSet::sorted(double part) const
{
    std::vector<std::pair<float, int>> order;
    for (size_t i = 0; i < scores.size(); ++i)
        order.push_back(std::make_pair(scores[i], (int)i));
    std::sort(order.begin(), order.end());
    RealSet result = *this;
    const size_t kept = (size_t)(part * scores.size());
    result.points1.resize(kept);
    result.points2.resize(kept);
    result.scores.resize(kept);
    for (size_t i = 0; i < kept; ++i)
    {
        result.points1[i] = points1[order[i].second];
        result.points2[i] = points2[order[i].second];
        result.scores[i] = order[i].first;
    }
    return result;
}

}  // namespace opencv_test
