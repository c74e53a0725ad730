// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

/* The sums for the normal equations of the Gauss-Newton method, for the error of a formula, over a
chunk of points, in loops that compilers vectorize. Each sum consists of SUMS_LANES partial sums
(lanes), which the caller adds in a fixed order. No include guard: kernels.inl.hpp includes this
file once for each instruction set. */

namespace cv {
namespace usacv20 {
namespace {

//! Adds the sum of a[i] b[i] over a chunk to the lanes of a sum.
inline void addProducts(const double* USAC_RESTRICT a, const double* USAC_RESTRICT b,
                        double* USAC_RESTRICT lanes)
{
    double sum[SUMS_LANES];
    for (int k = 0; k < SUMS_LANES; ++k)
        sum[k] = lanes[k];
    for (int i = 0; i < SUMS_CHUNK; i += SUMS_LANES)
    {
        USAC_SIMD
        for (int k = 0; k < SUMS_LANES; ++k)
            sum[k] += a[i + k] * b[i + k];
    }
    for (int k = 0; k < SUMS_LANES; ++k)
        lanes[k] = sum[k];
}

//! The same for four sums: those of the products of the rows a[0] b[0], a[0] b[1], a[1] b[0] and
//! a[1] b[1]. Each value is read only once.
inline void addProducts(const double (*USAC_RESTRICT a)[SUMS_CHUNK],
                        const double (*USAC_RESTRICT b)[SUMS_CHUNK], double* USAC_RESTRICT lanes00,
                        double* USAC_RESTRICT lanes01, double* USAC_RESTRICT lanes10,
                        double* USAC_RESTRICT lanes11)
{
    double sum00[SUMS_LANES], sum01[SUMS_LANES], sum10[SUMS_LANES], sum11[SUMS_LANES];
    for (int k = 0; k < SUMS_LANES; ++k)
    {
        sum00[k] = lanes00[k];
        sum01[k] = lanes01[k];
        sum10[k] = lanes10[k];
        sum11[k] = lanes11[k];
    }
    for (int i = 0; i < SUMS_CHUNK; i += SUMS_LANES)
    {
        USAC_SIMD
        for (int k = 0; k < SUMS_LANES; ++k)
        {
            sum00[k] += a[0][i + k] * b[0][i + k];
            sum01[k] += a[0][i + k] * b[1][i + k];
            sum10[k] += a[1][i + k] * b[0][i + k];
            sum11[k] += a[1][i + k] * b[1][i + k];
        }
    }
    for (int k = 0; k < SUMS_LANES; ++k)
    {
        lanes00[k] = sum00[k];
        lanes01[k] = sum01[k];
        lanes10[k] = sum10[k];
        lanes11[k] = sum11[k];
    }
}

//! Receives the error of point i and its derivative from a formula (formula_residual.hpp). For each
//! component of the error, NUMBERS rows contain the derivatives, and the next row the error.
template <int NUMBERS>
struct ChunkRows
{
    double (*const rows)[SUMS_CHUNK];
    const int i;

    double& error(int component) { return rows[(NUMBERS + 1) * component + NUMBERS][i]; }
    double& derivative(int component, int number)
    {
        return rows[(NUMBERS + 1) * component + number][i];
    }
};

/** The sums of any formula. For each component of the error, the NUMBERS derivatives are followed
by the error. The products of any two of these NUMBERS + 1 numbers form a symmetric matrix; its
lower triangle is summed, row by row. The last row of the triangle is the gradient and the cost. */
template <class Error>
struct GeneralSums
{
    enum { ROWS = Error::NUMBERS + 1, COUNT = ROWS * (ROWS + 1) / 2 };

    template <int... K>
    static inline void add(const double (*chunk)[SUMS_CHUNK], const double* m,
                           double (*sums)[SUMS_LANES], Indices<K...>)
    {
        double J[int(Error::COMPONENTS) * ROWS][SUMS_CHUNK];
        USAC_SIMD
        for (int i = 0; i < SUMS_CHUNK; ++i)
            linearize(J, i, m, chunk[K][i]...);
        for (int component = 0; component < Error::COMPONENTS; ++component)
            addTriangle(J + component * ROWS, chunk[Error::COLUMNS], sums);
    }

    //! A separate function, because compilers do not vectorize a loop in which objects are created.
    template <typename... Numbers>
    static CV_ALWAYS_INLINE void linearize(double (*J)[SUMS_CHUNK], int i, const double* m,
                                           Numbers... datum)
    {
        ChunkRows<Error::NUMBERS> rows = {J, i};
        typename Error::template At<double>(m, datum...).linearize(rows);
    }

