// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_precomp.hpp"

#include <fstream>

namespace opencv_test {
namespace {

//! This module's flags as numbers, so that they can be in one list with OpenCV's flags.
enum {
    USACV20 = (int)cv::USACV20,
    USACV20_FAST = (int)cv::USACV20_FAST,
    USACV20_ACCURATE = (int)cv::USACV20_ACCURATE
};
CV_ENUM(Method, RANSAC, USAC_DEFAULT, USAC_FAST, USAC_ACCURATE, USAC_MAGSAC, USACV20, USACV20_FAST,
        USACV20_ACCURATE)
typedef TestBaseWithParam<Method> UsacMethod;

//! A data set of test_data/, enlarged to `repeat` times its size: each copy has Gaussian offsets of
//! standard deviation 0.1 pixels from the copy before it.
struct PerfSet
{
    PerfSet(const std::string& name, int repeat)
    {
        const std::string base = std::string(USAC_TEST_DATA_DIR) + "/" + name;
        std::ifstream in((base + ".txt").c_str());
        double x1, y1, x2, y2, score;
        while (in >> x1 >> y1 >> x2 >> y2 >> score)
        {
            points1.push_back(Point2f((float)x1, (float)y1));
            points2.push_back(Point2f((float)x2, (float)y2));
        }
        CV_Assert(!points1.empty());
        RNG rng(1);
        const int size = (int)points1.size();
        for (int i = 0; i < size * (repeat - 1); ++i)
        {
            points1.push_back(points1[i] +
                              Point2f((float)rng.gaussian(0.1), (float)rng.gaussian(0.1)));
            points2.push_back(points2[i] +
                              Point2f((float)rng.gaussian(0.1), (float)rng.gaussian(0.1)));
        }
        FileStorage fs(base + ".yml", FileStorage::READ);
        CV_Assert(fs.isOpened());
        if (!fs["K1"].empty())
        {
            Mat K2, d1, d2;
            fs["K1"] >> K;
            fs["K2"] >> K2;
            fs["d1"] >> d1;
            fs["d2"] >> d2;
            undistortPoints(Mat(points1), points1, K, d1, noArray(), K);
            undistortPoints(Mat(points2), points2, K2, d2, noArray(), K);
        }
    }

    std::vector<Point2f> points1, points2;
    Mat K;
};

PERF_TEST_P(UsacMethod, Homography, Method::all())
{
    const PerfSet set("graf", 4);
    const int method = GetParam();
    Mat model;
    declare.in(set.points1, set.points2).iterations(20);
    TEST_CYCLE()
    {
        model = usacv20::findHomography(set.points1, set.points2, method, 2., noArray(), 10000,
                                        0.99);
    }
    EXPECT_FALSE(model.empty());
    SANITY_CHECK_NOTHING();
}

PERF_TEST_P(UsacMethod, Fundamental, Method::all())
{
    const PerfSet set("office01_F", 4);
    const int method = GetParam();
    Mat model;
    declare.in(set.points1, set.points2).iterations(20);
    TEST_CYCLE()
    {
        model = usacv20::findFundamentalMat(set.points1, set.points2, method, 1., 0.99, 1000);
    }
    EXPECT_FALSE(model.empty());
    SANITY_CHECK_NOTHING();
}

PERF_TEST_P(UsacMethod, Essential, Method::all())
{
    const PerfSet set("office01_E", 4);
    const int method = GetParam();
    Mat model;
    declare.in(set.points1, set.points2).iterations(20);
    TEST_CYCLE()
    {
        model = usacv20::findEssentialMat(set.points1, set.points2, set.K, method, 0.99, 1.);
    }
    EXPECT_FALSE(model.empty());
    SANITY_CHECK_NOTHING();
}

}  // namespace
}  // namespace opencv_test
