// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

/* The seven-point solver @cite hartley2003multiple for several samples at once, each in one lane of
the vector registers (see pack.inl.hpp). The epipolar constraints are satisfied by all
F = s F1 + t F2; det F = 0 is a homogeneous cubic in (s, t). Repeated matches lower the rank of the
constraints, so that the sample is degenerate. If each match has its point in image 1 on a line l1
or its point in image 2 on a line l2, for example if five points of an image are collinear, one
solution is l2 l1^T, which has rank 1 and is not a fundamental matrix. No include guard:
lanes/lane_kernels.inl.hpp includes this file once for each instruction set. */

namespace cv {
namespace usacv20 {
namespace {

//! Real roots of cubic polynomials, one polynomial in each lane.
struct CubicRoots
{
    //! Computes `at` and `lanes`.
    //! @param c coefficients, the constant first
    //! @param wanted lanes to solve, a bit for each; the other lanes get no roots
    void find(const Pack (&c)[4], int wanted)
    {
        Pack largest = Pack();
        for (int i = 0; i < 4; ++i)
            largest = largerOf(largest, absolute(c[i]));
        const Pack a = c[2] / c[3], b = c[1] / c[3], d = c[0] / c[3];
        const Pack Q = (a * a - 3. * b) / 9., R = (2. * a * a * a - 9. * a * b + 27. * d) / 54.,
                   excess = R * R - Q * Q * Q;
        const Pack shift = a / 3.;
        const Pack first = R > 0. ? -outermost(Q, absolute(R), excess)
                                  : outermost(Q, absolute(R), excess);
        // with t = x + shift, the other two roots, if they are real, are those of
        // t^2 + first t + first^2 - 3 Q, the cubic divided by t - first
        const Pack half = 0.5 * squareRoot(largerOf(Pack(), 12. * Q - 3. * first * first));
        at[0] = polish(a, b, d, first - shift);
        at[1] = polish(a, b, d, -0.5 * first + half - shift);
        at[2] = polish(a, b, d, -0.5 * first - half - shift);
        // lanes whose cubic might have a root near infinity or a multiple root
        const int special = wanted & ~(bitsOf(absolute(c[3]) > 1e-3 * largest) &
                                       bitsOf(absolute(excess) > 1e-13 * R * R));
        lanes[0] = wanted & ~special;
        lanes[1] = lanes[2] = lanes[0] & bitsOf(excess < 0.);
        for (int k = 0; k < WIDTH; ++k)
            if (special >> k & 1)
                findOne(c, k);
    }

    Pack at[3];    //!< first, second and third root
    int lanes[3];  //!< for each root, the lanes in which it exists, a bit for each lane

private:
    /** The largest root of u^3 - 3 Q u - 2 W with W >= 0: an approximation with an error of less
    than 1 % is refined by two steps of Halley's method. If there are three real roots (excess
    W^2 - Q^3 < 0), the largest root grows nearly linearly with W, from sqrt(3 Q) to 2 sqrt(Q), and
    is approximated by this line; else Cardano's formula gives the approximation. */
    static Pack outermost(const Pack& Q, const Pack& W, const Pack& excess)
    {
        const double ROOT3 = 1.7320508075688772;
        const Mask three = excess < 0.;
        const Pack root = squareRoot(largerOf(Pack(), Q)),
                   cube = W + squareRoot(largerOf(Pack(), excess));
        Pack A = roughCubeRoot(cube);
        A = A * (A * A * A + 2. * cube) / (2. * A * A * A + cube);
        const Pack B = Q / A;
        Pack u = three ? ROOT3 * root + (2. - ROOT3) * W / Q : 2. * W / (A * A - Q + B * B);
        for (int i = 0; i < 2; ++i)
        {
            const Pack value = (u * u - 3. * Q) * u - 2. * W, slope = 3. * (u * u - Q);
            u = u - value * slope / (slope * slope - value * (3. * u));
        }
        return u;
    }