    static inline void addTriangle(const double (*J)[SUMS_CHUNK], const double* weight,
                                   double (*sums)[SUMS_LANES])
    {
        double weighted[ROWS][SUMS_CHUNK];
        for (int row = 0; row < ROWS; ++row)
        {
            USAC_SIMD
            for (int i = 0; i < SUMS_CHUNK; ++i)
                weighted[row][i] = weight[i] * J[row][i];
        }
        int row = 0;
        for (; row + 1 < ROWS; row += 2)
        {
            double(*const first)[SUMS_LANES] = sums + row * (row + 1) / 2,
                          (*const second)[SUMS_LANES] = first + row + 1;
            for (int col = 0; col < row; col += 2)
                addProducts(weighted + row, J + col, first[col], first[col + 1], second[col],
                            second[col + 1]);
            addProducts(weighted[row], J[row], first[row]);
            addProducts(weighted[row + 1], J[row], second[row]);
            addProducts(weighted[row + 1], J[row + 1], second[row + 1]);
        }
        // the last row, if the number of rows is odd
        for (int col = 0; row < ROWS && col <= row; ++col)
            addProducts(weighted[row], J[col], sums[row * (row + 1) / 2 + col]);
    }

    static void toEquations(const double* total, double* JtJ, double* Jtr, double& cost)
    {
        enum { N = Error::NUMBERS };
        for (int row = 0, n = 0; row < N; ++row)
            for (int col = 0; col <= row; ++col)
                JtJ[N * row + col] = JtJ[N * col + row] = total[n++];
        for (int i = 0; i < N; ++i)
            Jtr[i] = total[N * (N + 1) / 2 + i];
        cost = total[COUNT - 1];
    }
};

/** The sums for the error of a projection (u, v) with a matrix of three rows. The derivatives of u
and v with respect to these rows are p / d times (1, 0, -u) and (0, 1, -v), where p is the
homogeneous point and d its depth, so that all blocks of J^T J are multiples of p p^T / d^2. There
are COUNT sums: the upper triangle of p p^T / d^2 times 1, u, v and u^2 + v^2, then the gradient,
then the cost. They take a third of the time of GeneralSums. `Error::At` has the members p(0) ..
p(POINT - 1), w (1 / d, or 0 for a point that contributes only to the cost), u, v, the error
(du, dv) and cost(). */
template <class Error>
struct ProjectionSums
{
    enum {
        POINT = Error::NUMBERS / 3,
        PRODUCTS = POINT * (POINT + 1) / 2,
        COUNT = 4 * PRODUCTS + Error::NUMBERS + 1
    };

    template <int... K>
    static inline void add(const double (*chunk)[SUMS_CHUNK], const double* m,
                           double (*sums)[SUMS_LANES], Indices<K...>)
    {
        CV_StaticAssert(PRODUCTS % 2 == 0, "products are summed in pairs");
        const double* weight = chunk[Error::COLUMNS];
        double pp[PRODUCTS][SUMS_CHUNK], factor[4][SUMS_CHUNK], p[POINT][SUMS_CHUNK],
            g[3][SUMS_CHUNK], cost[SUMS_CHUNK];
        USAC_SIMD
        for (int i = 0; i < SUMS_CHUNK; ++i)
            cost[i] = project(pp, factor, p, g, i, weight[i], m, chunk[K][i]...);
        for (int f = 0; f < 4; f += 2)
            for (int j = 0; j < PRODUCTS; j += 2)
            {
                double(*const first)[SUMS_LANES] = sums + PRODUCTS * f + j,
                              (*const second)[SUMS_LANES] = first + PRODUCTS;
                addProducts(factor + f, pp + j, first[0], first[1], second[0], second[1]);
            }
        for (int row = 0; row < 3; ++row)
            for (int j = 0; j < POINT; ++j)
                addProducts(g[row], p[j], sums[4 * PRODUCTS + POINT * row + j]);
        addProducts(cost, p[POINT - 1], sums[COUNT - 1]);  // the last homogeneous coordinate is 1
    }

    //! Row and column of the n-th entry of the upper triangle. With these functions, project()
    //! needs no nested loops, which compilers would not vectorize.
    static inline int rowOf(int n)
    {
        return n < POINT ? 0 : n < 2 * POINT - 1 ? 1 : n < 3 * POINT - 3 ? 2 : 3;
    }
    static inline int columnOf(int n)
    {
        const int row = rowOf(n);
        return n - row * POINT + row * (row + 1) / 2;
    }

    //! Writes, for point i, the factors whose products are summed. @return the weighted squared
    //! error of the point
    template <typename... Numbers>
    static inline double project(double (*USAC_RESTRICT pp)[SUMS_CHUNK],
                                 double (*USAC_RESTRICT factor)[SUMS_CHUNK],
                                 double (*USAC_RESTRICT p)[SUMS_CHUNK],
                                 double (*USAC_RESTRICT g)[SUMS_CHUNK], int i, double weight,
                                 const double* m, Numbers... datum)
    {
        const typename Error::template At<double> at(m, datum...);
        const double ww = weight * at.w * at.w;
        for (int n = 0; n < PRODUCTS; ++n)
            pp[n][i] = ww * at.p(rowOf(n)) * at.p(columnOf(n));
        factor[0][i] = 1;
        factor[1][i] = at.u;
        factor[2][i] = at.v;
        factor[3][i] = at.u * at.u + at.v * at.v;
        for (int a = 0; a < POINT; ++a)
            p[a][i] = at.p(a);
        const double gu = weight * at.w * at.du, gv = weight * at.w * at.dv;
        g[0][i] = gu;
        g[1][i] = gv;
        g[2][i] = -(at.u * gu + at.v * gv);
        return weight * at.cost();
    }

