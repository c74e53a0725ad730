// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "input/problem_data.hpp"
#include "support/contracts.hpp"
#include "problems/absolute_pose/pose_scenes.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"

// If there are too many points, the search uses a random part of them. Polishing and the mask must
// use all points.

namespace opencv_test {
namespace {

const int MANY = 80000;
const UsacV20Method SOME_FLAGS[] = {USACV20, USACV20_FAST, USACV20_MAGSAC};

//! Makes scenes with more points than a search uses.
class UsacManyPoints : public testing::TestWithParam<int>
{
protected:
    Scene sceneOf(int seed) const
    {
        SceneOptions options;
        options.setSize(MANY, 0.4);
        options.seed = seed;
        return makeScene((ProblemType)GetParam(), options);
    }
};

INSTANTIATE_TEST_CASE_P(/**/, UsacManyPoints, testing::ValuesIn(TWO_VIEW_PROBLEMS));

TEST_P(UsacManyPoints, asAccurateAsLeastSquares)
{
    double own[3] = {0}, least = 0;
    for (int seed = 1; seed <= 4; ++seed)
    {
        const Scene scene = sceneOf(seed);
        Params params;
        const Mat fitted = createUsac(scene, params)->fit(noArray(), scene.truth);
        least += modelError(scene, fitted);
        for (int k = 0; k < 3; ++k)
        {
            params = Params::fromMethod(SOME_FLAGS[k]);
            own[k] += modelError(scene, estimate(scene, params));
        }
    }
    // A fit to only the 32768 points that the search uses would have about 1.5 times the error of
    // the fit to all points. Wrong matches near epipolar lines increase the errors of F and E.
    const double most = mapsPoints((ProblemType)GetParam()) ? 1.45 : 2.5;
    for (int k = 0; k < 3; ++k)
        EXPECT_LE(own[k], most * least) << "flag " << k;
}

TEST_P(UsacManyPoints, maskAndReportAreOfAllPoints)
{
    const Scene scene = sceneOf(5);
    Params params;
    params.threshold = 2;
    const Ptr<Usac> usac = createUsac(scene, params);
    Mat mask;
    Report report;
    const Mat model = usac->run(mask, &report), errors = usac->errors(model);
    ASSERT_EQ(MANY, mask.rows);
    EXPECT_EQ(countNonZero(mask), report.inliers);
    EXPECT_NEAR((double)report.inliers / MANY, report.inlierRatio, 1e-12);
    EXPECT_NEAR(0.4, report.inlierRatio, 0.03);
    int differ = 0;
    for (int i = 0; i < MANY; ++i)
        differ += (mask.at<uchar>(i) != 0) != (errors.at<double>(i) <= report.threshold);
    EXPECT_EQ(0, differ);
}

TEST_P(UsacManyPoints, sameBitsForAnyNumberOfThreadsAndAgain)
{
    const Scene scene = sceneOf(6);
    Params params;
    const Ptr<Usac> usac = createUsac(scene, params);
    const Mat first = usac->run();
    EXPECT_TRUE(sameBits(first, usac->run())) << "the second run";
    params.threads = 2;
    EXPECT_TRUE(sameBits(first, estimate(scene, params))) << "two threads";
}

//! The caller's points can be sorted, or in the order of image rows as from dense matchers. The
//! search uses only the first SEARCHED points of the internal order, which must therefore be a
//! random sample; polishing uses longer first parts, which must be random samples of runs of rows.
TEST(Usac_ManyPoints, areInRandomOrder)
{
    const int RUN = 16, SIZE = 8 * MANY, PARTS = 16;
    const Scene scene = makeScene(HOMOGRAPHY, SceneOptions());
    const Mat one1 = column(scene.points1), one2 = column(scene.points2);
    Mat points1, points2;
    repeat(one1, SIZE / one1.rows + 1, 1, points1);
    repeat(one2, SIZE / one2.rows + 1, 1, points2);
    const Ptr<Usac> usac = Usac::create(HOMOGRAPHY, points1, points2, Params());
    const Correspondences& p = usac->points();
    std::vector<uchar> seen(p.size, 0);
    for (int i = 0; i < p.size; ++i)
        ++seen[p.inputIndex[i]];
    EXPECT_EQ(p.size, std::count(seen.begin(), seen.end(), 1));
    const int searched = ProblemData::SEARCHED;
    ASSERT_GT(p.size, 4 * searched);
    for (int k = 0; k < 2 * PARTS; ++k)  // parts of the points of the search, then of the others
    {
        const int all = k < PARTS ? searched : p.size - searched, part = all / PARTS,
                  begin = (k < PARTS ? 0 : searched) + k % PARTS * part;
        double mean = 0;
        for (int i = begin; i < begin + part; ++i)
            mean += (double)p.inputIndex[i] / p.size / part;
        const int drawn = k < PARTS ? part : part / RUN;              // number of independent draws
        EXPECT_NEAR(0.5, mean, 5 * std::sqrt(1. / 12 / drawn)) << k;  // five standard deviations
    }
}

}  // namespace
}  // namespace opencv_test
