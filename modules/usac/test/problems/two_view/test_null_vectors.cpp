// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/two_view/null_vectors.hpp"

#include <Eigen/Dense>

namespace opencv_test {
namespace {

Eigen::Matrix3d orthogonal(RNG& rng)
{
    Eigen::Matrix3d A;
    for (int i = 0; i < 9; ++i)
        A.data()[i] = rng.gaussian(1);
    return Eigen::HouseholderQR<Eigen::Matrix3d>(A).householderQ();
}

TEST(Usac_NullVectors, agreeWithTheSingularVectors)
{
    RNG rng(1);
    for (int repeat = 0; repeat < 2000; ++repeat)
    {
        const Eigen::Matrix3d left = orthogonal(rng), right = orthogonal(rng);
        const double scale = std::pow(10., rng.uniform(-50., 50.)),
                     second = std::pow(10., rng.uniform(-2.5, 0.)),
                     third = repeat % 3 ? second * std::pow(10., rng.uniform(-15., -3.3)) : 0;
        const Eigen::Matrix3d M = scale * left * Eigen::Vector3d(1, second, third).asDiagonal() *
                                  right.transpose();
        Eigen::Matrix3d U, V;
        ASSERT_TRUE(completeNullVectors(M, U, V)) << second << " " << third;
        EXPECT_LT((U.transpose() * U - Eigen::Matrix3d::Identity()).norm(), 1e-14);
        EXPECT_LT((V.transpose() * V - Eigen::Matrix3d::Identity()).norm(), 1e-14);
        // rounding changes M by about 1e-16 of its size, and the vectors by this over `second`
        EXPECT_LT(U.col(2).cross(left.col(2)).norm(), 5e-14 / second);
        EXPECT_LT(V.col(2).cross(right.col(2)).norm(), 5e-14 / second);
    }
}

TEST(Usac_NullVectors, otherMatricesAreRefused)
{
    RNG rng(2);
    const double values[][3] = {{1, 1, 1},    {1, 0.5, 0.1},     {1, 0.1, 3e-4},
                                {1, 3e-4, 0}, {1, 3e-4, 2.9e-4}, {1, 0, 0},
                                {0, 0, 0},    {NAN, 1, 0},       {INFINITY, 1, 0}};
    for (const double(&value)[3] : values)
        for (int repeat = 0; repeat < 20; ++repeat)
        {
            const Eigen::Matrix3d M = orthogonal(rng) *
                                      Eigen::Vector3d(value[0], value[1], value[2]).asDiagonal() *
                                      orthogonal(rng);
            Eigen::Matrix3d U, V;
            EXPECT_FALSE(completeNullVectors(M, U, V)) << value[1] << " " << value[2];
        }
}

}  // namespace
}  // namespace opencv_test
