// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/polynomial.hpp"
#include "problems/distortion.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Indices of the coefficients.
enum { K1, K2, P1, P2, K3, K4, K5, K6, S1, S2, S3, S4, TAU_X, TAU_Y };

//! Maximum number of steps of Newton's method; an ordinary lens needs 3 to 6.
constexpr int STEPS = 50;
//! Number of bisections, which reduce an interval of radii to rounding error. It is also the
//! maximum number of times that the upper end of this interval is doubled before the bisections.
constexpr int HALVES = 60;
//! Newton's method ends when the distance between distort(p) and the given distorted point d is at
//! most EXACT (1 + |d|), which is about the rounding error.
constexpr double EXACT = 1e-14;

//! Homography of the projection onto a sensor that is tilted by the angles `x` and `y`, in radians,
//! about the axes of the same name; the center of the image stays in place.
Matx33d tiltOf(double x, double y)
{
    if (x == 0 && y == 0)
        return Matx33d::eye();
    const double cx = std::cos(x), sx = std::sin(x), cy = std::cos(y), sy = std::sin(y);
    const Matx33d aboutX(1, 0, 0, 0, cx, sx, 0, -sx, cx), aboutY(cy, 0, -sy, 0, 1, 0, sy, 0, cy);
    const Matx33d R = aboutY * aboutX;
    return Matx33d(R(2, 2), 0, -R(0, 2), 0, R(2, 2), -R(1, 2), 0, 0, 1) * R;
}

}  // namespace

Distortion::Distortion(const Mat& coefficients)
    : identity(true), straight(true), c(), limit(INFINITY)
{
    Mat doubles;  // a continuous copy: a column of a matrix is not continuous in memory
    coefficients.convertTo(doubles, CV_64F);
    for (int i = 0; i < (int)doubles.total(); ++i)
        c[i] = doubles.ptr<double>()[i];
    for (int i = 0; i < COEFFICIENTS; ++i)
        identity = identity && c[i] == 0;
    straight = c[TAU_X] == 0 && c[TAU_Y] == 0;
    tilt = tiltOf(c[TAU_X], c[TAU_Y]);
    limit = firstFold();
}

//! Computes the factor by which the radial terms scale the radius, and the derivative of this
//! factor with respect to the squared radius.
double Distortion::radial(double squared, double* derivative) const
{
    const double q = squared;
    const double above = 1 + q * (c[K1] + q * (c[K2] + q * c[K3]));
    const double below = 1 / (1 + q * (c[K4] + q * (c[K5] + q * c[K6])));
    if (derivative)
        *derivative = (c[K1] + q * (2 * c[K2] + q * 3 * c[K3]) -
                       above * below * (c[K4] + q * (2 * c[K5] + q * 3 * c[K6]))) *
                      below;
    return above * below;
}

//! The smallest q = r^2 > 0 at which the distorted radius r radial(r^2) stops growing or the
//! denominator D of radial = N / D is 0; INFINITY if there is none.
double Distortion::firstFold() const
{
    const double N[4] = {1, c[K1], c[K2], c[K3]}, D[4] = {1, c[K4], c[K5], c[K6]};
    double slope[7] = {0}, roots[7];  // slope: (N + 2 q N') D - 2 q N D', of degree 6 in q
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k)
            slope[i + k] += (1 + 2 * i - 2 * k) * N[i] * D[k];
    double least = INFINITY;
    const double* const polynomials[] = {slope, D};
    for (int which = 0; which < 2; ++which)
    {
        int degree = which ? 3 : 6;
        while (degree > 0 && polynomials[which][degree] == 0)
            --degree;
        const int count = realRoots(polynomials[which], degree, roots);
        for (int i = 0; i < count; ++i)
            if (roots[i] > 0)
                least = std::min(least, roots[i]);
    }
    return least;
}

