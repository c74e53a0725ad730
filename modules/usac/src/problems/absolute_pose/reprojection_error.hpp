// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_REPROJECTION_ERROR_HPP
#define OPENCV_USACV20_REPROJECTION_ERROR_HPP

#include <cmath>

namespace cv {
namespace usacv20 {

// The contract of a formula is in residual/formula_residual.hpp.
namespace {

/** Squared error, for fits, of a point that is not in front of the camera: larger than any sum of
squared errors of points in front of it. */
constexpr double BEHIND = 1e200;

/** Reprojection error p(P X) - x for a point X of space and the 3x4 matrix P of a camera, where p
is the perspective division @cite hartley2003multiple. The squared error is infinite for a point
that is not in front of the camera. */
struct ReprojectionError
{
    enum { COLUMNS = 5, NUMBERS = 12, COMPONENTS = 2, HOMOGENEOUS = 1, PROJECTION = 1 };

    //! 1 / depth. In double precision, as used by fits, the result is 0 if the depth is not
    //! positive, so that the derivatives for a point behind the camera are 0.
    static inline float inverse(float depth) { return 1.f / depth; }
    static inline double inverse(double depth) { return depth > 0 ? 1 / depth : 0; }

    template <class T>
    struct At
    {
        At(const T* m, T X_, T Y_, T Z_, T x, T y)
            : X(X_), Y(Y_), Z(Z_), depth(m[8] * X + m[9] * Y + m[10] * Z + m[11]),
              w(inverse(depth)), u((m[0] * X + m[1] * Y + m[2] * Z + m[3]) * w),
              v((m[4] * X + m[5] * Y + m[6] * Z + m[7]) * w), du(u - x), dv(v - y)
        {}

        T squared() const
        {
            const T square = du * du + dv * dv;
            return depth > T(0) ? square : T(INFINITY);  // also INFINITY if the depth is NaN
        }
        T cost() const { return depth > T(0) ? du * du + dv * dv : T(BEHIND); }
        //! Homogeneous coordinate `k` of the point of space.
        T p(int k) const { return k == 0 ? X : k == 1 ? Y : k == 2 ? Z : T(1); }

        template <class Out>
        void linearize(Out& out) const
        {
            const double unseen = 1e100;  // its square is BEHIND
            out.error(0) = depth > 0 ? du : unseen;
            out.error(1) = depth > 0 ? dv : unseen;
            for (int k = 0; k < 4; ++k)
            {
                const T wp = w * p(k);
                out.derivative(0, k) = out.derivative(1, 4 + k) = wp;
                out.derivative(1, k) = out.derivative(0, 4 + k) = 0;
                out.derivative(0, 8 + k) = -u * wp;
                out.derivative(1, 8 + k) = -v * wp;
            }
        }

        const T X, Y, Z, depth, w, u, v, du, dv;
    };
};

//! The inverse of the root L = [p 0; q s] of a covariance L L^T.
template <class T>
struct InverseRoot
{
    InverseRoot(T p, T q_, T s) : scale(T(1) / p), q(q_), rest(T(1) / s) {}

    //! The components of L^-1 (x, y)^T. @param whitened the first component, first(x)
    T first(T x) const { return x * scale; }
    T second(T whitened, T y) const { return (y - q * whitened) * rest; }

    const T scale, q, rest;
};

/** Reprojection error for an image point with the covariance L L^T, L = [p 0; q s], in units of its
standard deviation: L^-1 times the error of ReprojectionError. */
struct WhitenedReprojectionError
{
    enum { COLUMNS = 8, NUMBERS = 12, COMPONENTS = 2, HOMOGENEOUS = 1, PROJECTION = 0 };

    template <class T>
    struct At
    {
        At(const T* m, T X, T Y, T Z, T x, T y, T p, T q, T s)
            : r(m, X, Y, Z, x, y), inverse(p, q, s), du(inverse.first(r.du)),
              dv(inverse.second(du, r.dv))
        {}

        T squared() const
        {
            const T square = du * du + dv * dv;
            return r.depth > T(0) ? square : T(INFINITY);
        }
        T cost() const { return r.depth > T(0) ? du * du + dv * dv : T(BEHIND); }

        template <class Out>
        void linearize(Out& out) const
        {
            const double unseen = 1e100;  // its square is BEHIND
            out.error(0) = r.depth > 0 ? du : unseen;
            out.error(1) = r.depth > 0 ? dv : unseen;
            for (int k = 0; k < 4; ++k)
            {
                const T wp = r.w * r.p(k);
                change(k, wp, 0, out);
                change(4 + k, 0, wp, out);
                change(8 + k, -r.u * wp, -r.v * wp, out);
            }
        }

        template <class Out>
        void change(int number, T x, T y, Out& out) const
        {
            const T first = inverse.first(x);
            out.derivative(0, number) = first;
            out.derivative(1, number) = inverse.second(first, y);
        }

        const ReprojectionError::At<T> r;
        const InverseRoot<T> inverse;
        const T du, dv;
    };
};

}  // namespace

}  // namespace usacv20
}  // namespace cv

#endif
