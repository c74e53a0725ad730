// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_contracts.hpp"

#include <fstream>

// Real matches of test_data/, against ground truth that no estimator has seen.

namespace opencv_test { namespace {

//! One set of test_data/; its README.md says where the numbers come from.
struct RealSet
{
    explicit RealSet(const std::string& name)
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

    //! Mean error in pixels of the check points: transfer distance in image 2, or Sampson's.
    double error(const Mat& estimated) const
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
            scale = (K1.at<double>(0, 0) + K1.at<double>(1, 1) + K2.at<double>(0, 0) + K2.at<double>(1, 1)) / 4;
        }
        for (size_t i = 0; i < p1.size(); ++i)
        {
            const Vec3d x1(p1[i].x, p1[i].y, 1), x2(p2[i].x, p2[i].y, 1), y = M * x1, z = M.t() * x2;
            sum += problem == HOMOGRAPHY
                ? std::hypot(y[0] / y[2] - x2[0], y[1] / y[2] - x2[1])
                : scale * std::abs(x2.dot(y)) / std::sqrt(y[0] * y[0] + y[1] * y[1] + z[0] * z[0] + z[1] * z[1]);
        }
        return sum / p1.size();
    }

    Mat find(UsacV20Method flag, double pixels, OutputArray mask) const
    {
        if (problem == HOMOGRAPHY)
            return findHomography(points1, points2, flag, pixels, mask, 10000, 0.99);
        if (problem == FUNDAMENTAL)
            return findFundamentalMat(points1, points2, flag, pixels, 0.99, 1000, mask);
        return findEssentialMat(points1, points2, K1, d1, K2, d2, flag, 0.99, pixels, mask);
    }

    Mat estimateWith(const Params& params, OutputArray mask, Report& report) const
    {
        if (problem == HOMOGRAPHY)
            return estimateHomography(points1, points2, params, mask, report);
        if (problem == FUNDAMENTAL)
            return estimateFundamental(points1, points2, params, mask, report);
        return estimateEssential(points1, points2, K1, K2, d1, d2, params, mask, report);
    }

    //! The same matches, best score first.
    RealSet sorted() const
    {
        std::vector<std::pair<float, int> > order;
        for (size_t i = 0; i < scores.size(); ++i)
            order.push_back(std::make_pair(scores[i], (int)i));
        std::sort(order.begin(), order.end());
        RealSet result = *this;
        for (size_t i = 0; i < scores.size(); ++i)
        {
            result.points1[i] = points1[order[i].second];
            result.points2[i] = points2[order[i].second];
            result.scores[i] = order[i].first;
        }
        return result;
    }

    ProblemType problem;
    std::vector<Point2d> points1, points2, check1, check2;
    std::vector<float> scores;
    Mat model, K1, K2, d1, d2;
};

//! A set, its inlier threshold, the largest mean error of the check points and the least number of inliers.
struct RealCase
{
    const char* name;
    double threshold, error;
    int inliers;
};

void PrintTo(const RealCase& c, std::ostream* os)
{
    *os << c.name;
}

class UsacReal : public testing::TestWithParam<RealCase>
{
protected:
    UsacReal() : real(GetParam()), set(real.name) {}

    void verify(const char* what, const Mat& model, const Mat& mask) const
    {
        EXPECT_LT(set.error(model), real.error) << what;
        EXPECT_GT(countNonZero(mask), real.inliers) << what;
        if (cvtest::debugLevel > 0)
            printf("%-12s %-16s error %.3f px, %d inliers\n", real.name, what, set.error(model), countNonZero(mask));
    }

    const RealCase real;
    const RealSet set;
};

const RealCase CASES[] = {
    {"graf", 2, 0.6, 235}, {"aloe", 1, 0.3, 265},
    {"office01_F", 1, 1, 265}, {"office12_F", 1, 1, 160},
    {"office01_E", 1, 0.6, 260}, {"office12_E", 1, 0.9, 140}};
INSTANTIATE_TEST_CASE_P(/**/, UsacReal, testing::ValuesIn(CASES));

//! Without this the bounds of the other tests would mean nothing.
TEST_P(UsacReal, truth_fits_the_check_points)
{
    EXPECT_LT(set.error(set.model), 0.2);
    EXPECT_GT(set.error(Mat(Matx33d(1, 2, 3, -1, 4, 5, 2, 1, 1))), real.error);
}

TEST_P(UsacReal, every_flag)
{
    Mat mask;
    verify("USACV20", set.find(USACV20, real.threshold, mask), mask);
    verify("USACV20_FAST", set.find(USACV20_FAST, real.threshold, mask), mask);
    verify("USACV20_ACCURATE", set.find(USACV20_ACCURATE, real.threshold, mask), mask);
    verify("USACV20_PROSAC", set.sorted().find(USACV20_PROSAC, real.threshold, mask), mask);
}

TEST_P(UsacReal, scores)
{
    Params params;
    params.threshold = real.threshold;
    params.scores = set.scores;
    Mat mask;
    Report report;
    verify("scores", set.estimateWith(params, mask, report), mask);
    params.scoreOrder = SCORES_HIGHER_IS_BETTER;
    for (size_t i = 0; i < params.scores.size(); ++i)
        params.scores[i] = 1 - params.scores[i];
    verify("1 - scores", set.estimateWith(params, mask, report), mask);
}

TEST_P(UsacReal, every_seed)
{
    for (int seed = 0; seed < 20; ++seed)
    {
        Params params;
        params.threshold = real.threshold;
        params.seed = seed;
        Mat mask;
        Report report;
        verify(cv::format("seed %d", seed).c_str(), set.estimateWith(params, mask, report), mask);
    }
}

TEST_P(UsacReal, ransac_preset)
{
    Params params = Params::ransac();
    params.threshold = real.threshold;
    params.maxIterations = 10000;
    Mat mask;
    Report report;
    const Mat model = set.estimateWith(params, mask, report);
    EXPECT_LT(set.error(model), 5 * real.error) << "what RANSAC of 1981 reaches";
    EXPECT_GT(countNonZero(mask), 0.8 * real.inliers);
}

}} // namespace
