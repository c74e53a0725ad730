// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

/* The five-point solver @cite nister2004efficient for several samples at once, each in one lane of
the vector registers (see pack.inl.hpp). The epipolar constraints of five points are satisfied by
all E = x X + y Y + z Z + W (see EssentialBasis). Ten cubic constraints on E are reduced to a 3x3
matrix B(z) of polynomials with a determinant of degree 10. The real roots of the determinant are
the values of z; the null vectors of B(z) give x and y. Solutions that violate the constraints even
after a correction are rejected. No include guard: lanes/lane_kernels.inl.hpp includes this file
once for each instruction set. */

namespace cv {
namespace usacv20 {
namespace {

/** Scales the vectors of a basis to unit length and mixes them with a rotation. The basis from
nullSpace() has zeros at positions that depend on the motion; without mixing, x, y or z would be
infinite for rectified cameras and for a camera that moves forward or sideways. */
void mix(FiveBasis& basis)
{
    // The mapping v -> p v q with the quaternions p = 3 + 5i + 7j + 11k and q = 13 - 4i + 6j + 9k:
    // a four-dimensional rotation times |p| |q| = sqrt(61608). Any other rotation without small
    // entries would be suitable, too.
    static const double ROTATION[4][4] = {
        {-82, -56, -198, -112}, {50, 200, -118, 72}, {20, 114, 76, -206}, {228, -74, -52, -38}};
    for (int k = 0; k < 4; ++k)
    {
        const Pack inverse = 1. / squareRoot(61608. * dot9(basis[k], basis[k]));
        for (int i = 0; i < 9; ++i)
            basis[k][i] *= inverse;
    }
    for (int i = 0; i < 9; ++i)
    {
        const Pack v[4] = {basis[0][i], basis[1][i], basis[2][i], basis[3][i]};
        for (int k = 0; k < 4; ++k)
            basis[k][i] = ROTATION[k][0] * v[0] + ROTATION[k][1] * v[1] + ROTATION[k][2] * v[2] +
                          ROTATION[k][3] * v[3];
    }
}

//! Limits of the largest residual of the ten constraints for E of unit norm. Below EXACT, E needs
//! no correction; at VIOLATED or above, E is rejected.
constexpr double EXACT = 1e-12, VIOLATED = 1e-9;

//! A matrix E with the residuals of the ten constraints and the data for their derivatives. The
//! caller sets E; compute() sets the other members.
struct Violation
{
    void compute()
    {
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j)
                S[i][j] = dot3(E[3 * i], E[3 * j], E[3 * i + 1], E[3 * j + 1], E[3 * i + 2],
                               E[3 * j + 2]);
        const Pack half = 0.5 * (S[0][0] + S[1][1] + S[2][2]);
        squares = 2. * half;
        for (int i = 0; i < 3; ++i)
            S[i][i] -= half;
        S[1][0] = S[0][1];
        S[2][0] = S[0][2];
        S[2][1] = S[1][2];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                r[3 * i + j] = dot3(S[i][0], E[j], S[i][1], E[3 + j], S[i][2], E[6 + j]);
        cofactors(E, c);
        r[9] = dot3(c[0], E[0], c[1], E[1], c[2], E[2]);
        largest = Pack();
        for (int i = 0; i < 10; ++i)
            largest = largerOf(largest, absolute(r[i]));
    }

    //! The derivative of the residuals in the direction of a matrix D.
    void derive(const Pack (&D)[9], Pack (&g)[10]) const
    {
        Pack G[3][3], change[3][3];  // D E^T, and the derivative of S in the direction of D
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                G[i][j] = dot3(D[3 * i], E[3 * j], D[3 * i + 1], E[3 * j + 1], D[3 * i + 2],
                               E[3 * j + 2]);
        const Pack half = G[0][0] + G[1][1] + G[2][2];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                change[i][j] = i == j ? G[i][i] + G[i][i] - half : G[i][j] + G[j][i];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                g[3 * i + j] = dot3(change[i][0], E[j], change[i][1], E[3 + j], change[i][2],
                                    E[6 + j]) +
                               dot3(S[i][0], D[j], S[i][1], D[3 + j], S[i][2], D[6 + j]);
        g[9] = dot9(c, D);
    }

    //! True in lanes where the largest residual, for E scaled to unit norm, is at least `limit`.
    Mask exceeds(double limit) const { return largest >= limit * squares * squareRoot(squares); }

