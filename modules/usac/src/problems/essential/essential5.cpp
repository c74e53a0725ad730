// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "core/elimination.hpp"
#include "problems/essential/essential_basis.hpp"
#include "core/polynomial.hpp"
#include "problems/essential/essential.hpp"

namespace cv {
namespace usacv20 {

namespace {

/* Polynomials in x, y, z as arrays of coefficients.
Linear[4]:     x y z 1
Quadratic[10]: x2 xy xz x y2 yz y z2 z 1
Cubic[20]:     x3 y3 x2y xy2 x2z x2 y2z y2 xyz xy | xz2 xz x yz2 yz y z3 z2 z 1, in the order of
@cite nister2004efficient */

//! q += f a b
void addProduct(const double* a, const double* b, double f, double* q)
{
    q[0] += f * a[0] * b[0];
    q[1] += f * (a[0] * b[1] + a[1] * b[0]);
    q[2] += f * (a[0] * b[2] + a[2] * b[0]);
    q[3] += f * (a[0] * b[3] + a[3] * b[0]);
    q[4] += f * a[1] * b[1];
    q[5] += f * (a[1] * b[2] + a[2] * b[1]);
    q[6] += f * (a[1] * b[3] + a[3] * b[1]);
    q[7] += f * a[2] * b[2];
    q[8] += f * (a[2] * b[3] + a[3] * b[2]);
    q[9] += f * a[3] * b[3];
}

//! c += q a, quadratic times linear
void addCubic(const double* q, const double* a, double* c)
{
    c[0] += q[0] * a[0];
    c[1] += q[4] * a[1];
    c[2] += q[0] * a[1] + q[1] * a[0];
    c[3] += q[1] * a[1] + q[4] * a[0];
    c[4] += q[0] * a[2] + q[2] * a[0];
    c[5] += q[0] * a[3] + q[3] * a[0];
    c[6] += q[4] * a[2] + q[5] * a[1];
    c[7] += q[4] * a[3] + q[6] * a[1];
    c[8] += q[1] * a[2] + q[2] * a[1] + q[5] * a[0];
    c[9] += q[1] * a[3] + q[3] * a[1] + q[6] * a[0];
    c[10] += q[2] * a[2] + q[7] * a[0];
    c[11] += q[2] * a[3] + q[3] * a[2] + q[8] * a[0];
    c[12] += q[3] * a[3] + q[9] * a[0];
    c[13] += q[5] * a[2] + q[7] * a[1];
    c[14] += q[5] * a[3] + q[6] * a[2] + q[8] * a[1];
    c[15] += q[6] * a[3] + q[9] * a[1];
    c[16] += q[7] * a[2];
    c[17] += q[7] * a[3] + q[8] * a[2];
    c[18] += q[8] * a[3] + q[9] * a[2];
    c[19] += q[9] * a[3];
}

//! The ten cubic constraints on E = x X + y Y + z Z + W: det E = 0 and E E^T E - trace(E E^T) E / 2
//! = 0.
void constraints(const double (&basis)[4][9], double (&C)[10][20])
{
    double E[9][4];
    for (int i = 0; i < 9; ++i)
        for (int k = 0; k < 4; ++k)
            E[i][k] = basis[k][i];

    double S[3][3][10] = {{{0}}};  // E E^T - trace / 2, symmetric
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                addProduct(E[3 * i + k], E[3 * j + k], 1, S[i][j]);
    for (int n = 0; n < 10; ++n)
    {
        const double half = (S[0][0][n] + S[1][1][n] + S[2][2][n]) / 2;
        for (int i = 0; i < 3; ++i)
            S[i][i][n] -= half;
    }
    std::fill(&C[0][0], &C[0][0] + 200, 0.0);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                addCubic(S[std::min(i, k)][std::max(i, k)], E[3 * k + j], C[3 * i + j]);

    for (int k = 0; k < 3; ++k)  // determinant along the first row
    {
        double minor[10] = {0};
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        addProduct(E[3 + a], E[6 + b], 1, minor);
        addProduct(E[3 + b], E[6 + a], -1, minor);
        addCubic(minor, E[k], C[9]);
    }
}

/** Gaussian elimination of the left 10x10 block with partial pivoting; only the last six rows,
which the solver uses, are brought to reduced form. @return the smallest pivot relative to the
largest coefficient; 0 if the block is singular */
double eliminate(double (&C)[10][20])
{
    double largest = 0, least = DBL_MAX;
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j)
            largest = std::max(largest, std::abs(C[i][j]));
    for (int k = 0; k < 10; ++k)
    {
        int pivot = k;
        for (int i = k + 1; i < 10; ++i)
            if (std::abs(C[i][k]) > std::abs(C[pivot][k]))
                pivot = i;
        least = std::min(least, std::abs(C[pivot][k]));
        if (!(std::abs(C[pivot][k]) > 1e-13 * largest))  // also for NaN
            return 0;
        if (pivot != k)
            std::swap_ranges(C[pivot] + k, C[pivot] + 20, C[k] + k);
        const double inverse = 1 / C[k][k];
        for (int j = k + 1; j < 20; ++j)
            C[k][j] *= inverse;
        for (int i = k < 4 ? k + 1 : 4; i < 10; ++i)
        {
            if (i == k)
                continue;
            const double factor = C[i][k];
            for (int j = (k + 1) & ~1; j < 20; ++j)  // from an even column, for vector code
                C[i][j] -= factor * C[k][j];
        }
    }
    return least / largest;
}

/** A row of the 3x3 matrix B(z) with B(z) (x, y, 1)^T = 0: the row of (monomial z) minus z times
the row of (monomial). Coefficients from the constant upwards; degrees 3, 3 and 4. */
void linkRows(const double* withZ, const double* without, double (&B)[3][5])
{
    for (int k = 0; k < 2; ++k)
    {
        const double *e = withZ + 10 + 3 * k, *f = without + 10 + 3 * k;
        const double b[5] = {e[2], e[1] - f[2], e[0] - f[1], -f[0], 0};
        std::copy(b, b + 5, B[k]);
    }
    const double *e = withZ + 16, *f = without + 16;
    const double b[5] = {e[3], e[2] - f[3], e[1] - f[2], e[0] - f[1], -f[0]};
    std::copy(b, b + 5, B[2]);
}

//! result += sign a b c for polynomials in z of degree 3, 3 and 4
void addProduct3(const double* a, const double* b, const double* c, double sign, double* result)
{
    double ab[7] = {0};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            ab[i + j] += a[i] * b[j];
    for (int i = 0; i < 7; ++i)
        for (int j = 0; j < 5; ++j)
            result[i + j] += sign * ab[i] * c[j];
}

double horner(const double* c, double z)
{
    return (((c[4] * z + c[3]) * z + c[2]) * z + c[1]) * z + c[0];
}

//! (x, y, 1) in the null space of B(z), from the cross product of two rows with the largest third
//! entry. False if x or y is (nearly) infinite.
bool backSubstitute(const double (&B)[3][3][5], double z, double& x, double& y)
{
    double v[3][3];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            v[i][j] = horner(B[i][j], z);
    double best = 0;
    x = y = 0;
    for (int i = 0; i < 3; ++i)
    {
        const double *a = v[i], *b = v[(i + 1) % 3];
        const double w = a[0] * b[1] - a[1] * b[0];
        if (std::abs(w) > best)
        {
            best = std::abs(w);
            x = (a[1] * b[2] - a[2] * b[1]) / w;
            y = (a[2] * b[0] - a[0] * b[2]) / w;
        }
    }
    return best > 0 && std::abs(x) < 1e12 && std::abs(y) < 1e12;
}

//! Adds to sums[i] the terms first..last-1 of the i-th constraint: its coefficients times the
//! values of the monomials.
inline void addRows(const double (&T)[20][10], const double* values, int first, int last,
                    double* sums)
{
    for (int k = first; k < last; ++k)
        for (int i = 0; i < 10; ++i)
            sums[i] += values[k] * T[k][i];
}

//! Residuals of the constraints for E of unit norm: below EXACT, no correction is needed; from
//! VIOLATED on, E is no essential matrix.
constexpr double EXACT = 1e-12, VIOLATED = 1e-9;

//! Computes the residuals r of the ten constraints at (x, y, z). @return the largest absolute value
double violation(const double (&T)[20][10], double x, double y, double z, double (&r)[10])
{
    const double m[20] = {x * x * x, y * y * y, x * x * y, x * y * y, x * x * z, x * x, y * y * z,
                          y * y,     x * y * z, x * y,     x * z * z, x * z,     x,     y * z * z,
                          y * z,     y,         z * z * z, z * z,     z,         1};
    std::fill(r, r + 10, 0.);
    addRows(T, m, 0, 20, r);
    double largest = 0;
    for (int i = 0; i < 10; ++i)
        largest = std::max(largest, std::abs(r[i]));
    return largest;
}

//! Gauss-Newton step on the ten constraints; zero if it is not determined.
Vec3d stepOf(const double (&T)[20][10], double x, double y, double z, const double (&r)[10])
{
    const double mx[20] = {3 * x * x, 0,     2 * x * y, y * y, 2 * x * z, 2 * x, 0,
                           0,         y * z, y,         z * z, z,         1};
    const double my[20] = {0,     3 * y * y, x * x, 2 * x * y, 0, 0,     2 * y * z, 2 * y,
                           x * z, x,         0,     0,         0, z * z, z,         1};
    const double mz[20] = {0,         0, 0, 0,         x * x, 0, y * y,     0,     x * y, 0,
                           2 * x * z, x, 0, 2 * y * z, y,     0, 3 * z * z, 2 * z, 1};
    double gx[10] = {0}, gy[10] = {0}, gz[10] = {0};
    addRows(T, mx, 0, 13, gx);
    addRows(T, my, 1, 16, gy);
    addRows(T, mz, 4, 19, gz);
    Matx33d A = Matx33d::zeros();
    Vec3d b;
    for (int i = 0; i < 10; ++i)
    {
        A(0, 0) += gx[i] * gx[i];
        A(0, 1) += gx[i] * gy[i];
        A(0, 2) += gx[i] * gz[i];
        A(1, 1) += gy[i] * gy[i];
        A(1, 2) += gy[i] * gz[i];
        A(2, 2) += gz[i] * gz[i];
        b[0] += gx[i] * r[i];
        b[1] += gy[i] * r[i];
        b[2] += gz[i] * r[i];
    }
    A(1, 0) = A(0, 1);
    A(2, 0) = A(0, 2);
    A(2, 1) = A(1, 2);
    return A.inv() * b;
}

/** Gauss-Newton method on the ten constraints in x, y and z. It restores the digits that the
elimination loses if its pivots are small.
@param T coefficients of the constraints, a row for each monomial
@param length of Z; those of X, Y and W are 1
@param x, y, z solution, input and output
@return largest absolute residual of the constraints */
double correct(const double (&T)[20][10], double length, double& x, double& y, double& z)
{
    enum { STEPS = 4 };
    for (int k = 0;; ++k)
    {
        double r[10];
        const double squared = 1 + x * x + y * y + length * length * z * z,
                     left = violation(T, x, y, z, r);
        if (left < EXACT * squared * std::sqrt(squared) || k == STEPS)
            return left;
        const Vec3d step = stepOf(T, x, y, z, r);
        if (!(step[0] * step[0] + step[1] * step[1] + length * length * step[2] * step[2] <
              0.1 * squared))  // also for NaN
            return left;
        x -= step[0];
        y -= step[1];
        z -= step[2];
    }
}

//! The constraints on E = x X + y Y + z Z + W, before and after the elimination.
struct System
{
    //! @return see eliminate()
    double build(const EssentialBasis& basis)
    {
        double C[10][20];
        constraints(basis, C);
        for (int k = 0; k < 20; ++k)
            for (int i = 0; i < 10; ++i)
                transposed[k][i] = C[i][k];
        const double pivot = eliminate(C);
        for (int k = 0; k < 3; ++k)
            linkRows(C[4 + 2 * k], C[5 + 2 * k], B[k]);
        return pivot;
    }

