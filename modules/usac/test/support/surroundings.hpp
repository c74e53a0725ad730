// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_SURROUNDINGS_HPP
#define OPENCV_USACV20_TEST_SURROUNDINGS_HPP

#include <set>
#include "test_precomp.hpp"

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

}  // namespace opencv_test

#endif
