// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/draw.hpp"
#include "support/surroundings.hpp"
#include "samplers/samplers.hpp"

namespace opencv_test {
namespace {

Params withNeighbors(int neighbors)
{
    Params params = Draw::ordered();
    params.neighborhood = NEIGHBORHOOD_KNN;
    params.neighbors = neighbors;
    return params;
}

Params withRadius(double radius)
{
    Params params = Draw::ordered();
    params.neighborhood = NEIGHBORHOOD_RADIUS;
    params.neighborRadius = radius;
    return params;
}

//! The first point must be uniform, and the other points uniform among the neighbors of the first
//! point in the coarsest layer.
TEST(Usac_Napsac, uniformAmongNeighbors)
{
    const int N = 40, SAMPLES = 40000, MEMBERS = 33;
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        Draw draw((ProblemType)problem, N, createNapsacSampler(), problem, withNeighbors(4));
        Neighborhood& neighborhood = *draw.usac->components().neighborhood;
        std::vector<int> centers(N, 0);
        std::vector<std::vector<int>> ranks(draw.m, std::vector<int>(MEMBERS, 0));
        for (int i = 0; i < SAMPLES; ++i)
        {
            draw.next();
            ASSERT_TRUE(draw.valid());
            ++centers[draw.sample[0]];
            const int* members = 0;
            const int count = neighborhood.members(draw.context, neighborhood.layers() - 1,
                                                   draw.sample[0], members);
            ASSERT_EQ((int)MEMBERS, count);
            for (int k = 1; k < draw.m; ++k)
            {
                const int rank = (int)(std::find(members, members + count, draw.sample[k]) -
                                       members);
                ASSERT_LT(rank, count) << "not a neighbor of the first point";
                ++ranks[k][rank];
            }
        }
        EXPECT_LT(std::abs(deviation(centers, SAMPLES)), 4.5);
        for (int k = 1; k < draw.m; ++k)
        {
            EXPECT_EQ(0, ranks[k][0]);
            ranks[k].erase(ranks[k].begin());
            EXPECT_LT(std::abs(deviation(ranks[k], SAMPLES)), 4.5) << "place " << k;
        }
    }
}

//! Points with too few neighbors must not be the first point of a sample; all other points must be
//! the first point equally often.
TEST(Usac_Napsac, lonelyPointsAreNoCenters)
{
    const int N = 300, SAMPLES = 60000;
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        if (sampleSizeOf(problem) == 1)
            continue;
        Draw draw((ProblemType)problem, N, createNapsacSampler(), problem, withRadius(9));
        Neighborhood& neighborhood = *draw.usac->components().neighborhood;
        std::vector<int> centers(N, 0);
        for (int i = 0; i < SAMPLES; ++i)
        {
            draw.next();
            ASSERT_TRUE(draw.valid());
            ++centers[draw.sample[0]];
        }
        std::vector<int> social;
        for (int i = 0; i < N; ++i)
        {
            if ((int)membersOf(neighborhood, draw.context, neighborhood.layers() - 1, i).size() >=
                draw.m)
                social.push_back(centers[i]);
            else
            {
                EXPECT_EQ(0, centers[i]);
            }
        }
        EXPECT_GT((int)social.size(), 20) << "problem " << problem;
        EXPECT_LT((int)social.size(), N - 20) << "problem " << problem;
        EXPECT_LT(std::abs(deviation(social, SAMPLES)), 4.5) << "problem " << problem;
    }
}

//! If no point has neighbors, samples must be uniform.
TEST(Usac_Napsac, uniformWithoutNeighbors)
{
    const int N = 30, SAMPLES = 6000;
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        Draw draw((ProblemType)problem, N, createNapsacSampler(), problem, withRadius(1e-3));
        std::vector<int> singles(N, 0);
        for (int i = 0; i < SAMPLES; ++i)
        {
            draw.next();
            ASSERT_TRUE(draw.valid());
            ++singles[draw.sample[i % draw.m]];
        }
        EXPECT_LT(std::abs(deviation(singles, SAMPLES)), 4.5);
    }
}

TEST(Usac_Napsac, worksWithTheGridAndFewPoints)
{
    for (int problem : TWO_VIEW_PROBLEMS)
        for (int more = 0; more < 40; more += 4)
        {
            Draw draw((ProblemType)problem, sampleSizeOf(problem) + more, createNapsacSampler());
            for (int i = 0; i < 200; ++i)
            {
                draw.next();
                ASSERT_TRUE(draw.valid()) << problem << " " << more;
            }
        }
}

}
}  // namespace