    //! Determinant of B(z), degree 10.
    void determinant(double (&result)[11]) const
    {
        std::fill(result, result + 11, 0.);
        for (int i = 0; i < 3; ++i)
        {
            const int a = (i + 1) % 3, b = (i + 2) % 3;
            addProduct3(B[a][0], B[b][1], B[i][2], 1, result);
            addProduct3(B[b][0], B[a][1], B[i][2], -1, result);
        }
    }

    double transposed[20][10];  //!< coefficients of the constraints, a row for each monomial
    double B[3][3][5];          //!< B(z) (x, y, 1)^T = 0
};

//! With smaller pivots the elimination loses solutions, and another basis is used. In a scene with
//! parallax this happens for less than one sample in a hundred.
constexpr double SMALL_PIVOT = 5e-4;

/** @brief Up to ten essential matrices from five points of calibrated cameras
@cite nister2004efficient.

The epipolar constraints leave E = x X + y Y + z Z + W. Ten cubic constraints are reduced to a 3x3
matrix of polynomials in z whose determinant, of degree 10, vanishes; its real roots give z, its
null vectors x and y. Roots that violate the constraints even after a correction are rejected. */
class Essential5Solver : public MinimalSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 5; }

    int solve(const Correspondences& p, const int* sample, Model* models) const CV_OVERRIDE
    {
        EssentialBasis basis;
        System system;
        if (!span(p, sample, basis))
            return 0;
        mix(basis);
        double length = 1;
        if (system.build(basis) < SMALL_PIVOT)
        {
            length = align(p, sample, basis);
            if (!(system.build(basis) > 0))
                return 0;
        }
        double determinant[11], roots[MAX_DEGREE];
        system.determinant(determinant);
        const int count = realRoots(determinant, 10, roots);
        int found = 0;
        for (int r = 0; r < count; ++r)
        {
            double x, y, z = roots[r], squares = 0;
            if (!backSubstitute(system.B, z, x, y))
                continue;
            const double left = correct(system.transposed, length, x, y, z);
            Matx33d E;
            for (int i = 0; i < 9; ++i)
            {
                E.val[i] = x * basis[0][i] + y * basis[1][i] + z * basis[2][i] + basis[3][i];
                squares += E.val[i] * E.val[i];
            }
            if (left < VIOLATED * squares * std::sqrt(squares) &&
                squares <= DBL_MAX)  // false for NaN
                models[found++] = E * (1 / std::sqrt(squares));
        }
        return found;
    }

private:
    //! Any basis of the null space of the epipolar constraints.
    static bool span(const Correspondences& p, const int* sample, EssentialBasis& basis)
    {
        double A[9][6] = {{0}};
        for (int i = 0; i < 5; ++i)
        {
            const double x1 = p.exact[X1][sample[i]], y1 = p.exact[Y1][sample[i]],
                         x2 = p.exact[X2][sample[i]], y2 = p.exact[Y2][sample[i]];
            const double row[9] = {x2 * x1, x2 * y1, x2, y2 * x1, y2 * y1, y2, x1, y1, 1};
            for (int k = 0; k < 9; ++k)
                A[k][i] = row[k];
        }
        return nullSpace<5>(A, basis);
    }
};

}  // namespace

Ptr<MinimalSolver> createEssential5Solver() { return makePtr<Essential5Solver>(); }

}  // namespace usacv20
}  // namespace cv