bool Distortion::distort(const Vec2d& p, Vec2d& d, Matx22d* derivative) const
{
    const double x = p[0], y = p[1], q = x * x + y * y;
    if (!(q < limit))  // beyond the first fold, or NaN: the camera does not see such a point
        return false;
    double slope;
    const double factor = radial(q, &slope), mixed = 2 * x * y;
    const double a = x * factor + c[P1] * mixed + c[P2] * (q + 2 * x * x) + q * (c[S1] + q * c[S2]);
    const double b = y * factor + c[P1] * (q + 2 * y * y) + c[P2] * mixed + q * (c[S3] + q * c[S4]);
    const Vec3d seen = straight ? Vec3d(a, b, 1) : tilt * Vec3d(a, b, 1);
    const double inverse = 1 / seen[2];
    d = Vec2d(seen[0] * inverse, seen[1] * inverse);
    if (!(seen[2] > 0))
        return false;
    if (!derivative)
        return true;
    const double prismX = 2 * (c[S1] + 2 * q * c[S2]), prismY = 2 * (c[S3] + 2 * q * c[S4]);
    const Matx22d J(factor + 2 * x * x * slope + 2 * c[P1] * y + 6 * c[P2] * x + prismX * x,
                    mixed * slope + 2 * c[P1] * x + 2 * c[P2] * y + prismX * y,
                    mixed * slope + 2 * c[P1] * x + 2 * c[P2] * y + prismY * x,
                    factor + 2 * y * y * slope + 6 * c[P1] * y + 2 * c[P2] * x + prismY * y);
    *derivative = J;
    if (straight)
        return true;
    const Matx22d projected(
        (tilt(0, 0) - d[0] * tilt(2, 0)) * inverse, (tilt(0, 1) - d[0] * tilt(2, 1)) * inverse,
        (tilt(1, 0) - d[1] * tilt(2, 0)) * inverse, (tilt(1, 1) - d[1] * tilt(2, 1)) * inverse);
    *derivative = projected * J;
    return true;
}

//! Finds a starting point for Newton's method: inverts the radial terms alone by bisection, which
//! is possible because the radius that they give grows with the undistorted radius up to the first
//! fold. False if the radius found is 0.
bool Distortion::startOf(const Vec2d& d, Vec2d& p) const
{
    const double wanted = std::sqrt(d.dot(d));
    double low = 0, high = limit < INFINITY ? std::sqrt(limit) : wanted;
    for (int i = 0; i < HALVES && limit == INFINITY && high * radial(high * high) < wanted; ++i)
        high *= 2;
    for (int i = 0; i < HALVES; ++i)
    {
        const double middle = (low + high) / 2;
        (middle * radial(middle * middle) < wanted ? low : high) = middle;
    }
    p = d * (low / wanted);
    return low > 0;
}

//! Newton's method starts from the distorted point, which suffices for an ordinary lens. If the
//! method fails, it starts again from the solution of the radial terms alone.
bool Distortion::undistort(const Vec2d& d, Vec2d& p) const
{
    p = d;
    if (identity)
        return true;
    if (!(d.dot(d) <= DBL_MAX))
        return false;
    return descend(d, p) || (startOf(d, p) && descend(d, p));
}

void Distortion::undistort(double* x, double* y, int count) const
{
    for (int i = 0; !identity && i < count; ++i)
    {
        Vec2d p;
        if (!undistort(Vec2d(x[i], y[i]), p))
            p = Vec2d(NAN, NAN);
        x[i] = p[0];
        y[i] = p[1];
    }
}

//! Newton's method, starting from `p`. A step that crosses the first fold or does not decrease the
//! error is halved. False if distort() fails for the starting point, if the determinant of the
//! derivative is not positive, or if the remaining error exceeds 1000 times the tolerance (see
//! EXACT).
bool Distortion::descend(const Vec2d& d, Vec2d& p) const
{
    const double tolerance = EXACT * (1 + std::sqrt(d.dot(d)));
    Vec2d seen;
    Matx22d J;
    if (!distort(p, seen, &J))
        return false;
    double left = norm(seen - d);
    for (int i = 0; i < STEPS && left > tolerance; ++i)
    {
        const double determinant = J(0, 0) * J(1, 1) - J(0, 1) * J(1, 0);
        if (!(determinant > 0))
            return false;
        const Vec2d rest = seen - d;
        Vec2d step(-(J(1, 1) * rest[0] - J(0, 1) * rest[1]) / determinant,
                   -(J(0, 0) * rest[1] - J(1, 0) * rest[0]) / determinant);
        bool better = false;
        for (int half = 0; half < 10 && !better; ++half, step *= 0.5)
        {
            Vec2d there;
            Matx22d slope;
            if (!distort(p + step, there, &slope) || !(norm(there - d) < left))
                continue;
            p += step;
            seen = there;
            J = slope;
            left = norm(seen - d);
            better = true;
        }
        if (!better)
            break;
    }
    return left <= 1e3 * tolerance;
}

}  // namespace usacv20
}  // namespace cv
