// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/run_context.hpp"
#include "support/surroundings.hpp"
#include "neighborhood/neighborhood.hpp"

#include <set>

namespace opencv_test {
namespace {

//! Cell of a point in a layer with `divisions` cells along each of the four axes.
Vec4i cellOf(const Correspondences& p, int point, int divisions)
{
    const float* coordinates[4] = {p.column[X1], p.column[Y1], p.column[X2], p.column[Y2]};
    Vec4i cell;
    for (int k = 0; k < 4; ++k)
    {
        const float range = p.upper[k] - p.lower[k];
        const float x = range > 0 ? (coordinates[k][point] - p.lower[k]) * (16 / range) : 0;
        cell[k] = std::min(15, std::max(0, cvFloor(x))) / (16 / divisions);
    }
    return cell;
}

void compareWithBruteForce(const Correspondences& points)
{
    const Surroundings around(points);
    const Ptr<Neighborhood> grid = createGridNeighborhood(4);
    ASSERT_EQ(4, grid->layers());
    for (int layer = 0; layer < 4; ++layer)
        for (int i = 0; i < points.size; ++i)
        {
            std::set<int> expected;
            for (int j = 0; j < points.size; ++j)
                if (cellOf(points, i, 16 >> layer) == cellOf(points, j, 16 >> layer))
                    expected.insert(j);
            ASSERT_EQ(expected, membersOf(*grid, around.context, layer, i))
                << "layer " << layer << " point " << i;
        }
}

TEST(Usac_Neighborhood, gridAgainstBruteForce)
{
    RNG rng(1);
    for (int count = 1; count <= 700; count = count * 3 + 1)
    {
        std::vector<Point2d> points1, points2;
        clumsyPoints(count, rng, points1, points2);
        const OwnPoints points(HOMOGRAPHY, points1, points2);
        compareWithBruteForce(points.view());
    }
    const Scene scene = makeScene(FUNDAMENTAL);
    compareWithBruteForce(createUsac(scene, Params())->points());
    compareWithBruteForce(createUsac(makeScene(ESSENTIAL), Params())->points());
}

//! Here many points are outside the given range of the coordinates. Such points must belong to the
//! outermost cells.
TEST(Usac_Neighborhood, gridOfANarrowRange)
{
    RNG rng(2);
    std::vector<Point2d> points1, points2;
    clumsyPoints(400, rng, points1, points2);
    const OwnPoints own(HOMOGRAPHY, points1, points2);
    Correspondences points = own.view();
    for (int k = 0; k < 4; ++k)
    {
        points.lower[k] = -0.6f;
        points.upper[k] = 0.7f;
    }
    compareWithBruteForce(points);
}

TEST(Usac_Neighborhood, equalPointsAreAllNeighbors)
{
    const OwnPoints points(HOMOGRAPHY, std::vector<Point2d>(37, Point2d(-3, 4)),
                           std::vector<Point2d>(37, Point2d(0, 0)));
    const Surroundings around(points.view());
    const Ptr<Neighborhood> grid = createGridNeighborhood(4);
    for (int layer = 0; layer < grid->layers(); ++layer)
        EXPECT_EQ(37u, membersOf(*grid, around.context, layer, layer).size());
    EXPECT_LE(edgesOf(*grid, around.context).size(), 4u * 37);
    EXPECT_GE(edgesOf(*grid, around.context).size(), 36u);  // enough to connect all points
}

void checkEdges(const Correspondences& points, size_t least)
{
    const Surroundings around(points);
    const Ptr<Neighborhood> grid = createGridNeighborhood(4);
    const std::vector<Vec2i> edges = edgesOf(*grid, around.context);
    std::set<std::pair<int, int>> seen;
    for (size_t e = 0; e < edges.size(); ++e)
    {
        const int i = edges[e][0], j = edges[e][1];
        ASSERT_TRUE(i >= 0 && j >= 0 && i < points.size && j < points.size);
        EXPECT_NE(i, j);
        EXPECT_TRUE(seen.insert(std::make_pair(std::min(i, j), std::max(i, j))).second)
            << i << " - " << j << " twice";
        EXPECT_EQ(1u, membersOf(*grid, around.context, 1, i).count(j))
            << "in different cells of the grid of 8 x 8 x 8 x 8 cells";
    }
    EXPECT_LE(edges.size(), 4 * (size_t)points.size);
    EXPECT_GE(edges.size(), least);
    EXPECT_EQ(edges, edgesOf(*grid, around.context));
    std::vector<int> degrees(points.size);
    for (const Vec2i& edge : edges)
        EXPECT_LE(std::max(++degrees[edge[0]], ++degrees[edge[1]]), grid->mostEdges());
}

TEST(Usac_Neighborhood, edges)
{
    RNG rng(3);
    for (int count = 1; count <= 2000; count = count * 4 + 1)
    {
        std::vector<Point2d> points1, points2;
        clumsyPoints(count, rng, points1, points2);
        checkEdges(OwnPoints(HOMOGRAPHY, points1, points2).view(), count > 100 ? count / 2 : 0);
    }
}

//! With `wanted`, the edges must be those of the whole graph that have a wanted endpoint, in the
//! same order.
TEST(Usac_Neighborhood, wantedEdges)
{
    RNG rng(4);
    std::vector<Point2d> points1, points2;
    clumsyPoints(1000, rng, points1, points2);
    const OwnPoints points(HOMOGRAPHY, points1, points2);
    const Surroundings around(points.view());
    const Ptr<Neighborhood> grid = createGridNeighborhood(4);
    const std::vector<Vec2i> all = edgesOf(*grid, around.context);
    for (int every = 1; every <= 1024; every *= 4)
    {
        std::vector<uchar> wanted(points.view().size);
        for (size_t i = 0; i < wanted.size(); ++i)
            wanted[i] = i % every == 0;
        std::vector<Vec2i> expected;
        for (const Vec2i& edge : all)
            if (wanted[edge[0]] || wanted[edge[1]])
                expected.push_back(edge);
        EXPECT_EQ(expected, edgesOf(*grid, around.context, wanted.data()));
    }
    const std::vector<uchar> none(points.view().size);
    EXPECT_TRUE(edgesOf(*grid, around.context, none.data()).empty());
}

//! A point must have an edge if and only if another point is in its cell of layer 1.
TEST(Usac_Neighborhood, noPointIsForgotten)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    const Ptr<Usac> usac = createUsac(scene, Params());
    const Surroundings around(usac->points());
    const Ptr<Neighborhood> grid = createGridNeighborhood(4);
    std::vector<int> degree(usac->points().size, 0);
    const std::vector<Vec2i> edges = edgesOf(*grid, around.context);
    for (size_t e = 0; e < edges.size(); ++e)
    {
        ++degree[edges[e][0]];
        ++degree[edges[e][1]];
    }
    int alone = 0;
    for (int i = 0; i < usac->points().size; ++i)
    {
        const bool isolated = membersOf(*grid, around.context, 1, i).size() == 1;
        EXPECT_EQ(isolated, degree[i] == 0);
        alone += isolated;
    }
    EXPECT_LT(alone, usac->points().size);
}

/** Members and edges must not depend on whether edges of the first points were requested before,
and the edges of the first points must be those of a grid that knows only these points. After a new
start, with other points and other memory, nothing of the previous run must remain. */
TEST(Usac_Neighborhood, firstPoints)
{
    RNG rng(12);
    const Ptr<Neighborhood> grid = createGridNeighborhood(4);
    EXPECT_TRUE(grid->edgesOfFirstPoints());
    for (int run = 0; run < 4; ++run)
    {
        const int count = run == 1 ? 700 : 400;
        std::vector<Point2d> points1, points2;
        clumsyPoints(count, rng, points1, points2);
        const OwnPoints points(HOMOGRAPHY, points1, points2);
        const Surroundings all(points.view());
        grid->start(all.context);
        const std::vector<Vec2i> expected = edgesOf(*createGridNeighborhood(4), all.context);
        const std::set<int> members = membersOf(*createGridNeighborhood(4), all.context, 1, 8);
        EXPECT_GT((int)expected.size(), count / 2);
        EXPECT_GT(members.size(), 1u);
        for (int size : {100, count, 30, 300})
        {
            if (run % 2 == 1)
            {
                EXPECT_EQ(members, membersOf(*grid, all.context, 1, 8));
            }
            Correspondences part = points.view();
            part.size = size;
            const Surroundings first(part);
            const Context context(part, all.components, all.params, all.context.arena);
            const std::vector<Vec2i> edges = edgesOf(*grid, context);
            EXPECT_EQ(edgesOf(*createGridNeighborhood(4), first.context), edges) << size;
            EXPECT_FALSE(edges.empty());
        }
        EXPECT_EQ(expected, edgesOf(*grid, all.context));
        EXPECT_EQ(members, membersOf(*grid, all.context, 1, 8));
    }
}

TEST(Usac_Neighborhood, noPoints)
{
    const OwnPoints none(HOMOGRAPHY, std::vector<Point2d>(), std::vector<Point2d>());
    const Surroundings around(none.view());
    EXPECT_TRUE(edgesOf(*createGridNeighborhood(4), around.context).empty());
    EXPECT_TRUE(edgesOf(*createKnnNeighborhood(5), around.context).empty());
    EXPECT_TRUE(edgesOf(*createRadiusNeighborhood(20), around.context).empty());
}

}  // namespace
}  // namespace opencv_test
