// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

/* The polynomials of the five-point solver, for several samples at once, each in one lane of the
vector registers (see pack.inl.hpp). No include guard: lanes/lane_kernels.inl.hpp includes this file
once for each instruction set. */

namespace cv {
namespace usacv20 {
namespace {

/* Polynomials in x, y, z as arrays of coefficients of these monomials, where x2 is x^2 and so on.
Linear[4]:     x y z 1
Quadratic[10]: x2 xy xz x y2 yz y z2 z 1
Cubic[20]:     x3 y3 x2y xy2 x2z x2 y2z y2 xyz xy | xz2 xz x yz2 yz y z3 z2 z 1, in the order of
@cite nister2004efficient. eliminate() eliminates the ten monomials to the left of the bar. */

//! Sets a coefficient to the value if FIRST, else adds the value to it.
template <bool FIRST>
inline void add(Pack& coefficient, const Pack& value)
{
    coefficient = FIRST ? value : coefficient + value;
}

//! q = a b if FIRST, else q += a b
template <bool FIRST>
inline void addProduct(const Pack* a, const Pack* b, Pack* q)
{
    add<FIRST>(q[0], a[0] * b[0]);
    add<FIRST>(q[1], a[0] * b[1] + a[1] * b[0]);
    add<FIRST>(q[2], a[0] * b[2] + a[2] * b[0]);
    add<FIRST>(q[3], a[0] * b[3] + a[3] * b[0]);
    add<FIRST>(q[4], a[1] * b[1]);
    add<FIRST>(q[5], a[1] * b[2] + a[2] * b[1]);
    add<FIRST>(q[6], a[1] * b[3] + a[3] * b[1]);
    add<FIRST>(q[7], a[2] * b[2]);
    add<FIRST>(q[8], a[2] * b[3] + a[3] * b[2]);
    add<FIRST>(q[9], a[3] * b[3]);
}

//! c = q a if FIRST, else c += q a; quadratic times linear
template <bool FIRST>
inline void addCubic(const Pack* q, const Pack* a, Pack* c)
{
    add<FIRST>(c[0], q[0] * a[0]);
    add<FIRST>(c[1], q[4] * a[1]);
    add<FIRST>(c[2], q[0] * a[1] + q[1] * a[0]);
    add<FIRST>(c[3], q[1] * a[1] + q[4] * a[0]);
    add<FIRST>(c[4], q[0] * a[2] + q[2] * a[0]);
    add<FIRST>(c[5], q[0] * a[3] + q[3] * a[0]);
    add<FIRST>(c[6], q[4] * a[2] + q[5] * a[1]);
    add<FIRST>(c[7], q[4] * a[3] + q[6] * a[1]);
    add<FIRST>(c[8], q[1] * a[2] + q[2] * a[1] + q[5] * a[0]);
    add<FIRST>(c[9], q[1] * a[3] + q[3] * a[1] + q[6] * a[0]);
    add<FIRST>(c[10], q[2] * a[2] + q[7] * a[0]);
    add<FIRST>(c[11], q[2] * a[3] + q[3] * a[2] + q[8] * a[0]);
    add<FIRST>(c[12], q[3] * a[3] + q[9] * a[0]);
    add<FIRST>(c[13], q[5] * a[2] + q[7] * a[1]);
    add<FIRST>(c[14], q[5] * a[3] + q[6] * a[2] + q[8] * a[1]);
    add<FIRST>(c[15], q[6] * a[3] + q[9] * a[1]);
    add<FIRST>(c[16], q[7] * a[2]);
    add<FIRST>(c[17], q[7] * a[3] + q[8] * a[2]);
    add<FIRST>(c[18], q[8] * a[3] + q[9] * a[2]);
    add<FIRST>(c[19], q[9] * a[3]);
}

template <int COUNT>
inline void clear(Pack (&polynomial)[COUNT])
{
    for (int n = 0; n < COUNT; ++n)
        polynomial[n] = Pack();
}

//! Four 3x3 matrices, row by row, as in EssentialBasis.
typedef Pack FiveBasis[4][9];

//! The coefficients of ten cubic polynomials.
typedef Pack TenCubics[10][20];

//! Computes the coefficients of the ten cubic constraints on E = x X + y Y + z Z + W:
//! E E^T E - trace(E E^T) E / 2 = 0 and det E = 0.
void constraints(const FiveBasis& basis, TenCubics& C)
{
    Pack E[9][4], S[3][3][10];  // S: E E^T - trace(E E^T) I / 2, symmetric
    for (int i = 0; i < 9; ++i)
        for (int k = 0; k < 4; ++k)
            E[i][k] = basis[k][i];
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
        {
            addProduct<true>(E[3 * i], E[3 * j], S[i][j]);
            addProduct<false>(E[3 * i + 1], E[3 * j + 1], S[i][j]);
            addProduct<false>(E[3 * i + 2], E[3 * j + 2], S[i][j]);
        }
    for (int n = 0; n < 10; ++n)
    {
        const Pack half = 0.5 * (S[0][0][n] + S[1][1][n] + S[2][2][n]);
        for (int i = 0; i < 3; ++i)
            S[i][i][n] -= half;
    }
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
        {
            addCubic<true>(S[0][i], E[j], C[3 * i + j]);
            addCubic<false>(i < 1 ? S[i][1] : S[1][i], E[3 + j], C[3 * i + j]);
            addCubic<false>(S[i][2], E[6 + j], C[3 * i + j]);
        }
    clear(C[9]);
    for (int k = 0; k < 3; ++k)  // determinant, expanded along the first row
    {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        Pack minor[10], negative[4];
        for (int n = 0; n < 4; ++n)
            negative[n] = -E[3 + b][n];
        addProduct<true>(E[3 + a], E[6 + b], minor);
        addProduct<false>(negative, E[6 + a], minor);
        addCubic<false>(minor, E[k], C[9]);
    }
}

//! A step of eliminate(), with column K. K is a template argument so that the loops have a constant
//! length, which makes them faster.
//! @param tiny pivots of at most this magnitude count as 0
//! @param least input and output: magnitude of the smallest pivot so far
//! @param regular input and output: lanes in which no pivot has counted as 0 so far
template <int K>
inline void eliminateColumn(TenCubics& C, const Pack& tiny, Pack& least, Mask& regular)
{
    Pack best = everywhere(K), most = absolute(C[K][K]);
    for (int i = K + 1; i < 10; ++i)
    {
        const Pack size = absolute(C[i][K]);
        // a sum, because g++ 12 with -O1 cannot compile a choice between constants here
        best += size > most ? everywhere(i) - best : Pack();
        most = largerOf(most, size);
    }
    least = smallerOf(least, most);
    regular &= most > tiny;  // a lane with NaN counts as singular
    for (int i = K + 1; i < 10; ++i)
        exchange(best == (double)i, K, C[K], C[i]);
    const Pack inverse = 1. / C[K][K];
    for (int j = K + 1; j < 20; ++j)
        C[K][j] *= inverse;
    for (int i = K < 4 ? K + 1 : 4; i < 10; ++i)
    {
        if (i == K)
            continue;
        const Pack factor = C[i][K];
        for (int j = K + 1; j < 20; ++j)
            C[i][j] -= factor * C[K][j];
    }
}

/** Gaussian elimination of the left 10x10 block with partial pivoting. Only the last six rows are
brought to reduced form, because the solver uses only these. @return the magnitude of the smallest
pivot divided by that of the largest coefficient of the block; 0 in lanes where a pivot counts as 0
*/
Pack eliminate(TenCubics& C)
{
    Pack largest = Pack(), least = everywhere(DBL_MAX);
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j)
            largest = largerOf(largest, absolute(C[i][j]));
    Mask regular = least == least;
    const Pack tiny = 1e-13 * largest;
    eliminateColumn<0>(C, tiny, least, regular);
    eliminateColumn<1>(C, tiny, least, regular);
    eliminateColumn<2>(C, tiny, least, regular);
    eliminateColumn<3>(C, tiny, least, regular);
    eliminateColumn<4>(C, tiny, least, regular);
    eliminateColumn<5>(C, tiny, least, regular);
    eliminateColumn<6>(C, tiny, least, regular);
    eliminateColumn<7>(C, tiny, least, regular);
    eliminateColumn<8>(C, tiny, least, regular);
    eliminateColumn<9>(C, tiny, least, regular);
    return regular ? least / largest : Pack();
}

//! A 3x3 matrix of polynomials in z, each given by its coefficients, the constant first. The
//! polynomials in the three columns have degree 3, 3 and 4.
typedef Pack ThreeRows[3][3][5];

/** Computes a row of the 3x3 matrix B(z), for which B(z) (x, y, 1)^T = 0. The row is the eliminated
polynomial that begins with a monomial with the factor z, minus z times the eliminated polynomial
that begins with the same monomial without this factor.
@param withZ, without the two polynomials, which begin for example with x^2 z and x^2 */
void linkRows(const Pack (&withZ)[20], const Pack (&without)[20], Pack (&B)[3][5])
{
    for (int k = 0; k < 2; ++k)
    {
        const Pack *e = withZ + 10 + 3 * k, *f = without + 10 + 3 * k;
        B[k][0] = e[2];
        B[k][1] = e[1] - f[2];
        B[k][2] = e[0] - f[1];
        B[k][3] = -f[0];
        B[k][4] = Pack();
    }
    const Pack *e = withZ + 16, *f = without + 16;
    B[2][0] = e[3];
    B[2][1] = e[2] - f[3];
    B[2][2] = e[1] - f[2];
    B[2][3] = e[0] - f[1];
    B[2][4] = -f[0];
}

//! Determinant of B(z), expanded along its third column.
void determinantOf(const ThreeRows& B, Pack (&result)[DEGREE + 1])
{
    clear(result);
    for (int row = 0; row < 3; ++row)
    {
        const Pack(*const a)[5] = B[(row + 1) % 3], (*const b)[5] = B[(row + 2) % 3];
        Pack minor[7];
        clear(minor);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                minor[i + j] += a[0][i] * b[1][j] - b[0][i] * a[1][j];
        for (int i = 0; i < 7; ++i)
            for (int j = 0; j < 5; ++j)
                result[i + j] += minor[i] * B[row][2][j];
    }
}

inline Pack horner(const Pack (&c)[5], const Pack& z)
{
    return (((c[4] * z + c[3]) * z + c[2]) * z + c[1]) * z + c[0];
}

//! Computes x and y from the null vector (x, y, 1) of B(z), which is the cross product of two rows
//! up to scale; of the three cross products, the one whose third entry has the largest magnitude is
//! used. @return the lanes in which the magnitudes of x and y are below 1e12
Mask backSubstitute(const ThreeRows& B, const Pack& z, Pack& x, Pack& y)
{
    Pack v[3][3], best = Pack(), p = Pack(), q = Pack(), w = everywhere(1);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            v[i][j] = horner(B[i][j], z);
    for (int i = 0; i < 3; ++i)
    {
        const Pack *a = v[i], *b = v[(i + 1) % 3];
        const Pack third = a[0] * b[1] - a[1] * b[0], size = absolute(third);
        const Mask larger = size > best;
        best = larger ? size : best;
        w = larger ? third : w;
        p = larger ? a[1] * b[2] - a[2] * b[1] : p;
        q = larger ? a[2] * b[0] - a[0] * b[2] : q;
    }
    x = p / w;
    y = q / w;
    return (best > 0.) & (absolute(x) < 1e12) & (absolute(y) < 1e12);
}

}  // namespace
}  // namespace usacv20
}  // namespace cv