    Pack E[9], S[3][3];  //!< S: E E^T - trace(E E^T) I / 2
    Pack c[9], r[10];    //!< cofactors of E, residuals of the constraints
    Pack largest;        //!< the largest absolute residual
    Pack squares;        //!< the squared norm of E
};

//! Computes the Gauss-Newton step for the ten constraints, to be subtracted from x, y and z. It is
//! infinite or NaN in lanes where the matrix of the normal equations is singular.
void stepOf(const FiveBasis& basis, const Violation& at, Pack (&step)[3])
{
    Pack g[3][10], A[9], b[3], c[9];
    for (int k = 0; k < 3; ++k)
        at.derive(basis[k], g[k]);
    for (int i = 0; i < 3; ++i)
    {
        for (int j = i; j < 3; ++j)
        {
            Pack sum = g[i][0] * g[j][0];
            for (int n = 1; n < 10; ++n)
                sum += g[i][n] * g[j][n];
            A[3 * i + j] = A[3 * j + i] = sum;
        }
        b[i] = g[i][0] * at.r[0];
        for (int n = 1; n < 10; ++n)
            b[i] += g[i][n] * at.r[n];
    }
    cofactors(A, c);
    const Pack inverse = 1. / dot3(c[0], A[0], c[1], A[1], c[2], A[2]);
    for (int i = 0; i < 3; ++i)
        step[i] = inverse * dot3(c[3 * i], b[0], c[3 * i + 1], b[1], c[3 * i + 2], b[2]);
}

//! E = x X + y Y + z Z + W
inline void combine(const FiveBasis& basis, const Pack& x, const Pack& y, const Pack& z,
                    Pack (&E)[9])
{
    for (int i = 0; i < 9; ++i)
        E[i] = x * basis[0][i] + y * basis[1][i] + z * basis[2][i] + basis[3][i];
}

//! All solutions (x, y, z) that need a correction, of all samples. They are corrected together, one
//! in each lane. lanes[i] is the lane of the sample to which solution i belongs.
struct Inexact
{
    enum { MOST = MAX_MODELS * WIDTH };

    Inexact() : count(0) {}

    void add(int k, double ownX, double ownY, double ownZ)
    {
        lanes[count] = k;
        x[count] = ownX;
        y[count] = ownY;
        z[count++] = ownZ;
    }

    int count, lanes[MOST];
    double x[MOST], y[MOST], z[MOST];
};

/** Corrects solutions with the Gauss-Newton method for the ten constraints in x, y and z. This
restores the digits that the elimination loses if its pivots are small.
@param all X, Y, Z and W of each sample
@param solutions the solutions to correct
@param first the solutions first .. first + WIDTH - 1 are corrected, each in one lane; if there are
fewer solutions, the other lanes repeat the solution `first`
@param at output: the corrected matrices */
void correct(const FiveBasis& all, const Inexact& solutions, int first, Violation& at)
{
    enum { STEPS = 4 };
    double numbers[4][9][WIDTH], begin[3][WIDTH];
    for (int k = 0; k < WIDTH; ++k)
    {
        const int i = first + k < solutions.count ? first + k : first;
        for (int v = 0; v < 4; ++v)
            for (int n = 0; n < 9; ++n)
                numbers[v][n][k] = lane(all[v][n], solutions.lanes[i]);
        begin[0][k] = solutions.x[i];
        begin[1][k] = solutions.y[i];
        begin[2][k] = solutions.z[i];
    }
    FiveBasis basis;
    for (int v = 0; v < 4; ++v)
        for (int n = 0; n < 9; ++n)
            basis[v][n] = load(numbers[v][n]);
    Pack x = load(begin[0]), y = load(begin[1]), z = load(begin[2]);
    Mask active = x == x;
    for (int k = 0;; ++k)
    {
        combine(basis, x, y, z, at.E);
        at.compute();
        active &= at.exceeds(EXACT);
        if (k == STEPS || bitsOf(active) == 0)
            return;
        Pack step[3], change[9];
        stepOf(basis, at, step);
        for (int i = 0; i < 9; ++i)
            change[i] = dot3(step[0], basis[0][i], step[1], basis[1][i], step[2], basis[2][i]);
        active &= dot9(change, change) < 0.1 * at.squares;  // refuses a step that is large or NaN
        x = active ? x - step[0] : x;
        y = active ? y - step[1] : y;
        z = active ? z - step[2] : z;
    }
}

//! If the smallest pivot, relative to the largest coefficient (the result of eliminate()), is below
//! this number, solutions can be lost; the elimination is then repeated with a basis from align().
//! In a scene with parallax, this happens for less than one sample in a hundred.
constexpr double SMALL_PIVOT = 5e-4;

//! Solves up to WIDTH samples.
struct FivePoints
{
    FivePoints(const Correspondences& points_, const int* const* samples_, int count_)
        : points(points_), samples(samples_), count(count_)
    {}

