// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/absolute_pose/triangle_depths.hpp"

namespace opencv_test {
namespace {

//! An isosceles triangle, seen from its plane of symmetry. a12 and a13 are the squared lengths of
//! the equal sides (`side`), in the unit in which a23 is 1. s12, s13 and s23, the squared distances
//! between the unit vectors of two viewing rays, are proportional to `ray`, `ray` and `base`.
Triangle isosceles(double side, double ray, double base, double sigma)
{
    const double largest = std::max(ray, base);
    const Triangle T = {side, side, ray / largest, ray / largest, base / largest, sigma};
    return T;
}

//! Determinant of the conic a23 Q12 - a12 Q23 in p, q, w (see TriangleDepths), where a_ij = Q_ij
//! are the three equations in violation(), with a23 = 1.
double determinantOf(const Triangle& T)
{
    const double s = T.sigma, pq = T.a12 * (1 - s * s * T.s23 / 2),
                 pw = s * (T.s12 - T.a12 * T.s23) / 2, qw = -s * T.a12 * T.s23 / 2;
    return determinant(Matx33d(1 - T.a12, pq, pw, pq, -T.a12, qw, pw, qw, T.s12 - T.a12 * T.s23));
}

//! Largest absolute error of the three equations that TriangleDepths documents.
double violation(const Triangle& T, const TriangleDepths& d)
{
    const double w2 = d.w + T.sigma * d.p, w3 = d.w + T.sigma * d.q;
    return std::max(std::abs(d.p * d.p + T.s12 * d.w * w2 - T.a12),
                    std::max(std::abs(d.q * d.q + T.s13 * d.w * w3 - T.a13),
                             std::abs((d.p - d.q) * (d.p - d.q) + T.s23 * w2 * w3 - 1)));
}

void expectSolutions(const Triangle& T, int count, const TriangleDepths* depths)
{
    for (int i = 0; i < count; ++i)
    {
        const double size = std::abs(depths[i].p) + std::abs(depths[i].q) + depths[i].w;
        EXPECT_LE(violation(T, depths[i]), 1e-12 * size * size);
        EXPECT_GT(depths[i].w, 0);
        EXPECT_GT(depths[i].w + T.sigma * depths[i].p, 0);
        EXPECT_GT(depths[i].w + T.sigma * depths[i].q, 0);
    }
}

/** For an isosceles triangle, the two conics a23 Q12 - a12 Q23 and a23 Q13 - a13 Q23 are mirror
images. If one is degenerate, so is the other, and the cubic of their pencil has neither a constant
nor a leading coefficient. The number of solutions must nevertheless be that of a nearby
triangle. */
TEST(Usac_TriangleDepths, bothConicsDegenerate)
{
    RNG rng(2);
    int found = 0, total = 0;
    while (found < 100)
    {
        const double ray = rng.uniform(0.05, 1.), base = rng.uniform(0.05, 1.),
                     sigma = rng.uniform(0.05, 1.4);
        double low = rng.uniform(0.26, 1.), high = std::min(1., low + rng.uniform(0., 0.2));
        const bool below = determinantOf(isosceles(low, ray, base, sigma)) < 0;
        if (below == (determinantOf(isosceles(high, ray, base, sigma)) < 0))
            continue;
        for (int k = 0; k < 80; ++k)
        {
            const double middle = 0.5 * (low + high);
            ((determinantOf(isosceles(middle, ray, base, sigma)) < 0) == below ? low
                                                                               : high) = middle;
        }
        ++found;
        TriangleDepths depths[MAX_TRIANGLE_DEPTHS], nearby[MAX_TRIANGLE_DEPTHS];
        const Triangle T = isosceles(low, ray, base, sigma);
        const int count = solveTriangle(T, depths);
        expectSolutions(T, count, depths);
        EXPECT_EQ(solveTriangle(isosceles(low * (1 + 1e-5), ray, base, sigma), nearby), count)
            << "side " << low << ", rays " << ray << " and " << base << ", sigma " << sigma;
        total += count;
    }
    EXPECT_GT(total, 200);
}

//! For each of these triangles, three of the at most four positions coincide. For such a triple
//! root, one of the formulas of solveTriangle() gives p : q : w = 0 : 0 : 0, which is not a
//! position. The triple position must be found once.
TEST(Usac_TriangleDepths, threePositionsCoincide)
{
    for (double side : {1 / 16., 2 / 16., 3 / 16., 4 / 16., 5 / 16.})
    {
        const Triangle T = {side, 1, 3 * side, 1, 1, 1};
        TriangleDepths depths[MAX_TRIANGLE_DEPTHS];
        ASSERT_EQ(1, solveTriangle(T, depths)) << side;
        expectSolutions(T, 1, depths);
        EXPECT_NEAR(0, depths[0].p, 1e-7);
        EXPECT_NEAR(std::sqrt(1 / 3.), depths[0].q, 1e-7);
        EXPECT_NEAR(std::sqrt(1 / 3.), depths[0].w, 1e-7);
    }
}

}  // namespace
}  // namespace opencv_test
