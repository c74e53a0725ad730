// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "optimization/cholesky.hpp"

namespace opencv_test {
namespace {

//! A symmetric matrix with the eigenvalues 1, step, step^2, ..., which is positive definite if
//! `step` is positive.
template <class Matrix>
Matrix positiveDefinite(int size, double step, RNG& random)
{
    Mat A(size, size, CV_64F), w, u, vt;
    random.fill(A, RNG::NORMAL, 0, 1);
    SVD::compute(A, w, u, vt);
    for (int i = 0; i < size; ++i)
        w.at<double>(i) = std::pow(step, i);
    const Mat product = u * Mat::diag(w) * u.t();
    return Eigen::Map<const Eigen::MatrixXd>(product.ptr<double>(), size, size);
}

template <int SIZE>
void solvesAndRefuses()
{
    typedef Eigen::Matrix<double, SIZE, SIZE> Matrix;
    typedef Eigen::Matrix<double, SIZE, 1> Vector;
    RNG random(SIZE);
    for (int i = 0; i < 100; ++i)
    {
        Matrix A = positiveDefinite<Matrix>(SIZE, 0.1, random);
        const Matrix given = A;
        const Vector expected = Vector::LinSpaced(SIZE, -1, 2);
        Vector x = given * expected;
        ASSERT_TRUE(solvePositiveDefinite(A, x));
        // the condition number times the rounding error times a margin of 10
        EXPECT_LE((x - expected).norm(), std::pow(10., SIZE - 1) * 1e-15);
        EXPECT_LE((given * x - given * expected).norm(), 1e-14);
    }
    for (double last : {0., -1., std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::infinity()})
    {
        Matrix A = Matrix::Identity();
        A(SIZE - 1, SIZE - 1) = last;
        Vector x = Vector::Ones();
        EXPECT_FALSE(solvePositiveDefinite(A, x)) << last;
    }
}

TEST(Usac_Cholesky, solves_and_refuses)
{
    solvesAndRefuses<1>();
    solvesAndRefuses<4>();
    solvesAndRefuses<8>();
    solvesAndRefuses<9>();
}

TEST(Usac_Cholesky, size_at_run_time)
{
    typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 9, 9> Matrix;
    typedef Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 9, 1> Vector;
    RNG random(1);
    for (int size = 1; size <= 9; ++size)
    {
        Matrix A = positiveDefinite<Matrix>(size, 0.5, random);
        const Vector expected = Vector::LinSpaced(size, -1, 2);
        Vector x = A * expected;
        EXPECT_TRUE(solvePositiveDefinite(A, x));
        EXPECT_LE((x - expected).norm(), 1e-12) << size;
        A = positiveDefinite<Matrix>(size + (size == 1), -0.5, random);
        EXPECT_FALSE(solvePositiveDefinite(A, x = Vector::Ones(A.rows()))) << size;
    }
}

}  // namespace
}  // namespace opencv_test
