// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "control/watch.hpp"
#include "support/run_context.hpp"
#include "support/surroundings.hpp"
#include "neighborhood/neighborhood.hpp"

namespace opencv_test {
namespace {

//! LAYERS: number of layers; each has twice the radius or twice the number of neighbors of the
//! previous one. LINKS: maximum number of edges from a point to its nearest neighbors. WIDEST:
//! maximum number of neighbors stored per point, unless Params::neighbors is larger.
enum { LAYERS = 4, LINKS = 8, WIDEST = 512 };

//! Points and the distances between them in the joint space (x1, y1, x2, y2).
class Pixels
{
public:
    //! Distances are in the unit of the given points.
    explicit Pixels(const OwnPoints& own) : around(own.view(), unitThreshold(own.view().threshold))
    {
        const Correspondences& p = own.view();
        for (int i = 0; i < p.size; ++i)
            rows.push_back(Vec4d(p.exact[X1][i], p.exact[Y1][i], p.exact[X2][i], p.exact[Y2][i]));
    }

    //! Distances are in pixels of the images of the scene.
    Pixels(const Scene& scene, const Params& params)
        : usac(createUsac(scene, params)), around(usac->points(), params)
    {
        for (int i = 0; i < usac->points().size; ++i)
        {
            const int row = usac->points().inputIndex[i];
            rows.push_back(Vec4d(scene.points1[row].x, scene.points1[row].y, scene.points2[row].x,
                                 scene.points2[row].y));
        }
    }

    int size() const { return (int)rows.size(); }
    double distance(int i, int j) const { return cv::norm(rows[i] - rows[j]); }

    //! Sorted distances to all points, including the point itself.
    std::vector<double> sorted(int point) const
    {
        std::vector<double> all;
        for (int j = 0; j < size(); ++j)
            all.push_back(distance(point, j));
        std::sort(all.begin(), all.end());
        return all;
    }

    const Context& context() const { return around.context; }

private:
    static Params unitThreshold(double threshold)
    {
        Params params;
        params.threshold = threshold;
        return params;
    }

