// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"
#include "support/real_set.hpp"

// Tests with real matches of test_data/. Models are compared with check points: correct
// correspondences, independent of the matches and of all estimators, see the README.md there.

namespace opencv_test {
namespace {

//! A data set, its inlier threshold, the maximum mean error of the check points (both in pixels)
//! and the minimum number of inliers.
struct RealCase
{
    const char* name;
    double threshold, error;
    int inliers;
};

void PrintTo(const RealCase& c, std::ostream* os) { *os << c.name; }

class UsacReal : public testing::TestWithParam<RealCase>
{
protected:
    UsacReal() : real(GetParam()), set(real.name) {}

    void verify(const char* what, const Mat& model, const Mat& mask, double slack = 1) const
    {
        EXPECT_LT(set.error(model), slack * real.error) << what;
        EXPECT_GT(countNonZero(mask), real.inliers / slack) << what;
        if (cvtest::debugLevel > 0)
            printf("%-12s %-16s error %.3f px, %d inliers\n", real.name, what, set.error(model),
                   countNonZero(mask));
    }

    const RealCase real;
    const RealSet set;
};

const RealCase CASES[] = {{"graf", 2, 0.6, 235},       {"aloe", 1, 0.3, 265},
                          {"office01_F", 1, 1, 265},   {"office12_F", 1, 1, 150},
                          {"office01_E", 1, 0.6, 260}, {"office12_E", 1, 0.9, 140}};
INSTANTIATE_TEST_CASE_P(/**/, UsacReal, testing::ValuesIn(CASES));

//! The true model must fit the check points and a wrong one must not, or the other tests would be
//! worthless.
TEST_P(UsacReal, truth_fits_the_check_points)
{
    EXPECT_LT(set.error(set.model), 0.2);
    EXPECT_GT(set.error(Mat(Matx33d(1, 2, 3, -1, 4, 5, 2, 1, 1))), real.error);
}

TEST_P(UsacReal, every_flag)
{
    Mat mask;
    // for graf, the search ends in another optimum with an error of 1.7 pixels for six percent of
    // the seeds; for office01_F, 7 of 100 seeds of USACV20_FAST end with an error of 1.5 to 2
    // pixels
    const bool graf = real.name == std::string("graf");
    verify("USACV20", set.find(USACV20, real.threshold, mask), mask);
    verify("USACV20_FAST", set.find(USACV20_FAST, real.threshold, mask), mask, graf ? 3 : 2);
    verify("USACV20_ACCURATE", set.find(USACV20_ACCURATE, real.threshold, mask), mask);
    // MAGSAC++ uses errors up to 2.4 thresholds, and the wall in graf is not quite a plane
    verify("USACV20_MAGSAC", set.find(USACV20_MAGSAC, real.threshold / 2, mask), mask,
           graf ? 4 : 2);
    verify("USACV20_PROSAC", set.sorted().find(USACV20_PROSAC, real.threshold, mask), mask);
}

//! With six percent of the seeds, the search ends in another local optimum of graf, because the
//! wall in the images is not quite a plane. This is allowed for twelve of 100 seeds.
TEST_P(UsacReal, every_seed)
{
    int elsewhere = 0;
    for (int seed = 0; seed < 100; ++seed)
    {
        Params params;
        params.threshold = real.threshold;
        params.seed = seed;
        Mat mask;
        Report report;
        const Mat model = set.estimateWith(params, mask, report);
        elsewhere += set.error(model) >= real.error;
        verify(cv::format("seed %d", seed).c_str(), model, mask, 4);
    }
    EXPECT_LE(elsewhere, 12);
}

}
}  // namespace
