// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "scoring/common_neighbors.hpp"
#include "support/problem_objects.hpp"
#include "support/run_context.hpp"

// Tests of commonNeighbors(), which counts how many of the nearest neighbors of a match in image 1
// are also among its nearest neighbors in image 2.

namespace opencv_test {
namespace {

std::vector<int> commonOf(const std::vector<Point2d>& points1, const std::vector<Point2d>& points2,
                          double threshold = 1)
{
    Params params;
    params.threshold = threshold;
    params.degeneracy = 0;  // all points are kept, also copies
    const Ptr<Usac> usac = Usac::create(FUNDAMENTAL, points1, points2, params);
    const Correspondences& points = usac->points();
    std::vector<uchar> common(points.size + 1, 77);
    Arena arena;
    commonNeighbors(points, points.size, points.threshold, common.data(), arena);
    EXPECT_EQ(77, common.back());
    std::vector<int> result(points.size);
    for (int i = 0; i < points.size; ++i)
        result[points.inputIndex[i]] = common[i];
    return result;
}

//! The nearest neighbors of the match `center` in the image of `points`, found by sorting all
//! matches. `others` are the points of the other image. Matches within `threshold` of `center` in
//! either image are not neighbors.
std::set<int> nearest(const std::vector<Point2d>& points, const std::vector<Point2d>& others,
                      int center, double threshold)
{
    std::vector<std::pair<double, int>> sorted;
    for (int i = 0; i < (int)points.size(); ++i)
        if (cv::norm(points[i] - points[center]) > threshold &&
            cv::norm(others[i] - others[center]) > threshold)
            sorted.push_back(std::make_pair(cv::norm(points[i] - points[center]), i));
    std::sort(sorted.begin(), sorted.end());
    std::set<int> result;
    for (int k = 0; k < std::min((int)sorted.size(), NEIGHBORS_COMPARED); ++k)
        result.insert(sorted[k].second);
    return result;
}

//! Matches of random points of image 1. For two thirds of them, a smooth map gives the point of
//! image 2; for the others, it is random.
void makeMatches(int count, uint64 seed, std::vector<Point2d>& points1,
                 std::vector<Point2d>& points2)
{
    RNG rng(seed);
    for (int i = 0; i < count; ++i)
    {
        const Point2d a(rng.uniform(0., 640.), rng.uniform(0., 480.));
        points1.push_back(a);
        points2.push_back(i % 3 ? Point2d(1.1 * a.x + 0.1 * a.y + 20 * std::sin(a.x / 200), a.y - 9)
                                : Point2d(rng.uniform(0., 640.), rng.uniform(0., 480.)));
    }
}

TEST(Usac_CommonNeighbors, against_sorted_distances)
{
    for (int count : {8, 9, 10, 50, 200})
    {
        std::vector<Point2d> points1, points2;
        makeMatches(count, count, points1, points2);
        if (count == 200)  // moves matches close to others in both images, or in image 1 only
            for (int i = 0; i < 20; ++i)
            {
                points1[i] = points1[20 + i] + Point2d(0.01 * i, 0.3);
                if (i % 2)
                    points2[i] = points2[20 + i] + Point2d(0.2, 0.01 * i);
            }
        const std::vector<int> found = commonOf(points1, points2);
        for (int i = 0; i < count; ++i)
        {
            const std::set<int> first = nearest(points1, points2, i, 1),
                                second = nearest(points2, points1, i, 1);
            int expected = 0;
            for (int k : first)
                expected += (int)second.count(k);
            EXPECT_EQ(expected, found[i]) << count << " " << i;
        }
    }
}

TEST(Usac_CommonNeighbors, same_points)
{
    const std::vector<Point2d> same(30, Point2d(3, 4));
    EXPECT_EQ(std::vector<int>(30, 0), commonOf(same, same));
    std::vector<Point2d> line;
    for (int i = 0; i < 30; ++i)
        line.push_back(Point2d(7, 20 * i));
    EXPECT_EQ(std::vector<int>(30, NEIGHBORS_COMPARED), commonOf(line, line));
    EXPECT_EQ(std::vector<int>(30, 0), commonOf(line, same));
}

TEST(Usac_CommonNeighbors, numberOfMatches)
{
    std::vector<Point2d> points1, points2;
    makeMatches(MATCHES_COMPARED + 1, 1, points1, points2);
    EXPECT_THROW(commonOf(points1, points2), cv::Exception);
    points1.pop_back();
    points2.pop_back();
    EXPECT_EQ(points1.size(), commonOf(points1, points2).size());
}

TEST(Usac_CommonNeighbors, problems)
{
    for (int type = HOMOGRAPHY; type <= TRANSLATION_2D; ++type)
        EXPECT_EQ(type == FUNDAMENTAL, hasCommonNeighbors(problemObject((ProblemType)type)))
            << type;
}

}  // namespace
}  // namespace opencv_test