    static void toEquations(const double* total, double* JtJ, double* Jtr, double& cost)
    {
        enum { N = Error::NUMBERS };
        const double *plain = total, *u = plain + PRODUCTS, *v = u + PRODUCTS, *both = v + PRODUCTS;
        for (int i = 0; i < N * N; ++i)
            JtJ[i] = 0;
        for (int i = 0; i < POINT; ++i)
            for (int j = 0; j < POINT; ++j)
            {
                const int low = i < j ? i : j, high = i < j ? j : i;
                const int n = low * POINT - low * (low - 1) / 2 + high - low;
                const int row0 = i, row1 = POINT + i, row2 = 2 * POINT + i;
                const int col0 = j, col1 = POINT + j, col2 = 2 * POINT + j;
                JtJ[N * row0 + col0] = JtJ[N * row1 + col1] = plain[n];
                JtJ[N * row2 + col0] = JtJ[N * col0 + row2] = -u[n];
                JtJ[N * row2 + col1] = JtJ[N * col1 + row2] = -v[n];
                JtJ[N * row2 + col2] = both[n];
            }
        for (int i = 0; i < N; ++i)
            Jtr[i] = total[4 * PRODUCTS + i];
        cost = total[COUNT - 1];
    }
};

//! Selects ProjectionSums or GeneralSums for a formula.
template <class Error>
struct SumsOf
{
    typedef typename std::conditional<Error::PROJECTION, ProjectionSums<Error>,
                                      GeneralSums<Error>>::type Type;
};

template <class Error>
void sumsKernel(const double (*chunk)[SUMS_CHUNK], const double* m, double (*sums)[SUMS_LANES])
{
    SumsOf<Error>::Type::add(chunk, m, sums, typename IndicesTo<Error::COLUMNS>::Type());
}

template <class Error, int... K>
inline void leveragesOf(const double (*chunk)[SUMS_CHUNK], const double* m, const double* L,
                        double* USAC_RESTRICT leverages, Indices<K...>)
{
    typedef GeneralSums<Error> Rows;
    double J[int(Error::COMPONENTS) * Rows::ROWS][SUMS_CHUNK];
    USAC_SIMD
    for (int i = 0; i < SUMS_CHUNK; ++i)
        Rows::linearize(J, i, m, chunk[K][i]...);
    for (int i = 0; i < SUMS_CHUNK; ++i)
        leverages[i] = 0;
    for (int component = 0; component < Error::COMPONENTS; ++component)
        for (int row = 0; row < Error::NUMBERS; ++row)
        {
            double sum[SUMS_CHUNK] = {0};
            for (int col = 0; col <= row; ++col)
            {
                const double factor = L[row * Error::NUMBERS + col];
                const double* const derivative = J[component * Rows::ROWS + col];
                USAC_SIMD
                for (int i = 0; i < SUMS_CHUNK; ++i)
                    sum[i] += factor * derivative[i];
            }
            USAC_SIMD
            for (int i = 0; i < SUMS_CHUNK; ++i)
                leverages[i] += sum[i] * sum[i];
        }
    for (int i = 0; i < SUMS_CHUNK; ++i)
        leverages[i] *= chunk[Error::COLUMNS][i];
}

//! See LeverageKernel.
template <class Error>
void leverageKernel(const double (*chunk)[SUMS_CHUNK], const double* m, const double* L,
                    double* leverages)
{
    leveragesOf<Error>(chunk, m, L, leverages, typename IndicesTo<Error::COLUMNS>::Type());
}

template <class Error, typename... Numbers>
inline double costAt(const double* m, Numbers... datum)
{
    return typename Error::template At<double>(m, datum...).cost();
}

template <class Error, int... K>
inline void addCosts(const double (*chunk)[SUMS_CHUNK], const double* m, double (*sums)[SUMS_LANES],
                     Indices<K...>)
{
    double cost[SUMS_CHUNK];
    USAC_SIMD
    for (int i = 0; i < SUMS_CHUNK; ++i)
        cost[i] = costAt<Error>(m, chunk[K][i]...);
    addProducts(cost, chunk[Error::COLUMNS], sums[0]);
}

//! Adds the weighted squared errors to the first sum; there are no other sums.
template <class Error>
void costKernel(const double (*chunk)[SUMS_CHUNK], const double* m, double (*sums)[SUMS_LANES])
{
    addCosts<Error>(chunk, m, sums, typename IndicesTo<Error::COLUMNS>::Type());
}

}  // namespace
}  // namespace usacv20
}  // namespace cv