    //! Two Newton steps toward a root of x^3 + a x^2 + b x + d. In each lane, a step is taken only
    //! if it reduces the absolute value of the polynomial.
    static Pack polish(const Pack& a, const Pack& b, const Pack& d, Pack x)
    {
        Pack value = ((x + a) * x + b) * x + d;
        for (int i = 0; i < 2; ++i)
        {
            const Pack next = x - value / ((3. * x + 2. * a) * x + b),
                       there = ((next + a) * next + b) * next + d;
            const Mask better = absolute(there) < absolute(value);
            x = better ? next : x;
            value = better ? there : value;
        }
        return x;
    }

    //! Finds the roots in one lane with realRoots(), which is slower, but works for every cubic.
    void findOne(const Pack (&coefficients)[4], int k)
    {
        double c[4], roots[MAX_DEGREE];
        for (int i = 0; i < 4; ++i)
            c[i] = lane(coefficients[i], k);
        const int found = realRoots(c, 3, roots);
        for (int i = 0; i < found; ++i)
        {
            setLane(at[i], k, roots[i]);
            lanes[i] |= 1 << k;
        }
    }
};

//! Scales the matrix F of each lane in `wanted` to unit norm and appends it to the models of the
//! lane's sample, except where F has (nearly) rank 1 or is not finite.
void addFundamental(Pack (&F)[9], int wanted, double (*models)[MAX_MODELS][9], int* found)
{
    const Pack squares = dot9(F, F), inverse = 1. / squareRoot(squares);
    wanted &= bitsOf((squares > 0.) & (squares <= DBL_MAX));
    for (int i = 0; i < 9; ++i)
        F[i] *= inverse;
    Pack c[9];
    cofactors(F, c);  // as det F = 0, |c| is the product of the two nonzero singular values
    wanted &= bitsOf(dot9(c, c) > LEAST_RATIO * LEAST_RATIO);
    for (int k = 0; k < WIDTH; ++k)
        if (wanted >> k & 1)
        {
            double* const model = models[k][found[k]++];
            for (int i = 0; i < 9; ++i)
                model[i] = lane(F[i], k);
        }
}

//! Solves `count` samples, at most WIDTH.
void solveSeven(const Correspondences& points, const int* const* samples, int count,
                double (*models)[MAX_MODELS][9], int* found)
{
    Pack A[9][7], F[2][9], c1[9], c2[9];
    epipolarRows(points, samples, count, A);
    const int independent = bitsOf(nullSpace(A, F)) & ((1 << count) - 1);
    // det(s F1 + t F2) = s^3 det F1 + s^2 t <cof F1, F2> + s t^2 <F1, cof F2> + t^3 det F2
    cofactors(F[0], c1);
    cofactors(F[1], c2);
    Pack cubic[4] = {dot9(c2, F[1]) / 3., dot9(c2, F[0]), dot9(c1, F[1]), dot9(c1, F[0]) / 3.};
    // the unknown is s / t or t / s: the ratio whose cubic has the larger leading coefficient,
    // which avoids roots at infinity
    const Mask other = absolute(cubic[0]) > absolute(cubic[3]);
    exchange(other, 0, F[0], F[1]);
    const Pack turned[4] = {cubic[3], cubic[2], cubic[1], cubic[0]};
    for (int i = 0; i < 4; ++i)
        cubic[i] = other ? turned[i] : cubic[i];
    CubicRoots roots;
    roots.find(cubic, independent);
    for (int k = 0; k < count; ++k)
        found[k] = 0;
    for (int r = 0; r < 3; ++r)
    {
        Pack root[9];
        for (int i = 0; i < 9; ++i)
            root[i] = roots.at[r] * F[0][i] + F[1][i];
        addFundamental(root, roots.lanes[r], models, found);
    }
}

void sevenPointKernel(const Correspondences& points, const int* const* samples, int count,
                      double (*models)[MAX_MODELS][9], int* found)
{
    for (int i = 0; i < count; i += WIDTH)
        solveSeven(points, samples + i, count - i < WIDTH ? count - i : WIDTH, models + i,
                   found + i);
}

}  // namespace
}  // namespace usacv20
}  // namespace cv
