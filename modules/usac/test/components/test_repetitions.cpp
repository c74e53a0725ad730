// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "components/repetitions.hpp"

#include <set>

namespace opencv_test {
namespace {

//! Matches and a mask for independentInliers(). This function divides each image into square cells
//! whose side is the threshold of the image. It counts the cells that contain inliers and returns
//! the smaller of the counts of the two images.
struct Points
{
    void add(double a1, double b1, double a2, double b2, bool inlier = true)
    {
        x1.push_back(a1);
        y1.push_back(b1);
        x2.push_back(a2);
        y2.push_back(b2);
        mask.push_back(inlier);
    }

    int independent(double threshold1 = 1, double threshold2 = 1) const
    {
        Arena arena;
        const double* const columns[] = {x1.data(), y1.data(), x2.data(), y2.data()};
        const int coordinates[] = {2, 2};
        return independentInliers(columns, coordinates, mask.data(), (int)mask.size(), threshold1,
                                  threshold2, arena);
    }

    std::vector<double> x1, y1, x2, y2;
    std::vector<uchar> mask;
};

TEST(Usac_Repetitions, independentInliersAgainstASet)
{
    RNG rng(1);
    for (double side = 0.01; side < 100; side *= 7)
    {
        Points points;
        std::set<std::pair<double, double>> cells1, cells2;
        for (int i = 0; i < 2000; ++i)
        {
            const double p[4] = {rng.uniform(-50., 50.), rng.uniform(-50., 50.), rng.gaussian(20),
                                 rng.gaussian(1)};
            points.add(p[0], p[1], p[2], p[3], i % 3 != 0);
            if (i % 3 == 0)
                continue;
            cells1.insert(std::make_pair(std::floor(p[0] / side), std::floor(p[1] / side)));
            cells2.insert(
                std::make_pair(std::floor(p[2] / (2 * side)), std::floor(p[3] / (2 * side))));
        }
        EXPECT_EQ((int)std::min(cells1.size(), cells2.size()), points.independent(side, 2 * side))
            << side;
    }
}

//! Of the inliers in each cell of side 2, markRepeated() must mark all except the first one in the
//! given order.
TEST(Usac_Repetitions, firstOfACellIsNotRepeated)
{
    RNG rng(2);
    const int N = 500;
    std::vector<double> x(N), y(N);
    std::vector<int> order(N);
    std::vector<uchar> mask(N), repeated(N, 0);
    for (int i = 0; i < N; ++i)
    {
        x[i] = rng.uniform(0., 20.);
        y[i] = rng.uniform(0., 20.);
        order[i] = (i * 7 + 3) % N;
        mask[i] = i % 4 != 1;
    }
    repeated[5] = 1;  // as if a call for the other image had marked this point
    Arena arena;
    const double* const columns[] = {x.data(), y.data()};
    const int sum = markRepeated(columns, 2, order.data(), mask.data(), N, 2, repeated.data(),
                                 arena);
    std::set<std::pair<int, int>> seen;
    int expectedSum = 0;
    for (int i = 0; i < N; ++i)
    {
        const std::pair<int, int> cell(cvFloor(x[order[i]] / 2), cvFloor(y[order[i]] / 2));
        const bool expected = i == 5 || (mask[i] && seen.count(cell));
        if (mask[i])
            seen.insert(cell);
        EXPECT_EQ(expected, repeated[i] != 0) << i;
        expectedSum += expected;
    }
    EXPECT_EQ(expectedSum, sum);
}

//! Points with a single coordinate, in cells of side 2 and of side 0. With side 0, only points
//! equal to an earlier inlier must be marked as repeated.
TEST(Usac_Repetitions, pointsOnALine)
{
    const double x[] = {0.5, 1.5, -0.5, 0.5, 2.5, -1.5, 2.5}, *const columns[] = {x};
    const uchar mask[] = {1, 1, 1, 1, 1, 1, 0}, byCell[] = {0, 1, 0, 1, 0, 1, 0},
                equal[] = {0, 0, 0, 1, 0, 0, 0};
    Arena arena;
    for (int side = 0; side <= 2; side += 2)
    {
        uchar repeated[7] = {0, 0, 0, 0, 0, 0, 0};
        EXPECT_EQ(side ? 3 : 1, markRepeated(columns, 1, 0, mask, 7, side, repeated, arena));
        for (int i = 0; i < 7; ++i)
            EXPECT_EQ(side ? byCell[i] : equal[i], repeated[i]) << side << " " << i;
    }
}

}  // namespace
}  // namespace opencv_test
