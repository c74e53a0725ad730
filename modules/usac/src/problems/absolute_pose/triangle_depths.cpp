// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/absolute_pose/triangle_depths.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** A conic, stored as the upper triangle of its symmetric matrix: entries 00 01 02 11 12 22. */
struct Conic
{
    double m[6];
};

//! AT[i][j] is the index of the entry (i, j) of the symmetric matrix in Conic::m.
constexpr int AT[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

Conic sum(const Conic& a, double factor, const Conic& b)
{
    Conic result;
    for (int i = 0; i < 6; ++i)
        result.m[i] = a.m[i] + factor * b.m[i];
    return result;
}

Conic adjugate(const Conic& c)
{
    const double* m = c.m;
    return {{m[3] * m[5] - m[4] * m[4], m[2] * m[4] - m[1] * m[5], m[1] * m[4] - m[2] * m[3],
             m[0] * m[5] - m[2] * m[2], m[1] * m[2] - m[0] * m[4], m[0] * m[3] - m[1] * m[1]}};
}

//! Trace of the product of two symmetric matrices.
double trace(const Conic& a, const Conic& b)
{
    return a.m[0] * b.m[0] + a.m[3] * b.m[3] + a.m[5] * b.m[5] +
           2 * (a.m[1] * b.m[1] + a.m[2] * b.m[2] + a.m[4] * b.m[4]);
}

/** The pencil E + x F of two conics, with det(E + x F) = c0 + c1 x + c2 x^2 + c3 x^3. E and F are
chosen from the pencil of the given conics so that c3 is not small and no root is near infinity. */
struct Pencil
{
    Pencil(const Conic& first, const Conic& second) : E(first), F(second)
    {
        expand();
        if (std::max(std::abs(c[0]), std::abs(c[3])) <
            0.1 * std::max(std::abs(c[1]), std::abs(c[2])))
        {
            E = sum(first, -1, second);
            F = sum(first, 1, second);
            expand();
        }
        if (std::abs(c[0]) > std::abs(c[3]))
        {
            std::swap(E, F);
            std::swap(c[0], c[3]);
            std::swap(c[1], c[2]);
        }
    }

    void expand()
    {
        const Conic e = adjugate(E), f = adjugate(F);
        c[0] = trace(e, E) / 3;
        c[1] = trace(e, F);
        c[2] = trace(f, E);
        c[3] = trace(f, F) / 3;
    }

    Conic E, F;
    double c[4];
};

/** The real root of c0 + c1 x + c2 x^2 + c3 x^3 that lies alone on its side of the point of
inflection: of three roots, this is the one that is farthest from the others and thus best
conditioned. */
double loneRoot(const double* c)
{
    const double inverse = 1 / c[3], shift = c[2] * inverse / 3;
    const double a = c[1] * inverse, b = c[0] * inverse;
    // x = y - shift: y^3 + 3 p y + 2 q = 0
    const double p = a / 3 - shift * shift, q = shift * shift * shift + 0.5 * (b - a * shift);
    const double excess = q * q + p * p * p;
    double y;
    if (excess > 0)  // there is one real root: Cardano's formula
    {
        const double A = std::cbrt(std::abs(q) + std::sqrt(excess));
        y = A - p / A;
    }
    else  // |y| is from sqrt(-3 p) to 2 sqrt(-p); from above, Newton's method does not overshoot
        y = 2 * std::sqrt(-p);
    double x = (q > 0 ? -y : y) - shift;
    for (int i = 0; i < 8; ++i)
    {
        const double slope = 3 * (x + 2 * shift) * x + a, value = ((x + 3 * shift) * x + a) * x + b;
        const double step = value / slope;
        if (!(std::abs(step) <= 1e300))  // the slope is 0: a triple root
            break;
        x -= step;
        if (std::abs(step) <= 1e-9 * std::abs(x))  // the remaining relative error is about 1e-18
            break;
    }
    return x;
}

//! A pair of lines: the intersection of the lines, and another point of each line.
struct LinePair
{
    double common[3], other[2][3];
};

/** The lines of a degenerate conic. The adjugate of its matrix is -p p^T, where p is the
intersection of the lines. If p_i is the entry of p of largest magnitude, the other point of each
line is the intersection of this line with the line x_i = 0. These two points are the roots of a
quadratic equation.
@return false if the lines are not real or not distinct */
bool split(const Conic& D, LinePair& lines)
{
    const Conic A = adjugate(D);
    int i = A.m[3] < A.m[0] ? 1 : 0;
    if (A.m[5] < A.m[AT[i][i]])
        i = 2;
    const double least = A.m[AT[i][i]];
    if (!(least < 0))
        return false;
    const int j = i == 0 ? 1 : 0, k = i == 2 ? 1 : 2;
    // the quadratic equation of the points on the line x_i = 0: a x^2 + 2 b x y + c y^2 = 0
    const double a = D.m[AT[j][j]], b = D.m[AT[j][k]], c = D.m[AT[k][k]], root = std::sqrt(-least);
    const double t = b > 0 ? -b - root : root - b, inverse = 1 / least;
    const double first = 1 / std::max(std::abs(t), std::abs(a)),
                 second = 1 / std::max(std::abs(t), std::abs(c));
    lines.other[0][j] = t * first;
    lines.other[0][k] = a * first;
    lines.other[1][j] = c * second;
    lines.other[1][k] = t * second;
    lines.other[0][i] = lines.other[1][i] = 0;
    for (int n = 0; n < 3; ++n)
        lines.common[n] = A.m[AT[i][n]] * inverse;
    return true;
}

/** A negative radicand counts as 0 if its magnitude is at most this fraction of the largest squared
coefficient, because rounding might have made two equal solutions complex. If there really is no
solution, the solution returned violates the equations by no more than this fraction. */
constexpr double TORN = 1e-12;

//! Computes the real intersections of the lines with a conic, in homogeneous coordinates. @return
//! number of intersections
int meet(const LinePair& lines, const Conic& C, double (&points)[4][3])
{
    const double *p = lines.common, *m = C.m;
    const double polar[3] = {m[0] * p[0] + m[1] * p[1] + m[2] * p[2],
                             m[1] * p[0] + m[3] * p[1] + m[4] * p[2],
                             m[2] * p[0] + m[4] * p[1] + m[5] * p[2]};
    const double c = p[0] * polar[0] + p[1] * polar[1] + p[2] * polar[2];
    int count = 0;
    for (const double(&q)[3] : lines.other)
    {
        // the point x q + y p lies on the conic if a x^2 + 2 b x y + c y^2 = 0
        const double a = q[0] * (m[0] * q[0] + 2 * (m[1] * q[1] + m[2] * q[2])) +
                         q[1] * (m[3] * q[1] + 2 * m[4] * q[2]) + q[2] * q[2] * m[5];
        const double b = q[0] * polar[0] + q[1] * polar[1] + q[2] * polar[2];
        const double radicand = b * b - a * c,
                     largest = std::max(std::max(std::abs(a), std::abs(b)), std::abs(c));
        if (!(radicand >= -TORN * largest * largest))
            continue;
        const double root = std::sqrt(std::max(radicand, 0.)), t = b > 0 ? -b - root : root - b;
        for (int n = 0; n < 3; ++n)
        {
            points[count][n] = t * q[n] + a * p[n];
            points[count + 1][n] = c * q[n] + t * p[n];
        }
        count += 2;
    }
    return count;
}

//! Computes the position of the triangle with the given ratio p : q : w, side 23 of length 1 and
//! w > 0. False if this position is not finite or a corner is not in front of the camera.
bool scale(const Triangle& T, const double (&ratio)[3], TriangleDepths& d)
{
    const double p = ratio[0], q = ratio[1], w = ratio[2], w2 = w + T.sigma * p,
                 w3 = w + T.sigma * q;
    const double squared = (p - q) * (p - q) + T.s23 * w2 * w3;
    if (!(squared > 0 && squared <= DBL_MAX))
        return false;
    const double factor = (w < 0 ? -1 : 1) / std::sqrt(squared);
    d.p = p * factor;
    d.q = q * factor;
    d.w = w * factor;
    return d.w > 0 && w2 * factor > 0 && w3 * factor > 0;
}

//! Two solutions with at most this relative difference count as one solution: rounding splits a
//! double solution by about the square root of the machine precision.
constexpr double SAME = 1e-7;

bool same(const TriangleDepths& a, const TriangleDepths& b)
{
    return std::abs(a.p - b.p) + std::abs(a.q - b.q) + std::abs(a.w - b.w) <=
           SAME * (std::abs(a.p) + std::abs(a.q) + std::abs(a.w));
}

}  // namespace

