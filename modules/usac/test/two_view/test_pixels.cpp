// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "two_view/pixels.hpp"

namespace opencv_test {
namespace {

//! Points of image 1 with the given x coordinates, and the points to which H maps them, regardless
//! of the sign of their third homogeneous coordinate.
struct Mapped
{
    explicit Mapped(const std::vector<double>& xs) : H(1, 0, 3, 0, 1, -2, 0.01, 0, 1)
    {
        for (double x : xs)
        {
            const Vec3d to = H * Vec3d(x, 7, 1);
            points1.push_back(Point2d(x, 7));
            points2.push_back(Point2d(to[0] / to[2], to[1] / to[2]));
        }
    }

    const Matx33d H;
    Points points1, points2;
};

//! H maps the line x = -100 to infinity. On the side of this line where most points are, the
//! matches agree with H exactly. Points on the other side would be behind the camera, so that their
//! distances must be infinite. The sign of H must not matter.
TEST(Usac_Pixels, beyond_the_horizon)
{
    for (int most = 0; most < 2; ++most)
    {
        const Mapped mapped(most ? std::vector<double>({-500, 20, 50, 300, -101})
                                 : std::vector<double>({0, -200, -300, -400, -99}));
        for (double sign : {1., -1.})
        {
            const std::vector<double> found = mapDistances(mapped.H * sign, mapped.points1,
                                                           mapped.points2);
            ASSERT_EQ(5u, found.size());
            for (int i = 0; i < 5; ++i)
                if (i == 0 || i == 4)
                    EXPECT_EQ(HUGE_VAL, found[i]) << most << " " << i;
                else
                    EXPECT_LT(found[i], 1e-9) << most << " " << i;
        }
    }
}

//! A point that is not finite must not change the distances of the others.
TEST(Usac_Pixels, point_that_is_not_finite)
{
    for (double wrong : {(double)NAN, HUGE_VAL})
    {
        Mapped mapped({0, 20, 50, 30, 40});
        mapped.points1[3].x = mapped.points2[4].y = wrong;
        const std::vector<double> found = mapDistances(mapped.H, mapped.points1, mapped.points2);
        for (int i = 0; i < 3; ++i)
            EXPECT_LT(found[i], 1e-9) << i;
        EXPECT_EQ(HUGE_VAL, found[3]);
        EXPECT_EQ(HUGE_VAL, found[4]);
    }
}

TEST(Usac_Pixels, no_distances)
{
    const Mapped none((std::vector<double>())), some({0, 20, 50});
    EXPECT_TRUE(mapDistances(none.H, none.points1, none.points2).empty());
    for (double wrong : {(double)NAN, HUGE_VAL})
    {
        Matx33d H = some.H;
        H(2, 2) = wrong;
        EXPECT_EQ(std::vector<double>(3, HUGE_VAL), mapDistances(H, some.points1, some.points2));
    }
}

}  // namespace
}  // namespace opencv_test