    const Ptr<Usac> usac;
    const Surroundings around;
    std::vector<Vec4d> rows;
};

//! The members of a layer around a point. The first one must be the point itself, and the others
//! must be sorted by their distance from it.
std::vector<int> listOf(const Pixels& pixels, Neighborhood& neighborhood, int layer, int point)
{
    const int* members = 0;
    const int count = neighborhood.members(pixels.context(), layer, point, members);
    const std::vector<int> list(members, members + count);
    EXPECT_GE(count, 1);
    EXPECT_EQ(point, list[0]);
    EXPECT_EQ((size_t)count, std::set<int>(list.begin(), list.end()).size())
        << "a member is repeated";
    for (int i = 2; i < count; ++i)
        EXPECT_LE(pixels.distance(point, list[i - 1]),
                  pixels.distance(point, list[i]) * (1 + 1e-4) + 1e-4);
    return list;
}

void checkKnn(const Pixels& pixels, int k)
{
    const Ptr<Neighborhood> knn = createKnnNeighborhood(k);
    ASSERT_EQ((int)LAYERS, knn->layers());
    for (int point = 0; point < pixels.size(); ++point)
    {
        const std::vector<double> distances = pixels.sorted(point);
        for (int step = 0; step < LAYERS; ++step)
        {
            const int layer = point % 2 ? step
                                        // for even points, the widest layer comes first
                                        : LAYERS - 1 - step;
            const std::vector<int> list = listOf(pixels, *knn, layer, point);
            const int expected = std::min(pixels.size(),
                                          std::max(k, std::min<int>(k << layer, WIDEST)) + 1);
            ASSERT_EQ(expected, (int)list.size()) << "layer " << layer;
            for (int i = 0; i < expected; ++i)
                ASSERT_NEAR(distances[i], pixels.distance(point, list[i]),
                            1e-4 * (1 + distances[i]))
                    << "layer " << layer;
        }
    }
}

void checkRadius(const Pixels& pixels, double radius)
{
    const Ptr<Neighborhood> within = createRadiusNeighborhood(radius);
    ASSERT_EQ((int)LAYERS, within->layers());
    for (int point = 0; point < pixels.size(); ++point)
        for (int layer = 0; layer < LAYERS; ++layer)
        {
            const double r = radius * (1 << layer);
            const std::vector<int> list = listOf(pixels, *within, layer, point);
            int certain = 0, possible = 0;
            for (int j = 0; j < pixels.size(); ++j)
            {
                certain += pixels.distance(point, j) <= r * (1 - 1e-4);
                possible += pixels.distance(point, j) <= r * (1 + 1e-4) + 1e-6;
            }
            ASSERT_GE((int)list.size(), std::min<int>(certain, WIDEST + 1)) << "layer " << layer;
            ASSERT_LE((int)list.size(), std::min<int>(possible, WIDEST + 1)) << "layer " << layer;
            const std::vector<double> distances = pixels.sorted(point);
            ASSERT_NEAR(distances[list.size() - 1], pixels.distance(point, list.back()),
                        1e-4 * (1 + r));
        }
}

TEST(Usac_NeighborhoodFlann, clumsyPointsAgainstBruteForce)
{
    RNG rng(1);
    for (int count = 1; count <= 400; count = count * 3 + 1)
    {
        std::vector<Point2d> points1, points2;
        clumsyPoints(count, rng, points1, points2);
        const OwnPoints own(HOMOGRAPHY, points1, points2);
        const Pixels pixels(own);
        checkKnn(pixels, 1);
        checkKnn(pixels, 12);
        checkRadius(pixels, 0.05);
        checkRadius(pixels, 1);
    }
}

//! Distances must be in pixels of the images, whatever internal coordinates the estimator uses.
TEST(Usac_NeighborhoodFlann, pixelsOfBothImages)
{
    for (int problem = 0; problem < 3; ++problem)
    {
        Scene scene = makeScene((ProblemType)problem);
        if (problem != ESSENTIAL)  // makes image 2 three times as large
            for (int i = 0; i < scene.size(); ++i)
                scene.points2[i] *= 3;
        Params params;
        params.threshold = 0.7;
        const Pixels pixels(scene, params);
        checkKnn(pixels, 10);
        checkRadius(pixels, 25);
    }
}

//! With a radius, at most the nearest WIDEST neighbors of a point must be kept. With a given number
//! of neighbors, more must be kept if this number is larger.
TEST(Usac_NeighborhoodFlann, boundedMemory)
{
    RNG rng(2);
    std::vector<Point2d> points1, points2;
    clumsyPoints(1500, rng, points1, points2);
    const OwnPoints own(HOMOGRAPHY, points1, points2);
    const Pixels pixels(own);
    const Ptr<Neighborhood> radius = createRadiusNeighborhood(1e300),
                            knn = createKnnNeighborhood(1000), some = createKnnNeighborhood(100);
    for (int point = 0; point < 1500; point += 50)
        for (int layer = 0; layer < LAYERS; ++layer)
        {
            EXPECT_EQ(WIDEST + 1, (int)listOf(pixels, *radius, layer, point).size());
            EXPECT_EQ(1001, (int)listOf(pixels, *knn, layer, point).size());
            EXPECT_EQ(std::min(100 << layer, (int)WIDEST) + 1,
                      (int)listOf(pixels, *some, layer, point).size());
        }
    EXPECT_LE(edgesOf(*radius, pixels.context()).size(), (size_t)LINKS * 1500);
    EXPECT_LE(edgesOf(*knn, pixels.context()).size(), (size_t)LINKS * 1500);
}

void checkEdges(const Pixels& pixels, Neighborhood& neighborhood, int links)
{
    const std::vector<Vec2i> edges = edgesOf(neighborhood, pixels.context());
    std::set<std::pair<int, int>> seen;
    std::vector<double> reach(pixels.size());
    for (int i = 0; i < pixels.size(); ++i)
        reach[i] = pixels.sorted(i)[std::min(links, pixels.size() - 1)] * (1 + 1e-4) + 1e-6;
    for (size_t e = 0; e < edges.size(); ++e)
    {
        const int i = edges[e][0], j = edges[e][1];
        ASSERT_TRUE(i >= 0 && j >= 0 && i < pixels.size() && j < pixels.size() && i != j);
        EXPECT_TRUE(seen.insert(std::make_pair(std::min(i, j), std::max(i, j))).second)
            << i << " - " << j << " twice";
        EXPECT_LE(pixels.distance(i, j), std::max(reach[i], reach[j]));
    }
    int missing = 0;
    // if a member is certainly among the nearest neighbors of point i, an edge must join the two
    for (int i = 0; i < pixels.size(); ++i)
    {
        const std::vector<int> members = listOf(pixels, neighborhood, 0, i);
        for (size_t k = 1; k < members.size() && (int)k <= links; ++k)
            if (pixels.distance(i, members[k]) < reach[i] * (1 - 3e-4) - 3e-6)
                missing += !seen.count(
                    std::make_pair(std::min(i, members[k]), std::max(i, members[k])));
    }
    EXPECT_EQ(0, missing);
    EXPECT_LE(edges.size(), (size_t)links * pixels.size());
    EXPECT_EQ(edges, edgesOf(neighborhood, pixels.context()));
}

TEST(Usac_NeighborhoodFlann, edges)
{
    RNG rng(3);
    for (int count = 1; count <= 700; count = count * 4 + 1)
    {
        std::vector<Point2d> points1, points2;
        clumsyPoints(count, rng, points1, points2);
        const OwnPoints own(HOMOGRAPHY, points1, points2);
        const Pixels pixels(own);
        checkEdges(pixels, *createKnnNeighborhood(3), 3);
        checkEdges(pixels, *createKnnNeighborhood(10), LINKS);
        checkEdges(pixels, *createRadiusNeighborhood(0.1), LINKS);
    }
}

TEST(Usac_NeighborhoodFlann, equalAndFarPoints)
{
    std::vector<Point2d> points1(37, Point2d(-3, 4)), points2(37, Point2d(0, 1));
    points1.push_back(Point2d(1e200, -1e200));
    points2.push_back(Point2d(-1e300, 0));
    const OwnPoints own(HOMOGRAPHY, points1, points2);
    const Params params;
    const Surroundings around(own.view(), params);
    const Ptr<Neighborhood> knn = createKnnNeighborhood(5), radius = createRadiusNeighborhood(1e-3);
    for (int i = 0; i < 37; ++i)
    {
        EXPECT_EQ(1u, membersOf(*knn, around.context, 0, i).count(i));
        EXPECT_EQ(6u, membersOf(*knn, around.context, 0, i).size());
        EXPECT_EQ(37u, membersOf(*radius, around.context, 3, i).size());
    }
    EXPECT_EQ(1u, membersOf(*radius, around.context, 3, 37).size());
    EXPECT_EQ(38u, membersOf(*knn, around.context, 3, 37).size());
    EXPECT_GE(edgesOf(*knn, around.context).size(), 37u * 5 / 2);
}

//! The result must be the same each time and must not use OpenCV's random generator.
TEST(Usac_NeighborhoodFlann, reproducible)
{
    const Pixels pixels(makeScene(FUNDAMENTAL), Params());
    const Ptr<Neighborhood> first = createKnnNeighborhood(7), second = createKnnNeighborhood(7);
    const uint64 before = theRNG().state;
    const std::vector<Vec2i> edges = edgesOf(*first, pixels.context());
    EXPECT_EQ(before, theRNG().state);
    theRNG().state = 12345;
    EXPECT_EQ(edges, edgesOf(*second, pixels.context()));
    for (int i = pixels.size() - 1; i >= 0; --i)
        EXPECT_EQ(listOf(pixels, *first, 2, i), listOf(pixels, *second, 2, i));
}

//! The radius must be in pixels, whatever multiple of the threshold (Params::reach) the search
//! uses.
TEST(Usac_NeighborhoodFlann, radiusDoesNotDependOnTheReach)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    int counts[2] = {0, 0};
    for (int r = 0; r < 2; ++r)
    {
        Params params;
        params.neighborhood = NEIGHBORHOOD_RADIUS;
        params.reach = r == 0 ? 1 : 4;
        const Ptr<Usac> usac = createUsac(scene, params);
        Arena arena;
        const Context context(usac->points(), usac->components(), params, arena);
        usac->components().start(context);
        for (int i = 0; i < scene.size(); ++i)
        {
            const int* members;
            counts[r] += usac->components().neighborhood->members(context, 0, i, members);
        }
    }
    EXPECT_GT(counts[0], scene.size());  // some points have neighbors
    EXPECT_NEAR(counts[0], counts[1], 2);
}

//! If the time limit of a run is reached before the kd-tree is built, a point must have no neighbor
//! except itself, and there must be no edges. The next run, which has enough time, must find all
//! neighbors.
TEST(Usac_NeighborhoodFlann, noTimeForTheTree)
{
    RNG rng(4);
    std::vector<Point2d> points1, points2;
    clumsyPoints(1000, rng, points1, points2);
    const OwnPoints own(HOMOGRAPHY, points1, points2);
    const Params params;
    const Components none;
    const Ptr<Neighborhood> knn = createKnnNeighborhood(5);
    for (int enough = 0; enough < 2; ++enough)
    {
        // a second has passed since the start of the run
        Watch watch(enough ? 1e6 : 1, (int64)getTickFrequency());
        Arena arena;
        const Context context(own.view(), none, params, arena, &watch);
        knn->start(context);
        const std::set<int> around = membersOf(*knn, context, 1, 37);
        EXPECT_EQ(enough ? 11u : 1u, around.size());
        EXPECT_EQ(1u, around.count(37));
        EXPECT_EQ(enough == 0, edgesOf(*knn, context).empty());
        EXPECT_EQ(enough == 0, watch.stopped());
    }
}

}  // namespace
}  // namespace opencv_test