int solveTriangle(const Triangle& T, TriangleDepths* depths)
{
    // The third equation of TriangleDepths is multiplied by a12 and subtracted from the first one,
    // and multiplied by a13 and subtracted from the second one. This leaves two homogeneous
    // quadratic equations in p, q and w.
    const double pq = 1 - 0.5 * T.sigma * T.sigma * T.s23, half = 0.5 * T.sigma;
    const double w12 = T.s12 - T.a12 * T.s23, w13 = T.s13 - T.a13 * T.s23;
    const Conic first = {{1 - T.a12, T.a12 * pq, half * w12, -T.a12, -half * T.a12 * T.s23, w12}};
    const Conic second = {{-T.a13, T.a13 * pq, -half * T.a13 * T.s23, 1 - T.a13, half * w13, w13}};
    const Pencil pencil(first, second);
    LinePair lines;
    if (!split(sum(pencil.E, loneRoot(pencil.c), pencil.F), lines))
        return 0;
    double points[MAX_TRIANGLE_DEPTHS][3];
    const int met = meet(lines, pencil.F, points);
    int count = 0;
    for (int n = 0; n < met; ++n)
    {
        TriangleDepths& d = depths[count];
        if (!scale(T, points[n], d))
            continue;
        int other = 0;
        while (other < count && !same(depths[other], d))
            ++other;
        count += other == count;
    }
    return count;
}

}  // namespace usacv20
}  // namespace cv