    //! @param models, found see SolverKernel
    void solve(double (*models)[MAX_MODELS][9], int* found)
    {
        const int regular = build();
        Pack determinant[DEGREE + 1];
        Roots roots;
        determinantOf(B, determinant);
        roots.find(determinant, regular);
        for (int k = 0; k < count; ++k)
            found[k] = 0;
        Inexact inexact;
        for (int r = 0; r < MAX_MODELS; ++r)
        {
            int wanted = 0;
            for (int k = 0; k < count; ++k)
                wanted |= (r < roots.count[k]) << k;
            if (wanted == 0)
                break;
            addExact(roots.at[r], wanted, models, found, inexact);
        }
        for (int i = 0; i < inexact.count; i += WIDTH)
        {
            Violation at;
            correct(basis, inexact, i, at);
            const int left = inexact.count - i < WIDTH ? inexact.count - i : WIDTH;
            add(at, inexact.lanes + i, ((1 << left) - 1) & ~bitsOf(at.exceeds(VIOLATED)), models,
                found);
        }
    }

private:
    //! Computes the basis and B. @return the lanes in which the five epipolar constraints are
    //! independent and no pivot counts as 0, a bit for each lane
    int build()
    {
        Pack A[9][5];
        epipolarRows(points, samples, count, A);
        const int independent = bitsOf(nullSpace(A, basis)) & ((1 << count) - 1);
        mix(basis);
        Pack pivot = reduce();
        const int small = independent & ~bitsOf(pivot >= SMALL_PIVOT);
        for (int k = 0; k < count; ++k)
            if (small >> k & 1)
                alignLane(k);
        if (small != 0)
            pivot = reduce();
        return independent & bitsOf(pivot > 0.);
    }

    //! Computes B from the basis. @return the smallest pivot, see eliminate()
    Pack reduce()
    {
        TenCubics C;
        constraints(basis, C);
        const Pack pivot = eliminate(C);
        for (int k = 0; k < 3; ++k)
            linkRows(C[4 + 2 * k], C[5 + 2 * k], B[k]);
        return pivot;
    }

    void alignLane(int k)
    {
        EssentialBasis own;
        for (int v = 0; v < 4; ++v)
            for (int i = 0; i < 9; ++i)
                own[v][i] = lane(basis[v][i], k);
        align(points, samples[k], own);
        for (int v = 0; v < 4; ++v)
            for (int i = 0; i < 9; ++i)
                setLane(basis[v][i], k, own[v][i]);
    }

    //! Computes a solution from the root z of each lane in `wanted` and appends its matrix to the
    //! models. Solutions that need a correction are added to `inexact` instead.
    void addExact(const Pack& z, int wanted, double (*models)[MAX_MODELS][9], int* found,
                  Inexact& inexact) const
    {
        int lanes[WIDTH];
        Pack x, y;
        Violation at;
        wanted &= bitsOf(backSubstitute(B, z, x, y));
        combine(basis, x, y, z, at.E);
        at.compute();
        const int exact = wanted & ~bitsOf(at.exceeds(EXACT));
        for (int k = 0; k < WIDTH; ++k)
        {
            lanes[k] = k;
            if ((wanted & ~exact) >> k & 1)
                inexact.add(k, lane(x, k), lane(y, k), lane(z, k));
        }
        add(at, lanes, exact, models, found);
    }

    //! Scales the matrices in the lanes `wanted` to unit norm and appends them to the models. The
    //! matrix in lane k belongs to the sample with the index lanes[k].
    static void add(Violation& at, const int* lanes, int wanted, double (*models)[MAX_MODELS][9],
                    int* found)
    {
        const Pack inverse = 1. / squareRoot(at.squares);
        wanted &= bitsOf(at.squares <= DBL_MAX);  // drops NaN and infinity
        for (int i = 0; i < 9; ++i)
            at.E[i] *= inverse;
        for (int k = 0; k < WIDTH; ++k)
            if (wanted >> k & 1)
            {
                double* const model = models[lanes[k]][found[lanes[k]]++];
                for (int i = 0; i < 9; ++i)
                    model[i] = lane(at.E[i], k);
            }
    }

    const Correspondences& points;
    const int* const* const samples;
    const int count;
    FiveBasis basis;
    ThreeRows B;
};

void fivePointKernel(const Correspondences& points, const int* const* samples, int count,
                     double (*models)[MAX_MODELS][9], int* found)
{
    for (int i = 0; i < count; i += WIDTH)
    {
        FivePoints part(points, samples + i, count - i < WIDTH ? count - i : WIDTH);
        part.solve(models + i, found + i);
    }
}

}  // namespace
}  // namespace usacv20
}  // namespace cv
