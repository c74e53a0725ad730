// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_SURROUNDINGS_HPP
#define OPENCV_USACV20_TEST_SURROUNDINGS_HPP

#include <set>
#include "test_precomp.hpp"
#include "support/run_context.hpp"

namespace opencv_test {

//! Matches of points around 0. Every fifth match copies an earlier one. Of the points of image 1,
//! one in 50 has coordinates of up to 30 before copying, the others of up to 1.
inline void clumsyPoints(int count, RNG& rng, std::vector<Point2d>& points1,
                         std::vector<Point2d>& points2)
{
    points1.clear();
    points2.clear();
    for (int i = 0; i < count; ++i)
    {
        const double reach = i % 50 == 7 ? 30 : 1;
        points1.push_back(uniformPoint(rng, -reach, reach));
        points2.push_back(points1.back() * 0.8 + gaussianPoint(rng, 0.2));
        if (i > 0 && i % 5 == 0)
        {
            const int other = rng.uniform(0, i);
            points1[i] = points1[other];
            points2[i] = points2[other];
        }
    }
}

//! A context without components, for neighborhoods and orderings, which need only the points, the
//! parameters and an arena.
struct Surroundings
{
    explicit Surroundings(const Correspondences& points, const Params& params_ = Params())
        : params(params_), context(points, components, params, arena)
    {}

    Params params;
    Components components;
    Arena arena;
    Context context;
};

//! The neighbors of a point in a layer of the neighborhood. The test fails if a neighbor is
//! repeated.
inline std::set<int> membersOf(Neighborhood& neighborhood, const Context& context, int layer,
                               int point)
{
    const int* members = 0;
    const int count = neighborhood.members(context, layer, point, members);
    const std::set<int> result(members, members + count);
    EXPECT_EQ(count, (int)result.size()) << "a member is repeated";
    return result;
}

/** Members and edges must not depend on whether edges of the first points were requested before,
and the edges of the first points must be those of a neighborhood that knows only these points.
@param create function that creates the neighborhood */
template <class Create>
void checkFirstPoints(const Create& create)
{
    RNG rng(12);
    std::vector<Point2d> points1, points2;
    clumsyPoints(400, rng, points1, points2);
    const OwnPoints points(HOMOGRAPHY, points1, points2);
    const Surroundings all(points.view());
    const std::vector<Vec2i> expected = edgesOf(*create(), all.context);
    const std::set<int> members = membersOf(*create(), all.context, 1, 8);
    EXPECT_GT(expected.size(), 300u);
    EXPECT_GT(members.size(), 1u);
    for (int order = 0; order < 2; ++order)
    {
        const Ptr<Neighborhood> neighborhood = create();
        for (int size : {100, 400, 30, 300})
        {
            if (order == 1)
            {
                EXPECT_EQ(members, membersOf(*neighborhood, all.context, 1, 8));
            }
            Correspondences part = points.view();
            part.size = size;
            const Surroundings first(part);
            const Context context(part, all.components, all.params, all.context.arena);
            const std::vector<Vec2i> edges = edgesOf(*neighborhood, context);
            EXPECT_EQ(edgesOf(*create(), first.context), edges) << size << " points";
            EXPECT_FALSE(edges.empty());
        }
        EXPECT_EQ(expected, edgesOf(*neighborhood, all.context));
        EXPECT_EQ(members, membersOf(*neighborhood, all.context, 1, 8));
    }
}

}  // namespace opencv_test

#endif
