// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/eigenvalues.hpp"
#include "numeric/polynomial.hpp"

namespace opencv_test {
namespace {

//! Coefficients of the product of (x - root) over all roots, the constant term first.
std::vector<double> expand(const std::vector<double>& roots)
{
    std::vector<double> c(1, 1.);
    for (size_t k = 0; k < roots.size(); ++k)
    {
        c.push_back(0);
        for (size_t i = c.size() - 1; i > 0; --i)
            c[i] = c[i - 1] - roots[k] * c[i];
        c[0] *= -roots[k];
    }
    return c;
}

std::vector<double> findRoots(const std::vector<double>& c)
{
    double roots[MAX_DEGREE + 1];
    const int count = realRoots(c.data(), (int)c.size() - 1, roots);
    EXPECT_GE(count, 0);
    EXPECT_LT(count, (int)c.size());
    std::vector<double> result(roots, roots + count);
    std::sort(result.begin(), result.end());
    return result;
}

void expectRoots(const std::vector<double>& c, std::vector<double> expected, double tolerance)
{
    std::sort(expected.begin(), expected.end());
    const std::vector<double> found = findRoots(c);
    ASSERT_EQ(expected.size(), found.size())
        << "roots " << Mat(expected).t() << " found " << Mat(found).t();
    for (size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(expected[i], found[i], tolerance * std::max(1., std::abs(expected[i])))
            << Mat(expected).t();
}

TEST(Usac_Polynomial, spreadRoots)
{
    RNG rng(11);
    for (int degree = 1; degree <= MAX_DEGREE; ++degree)
        for (int repeat = 0; repeat < 50; ++repeat)
        {
            std::vector<double> roots(degree);
            for (int i = 0; i < degree; ++i)  // no two roots are closer than 0.3
                roots[i] = -2.5 + 5. * (i + rng.uniform(0.1, 0.5)) / degree;
            std::vector<double> c = expand(roots);
            const double factor = std::pow(10., rng.uniform(-30., 30.)) * (repeat % 2 ? 1 : -1);
            for (size_t i = 0; i < c.size(); ++i)
                c[i] *= factor;
            expectRoots(c, roots, 1e-7);
        }
}

//! Each multiple root must be found once, with the accuracy that is possible for such a root.
TEST(Usac_Polynomial, multipleRoots)
{
    const double twice[] = {0.5, 0.5}, doubleZero[] = {0, 0, 0.25}, outside[] = {3, 3, -0.5};
    std::vector<double> found = findRoots(expand(std::vector<double>(twice, twice + 2)));
    ASSERT_EQ(1u, found.size());
    EXPECT_NEAR(0.5, found[0], 1e-6);
    found = findRoots(expand(std::vector<double>(doubleZero, doubleZero + 3)));
    ASSERT_EQ(2u, found.size());
    EXPECT_NEAR(0, found[0], 1e-6);
    EXPECT_NEAR(0.25, found[1], 1e-6);
    found = findRoots(expand(std::vector<double>(outside, outside + 3)));
    ASSERT_EQ(2u, found.size());
    EXPECT_NEAR(-0.5, found[0], 1e-6);
    EXPECT_NEAR(3, found[1], 1e-5);
}

//! The derivative of x^n - a^n has only the root 0, of multiplicity n - 1. Roots of derivatives
//! bracket the roots of a polynomial, all of which must be found nevertheless.
TEST(Usac_Polynomial, sparse)
{
    for (int degree = 2; degree <= MAX_DEGREE; ++degree)
    {
        const double values[] = {0.5, 1, 2};
        for (int k = 0; k < 3; ++k)
        {
            std::vector<double> c(degree + 1, 0.), roots(1, values[k]);
            c[degree] = 1;
            c[0] = -std::pow(values[k], degree);
            if (degree % 2 == 0)
                roots.push_back(-values[k]);
            SCOPED_TRACE(cv::format("x^%d = %g^%d", degree, values[k], degree));
            expectRoots(c, roots, 1e-9);
        }
    }
    RNG rng(6);
    // nearly sparse polynomials, which symmetric arrangements of points lead to
    for (int repeat = 0; repeat < 1000; ++repeat)
    {
        std::vector<double> c(4 + repeat % 7, 0.), clean;
        c.back() = 1;
        c[0] = -rng.uniform(0.1, 3.);
        clean = c;
        const double noise = std::pow(10., rng.uniform(-17., -9.));
        for (size_t i = 0; i < c.size(); ++i)
            c[i] += rng.gaussian(noise);
        std::vector<double> roots(1, std::pow(-clean[0], 1. / (c.size() - 1)));
        if (c.size() % 2)
            roots.push_back(-roots[0]);
        SCOPED_TRACE(cv::format("degree %d, noise %g", (int)c.size() - 1, noise));
        expectRoots(c, roots, 1e-7);
    }
    const double quartic[] = {
        -0.05, 0.1, 0, 0,
        // The coefficients have one change of sign, so that there is one positive root (Descartes'
        // rule). The same holds for -x, so that there is one negative root.
        1};
    EXPECT_EQ(2u, findRoots(std::vector<double>(quartic, quartic + 5)).size());
}

TEST(Usac_Polynomial, lowerDegree)
{
    std::vector<double> c(4, 0.);
    c[0] = -3;
    c[1] = 2;
    expectRoots(c, std::vector<double>(1, 1.5), 1e-12);
    c.assign(11, 0.);
    c[0] = -2;
    c[2] = 1;
    std::vector<double> roots(2, std::sqrt(2.));
    roots[1] = -roots[1];
    expectRoots(c, roots, 1e-12);
    c.assign(11, 0.);
    c[3] = 1;
    expectRoots(c, std::vector<double>(1, 0.), 1e-9);
}

TEST(Usac_Polynomial, noRoots)
{
    const double square[] = {1, 0, 1}, quartic[] = {2, 1, 3, 1, 2};
    EXPECT_TRUE(findRoots(std::vector<double>(square, square + 3)).empty());
    EXPECT_TRUE(findRoots(std::vector<double>(quartic, quartic + 5)).empty());
    EXPECT_TRUE(findRoots(std::vector<double>(4, 0.)).empty());
    EXPECT_TRUE(findRoots(std::vector<double>(1, 5.)).empty());
    std::vector<double> bad(4, 1.);
    bad[2] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(findRoots(bad).empty());
    bad[2] = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(findRoots(bad).empty());
}

//! The complex roots as eigenvalues of the companion matrix.
std::vector<std::complex<long double>> companionRoots(const std::vector<double>& c)
{
    const int degree = (int)c.size() - 1;
    MatrixXl C = MatrixXl::Zero(degree, degree);
    for (int i = 0; i < degree; ++i)
    {
        if (i > 0)
            C(i, i - 1) = 1;
        C(i, degree - 1) = -c[i] / c[degree];
    }
    const MatrixXcl roots = eigenvaluesOf(C);
    return std::vector<std::complex<long double>>(roots.data(), roots.data() + degree);
}

TEST(Usac_Polynomial, asManyAsTheCompanionMatrix)
{
    RNG rng(5);
    int compared = 0, total = 0;
    for (int repeat = 0; repeat < 4000; ++repeat)
    {
        const int degree = 3 + repeat % 8;
        std::vector<double> c(degree + 1), expected;
        for (int i = 0; i <= degree; ++i)
            c[i] = rng.gaussian(1) * std::pow(10., rng.uniform(-1., 1.));
        const std::vector<std::complex<long double>> all = companionRoots(c);
        bool clear = true;  // no two roots are so close that rounding decides whether they are real
        for (size_t i = 0; i < all.size(); ++i)
        {
            const double size = std::max(1e-3, (double)std::abs(all[i]));
            if (all[i].imag() == 0)
                expected.push_back((double)all[i].real());
            else
                clear = clear && std::abs(all[i].imag()) > 1e-5 * size;
            for (size_t j = 0; j < i; ++j)
                clear = clear && std::abs(all[i] - all[j]) > 1e-5 * size;
        }
        if (!clear)
            continue;
        ++compared;
        total += (int)expected.size();
        expectRoots(c, expected, 1e-6);
    }
    EXPECT_GT(compared, 3900);
    EXPECT_GT(total, 2 * compared);  // random polynomials of degree 3 .. 10 have more than two real
                                     // roots on average
}

}  // namespace
}  // namespace opencv_test
