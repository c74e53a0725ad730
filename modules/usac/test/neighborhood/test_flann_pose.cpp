// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/surroundings.hpp"
#include "neighborhood/neighborhood.hpp"
#include "problems/absolute_pose/pose_scenes.hpp"

namespace opencv_test {
namespace {

//! Radii are in pixels, but the coordinates of 3-D points are not. The neighbors of a match must
//! therefore be those of its image point, whatever the unit of the 3-D points is.
TEST(Usac_NeighborhoodFlann, ofAPoseAreInTheImage)
{
    for (double unit = 1e-3; unit < 2e3; unit *= 1e3)
    {
        PoseSceneOptions options;
        options.scale = unit;
        const PoseScene scene = makePoseScene(options);
        Params params;
        params.threshold = 2;
        const Ptr<Usac> usac = Usac::create(ABSOLUTE_POSE, scene.object, scene.image, params,
                                            scene.K);
        const Surroundings around(usac->points(), params);
        const Ptr<Neighborhood> knn = createKnnNeighborhood(6),
                                within = createRadiusNeighborhood(30);
        const Correspondences& p = usac->points();
        for (int i = 0; i < p.size; ++i)
        {
            std::vector<std::pair<double, int>> nearest;
            for (int j = 0; j < p.size; ++j)
            {
                const Point2d d = scene.image[p.inputIndex[i]] - scene.image[p.inputIndex[j]];
                nearest.push_back(std::make_pair(std::hypot(d.x, d.y), j));
            }
            std::sort(nearest.begin(), nearest.end());
            const std::set<int> found = membersOf(*knn, around.context, 0, i);
            ASSERT_EQ(7u, found.size());
            // a point that is not a member can be as far away as the seventh member
            for (int k = 0; k < 6; ++k)
                EXPECT_EQ(1u, found.count(nearest[k].second)) << unit << " " << i << " " << k;
            const std::set<int> close = membersOf(*within, around.context, 0, i);
            for (size_t k = 0; k < nearest.size(); ++k)
                if (std::abs(nearest[k].first - 30) > 0.01)
                {
                    EXPECT_EQ(nearest[k].first < 30, close.count(nearest[k].second) != 0);
                }
        }
    }
}

}  // namespace
}  // namespace opencv_test
