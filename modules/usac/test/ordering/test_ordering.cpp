// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/run_context.hpp"
#include "support/surroundings.hpp"
#include "ordering/ordering.hpp"

#include <set>

namespace opencv_test {
namespace {

std::vector<int> sortBy(const Ptr<Ordering>& ordering, const Correspondences& points)
{
    const Surroundings around(points);
    std::vector<int> order(points.size);
    for (int i = 0; i < points.size; ++i)
        order[i] = i;
    ordering->sort(around.context, order.data());
    EXPECT_EQ(points.size, (int)order.size());
    std::vector<uchar> seen(points.size, 0);
    for (size_t i = 0; i < order.size(); ++i)
    {
        const bool inside = order[i] >= 0 && order[i] < points.size;
        EXPECT_TRUE(inside && !seen[order[i]]) << "not a permutation";
        if (inside)
            seen[order[i]] = 1;
    }
    return order;
}

TEST(Usac_Priors, densityPutsClusteredMatchesFirst)
{
    for (int problem : TWO_VIEW_PROBLEMS)
        for (uint64 seed = 1; seed <= 10; ++seed)
        {
            SceneOptions options;
            options.inliers = 400;
            options.outliers = 600;
            options.seed = seed;
            const Scene scene = makeScene((ProblemType)problem, options);
            const Ptr<Usac> usac = createUsac(scene, Params());
            const std::vector<int> order = sortBy(createDensityOrdering(), usac->points());
            int first = 0, last = 0;
            for (int i = 0; i < 100; ++i)
            {
                first += scene.truth[usac->points().inputIndex[order[i]]];
                last += scene.truth[usac->points().inputIndex[order[999 - i]]];
            }
            // 40 true matches are expected by chance
            EXPECT_GT(first, 60) << "problem " << problem << " seed " << seed;
            EXPECT_LT(last, 40) << "problem " << problem << " seed " << seed;
        }
}

TEST(Usac_Priors, densityOfClumsyPoints)
{
    RNG rng(4);
    for (int count = 1; count <= 3000; count = count * 5 + 1)
    {
        std::vector<Point2d> points1, points2;
        clumsyPoints(count, rng, points1, points2);
        sortBy(createDensityOrdering(), OwnPoints(HOMOGRAPHY, points1, points2).view());
    }
    const std::vector<Point2d> equal(70000,
                                     // so many points in one cell that 16 bits cannot count them
                                     Point2d(1, 2));
    sortBy(createDensityOrdering(), OwnPoints(HOMOGRAPHY, equal, equal).view());
}

TEST(Usac_Priors, scores)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    RNG rng(5);
    for (int direction = 0; direction < 2; ++direction)
    {
        Params params;
        params.scoreOrder = direction == 0 ? SCORES_LOWER_IS_BETTER : SCORES_HIGHER_IS_BETTER;
        int unknown = 0;
        for (int i = 0; i < scene.size(); ++i)
        {
            const bool isUnknown = i % 9 == 4;
            unknown += isUnknown;
            const float score = (float)(i % 10 == 3 ? 0.5 : rng.gaussian(10));
            params.scores.push_back(isUnknown ? std::numeric_limits<float>::quiet_NaN() : score);
        }
        const Ptr<Usac> usac = createUsac(scene, params);
        ASSERT_TRUE(usac->points().scores != 0);
        const std::vector<int> order = sortBy(createScoreOrdering(), usac->points());
        float previous = 0;
        for (int i = 0; i < scene.size(); ++i)
        {
            const float score = params.scores[usac->points().inputIndex[order[i]]];
            ASSERT_EQ(i >= scene.size() - unknown, cvIsNaN(score) != 0)
                << "scores that are NaN come last";
            if (i > 0 && i < scene.size() - unknown)
            {
                EXPECT_TRUE(direction == 0 ? previous <= score : previous >= score);
            }
            previous = score;
        }
    }
}

TEST(Usac_Priors, inputOrder)
{
    Scene scene = makeScene(HOMOGRAPHY);
    scene.points1[3].x = std::numeric_limits<double>::quiet_NaN();
    scene.points2[17].y = std::numeric_limits<double>::infinity();
    const Ptr<Usac> usac = createUsac(scene, Params());
    const std::vector<int> order = sortBy(createInputOrderOrdering(), usac->points());
    ASSERT_EQ(scene.size() - 2, (int)order.size());
    int row = 0;
    for (size_t i = 0; i < order.size(); ++i, ++row)
    {
        while (row == 3 || row == 17)
            ++row;
        ASSERT_EQ(row, usac->points().inputIndex[order[i]]);
    }
}

}  // namespace
}  // namespace opencv_test
