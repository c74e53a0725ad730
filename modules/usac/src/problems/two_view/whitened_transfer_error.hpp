// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_WHITENED_TRANSFER_ERROR_HPP
#define OPENCV_USACV20_WHITENED_TRANSFER_ERROR_HPP

#include "problems/two_view/transfer_error.hpp"

namespace cv {
namespace usacv20 {

// residual/formula_residual.hpp describes the members that the formula of an error must have.
namespace {

/** Whitened transfer error. The transfer error is r = p(H x1) - x2, where p is the perspective
division; x2 and x1 have the covariances L2 L2^T and L1 L1^T. To first order, the covariance of r is
S = L2 L2^T + A L1 (A L1)^T, where A is the derivative of p(H x1) with respect to x1. The squared
error is r^T S^-1 r: to first order, the squared Mahalanobis distance of the match from the manifold
of exact matches @cite hartley2003multiple. The error vector is C^-1 r, where C is the lower
Cholesky factor of S.

With the 2x4 matrix M = [L2, A L1], S is M M^T. det S is the sum of the squares of the 2x2 minors of
M, and r^T S^-1 r det S is the sum of the squares of those 2x2 minors of [M, r] that contain the
column r. Both are computed in this way because it loses no digits to cancellation if the standard
deviations of a point in two directions differ by factors of hundreds. All minors are divided by the
root of S00, the first entry of S, so that their squares stay within the range of float even if the
standard deviations of two points differ by a factor of 1e12. */
struct WhitenedTransferError
{
    enum { COLUMNS = 10, NUMBERS = 9, COMPONENTS = 2, HOMOGENEOUS = 1, PROJECTION = 0 };

    template <class T>
    struct At
    {
        At(const T* m, T x1, T y1, T x2, T y2, T p2_, T q2_, T s2_, T p1_, T q1_, T s1_)
            : t(m, x1, y1, x2, y2), h0(m[6]), h1(m[7]), p2(p2_), q2(q2_), s2(s2_), p1(p1_), q1(q1_),
              s1(s1_), a0(t.w * (m[0] - t.u * m[6])), a1(t.w * (m[1] - t.u * m[7])),
              b0(t.w * (m[3] - t.v * m[6])), b1(t.w * (m[4] - t.v * m[7])), g0(a0 * p1 + a1 * q1),
              g1(a1 * s1), k0(b0 * p1 + b1 * q1), k1(b1 * s1),
              scale(inverseRoot(p2 * p2 + g0 * g0 + g1 * g1))
        {}

        static float inverseRoot(float x) { return 1.f / sqrtf(x); }
        static double inverseRoot(double x) { return 1 / std::sqrt(x); }

        T squared() const
        {
            const T r0 = scale * t.du, r1 = scale * t.dv;
            const T n0 = q2 * r0 - p2 * r1, n1 = s2 * r0, n2 = k0 * r0 - g0 * r1,
                    n3 = k1 * r0 - g1 * r1;
            return (n0 * n0 + n1 * n1 + n2 * n2 + n3 * n3) / complement();
        }
        T cost() const { return squared(); }

        //! det S / S00: variance of the second component of r if the first component is known.
        T complement() const
        {
            const T p = scale * p2, s = scale * s2, g = scale * g0, h = scale * g1;
            const T n0 = p * s2, n1 = p * k0 - q2 * g, n2 = p * k1 - q2 * h, n3 = s * g0,
                    n4 = s * g1, n5 = g * k1 - h * k0;
            return n0 * n0 + n1 * n1 + n2 * n2 + n3 * n3 + n4 * n4 + n5 * n5;
        }

        template <class Out>
        void linearize(Out& out) const
        {
            const T S01 = p2 * q2 + g0 * k0 + g1 * k1;
            const Whitening whitening(scale, S01, complement(), t.du, t.dv);
            out.error(0) = whitening.first;
            out.error(1) = whitening.second;
            column(0, whitening, out);
            column(1, whitening, out);
            column(2, whitening, out);
        }

        //! The error vector C^-1 r as a function of r and S.
        struct Whitening
        {
            Whitening(T scale, T S01, T complement, T r0_, T r1_)
                : r0(r0_), inverse0(scale * scale), slope(S01 * inverse0), rest(r1_ - slope * r0),
                  scale0(scale), scale1(inverseRoot(complement)), first(scale0 * r0),
                  second(scale1 * rest)
            {}

            //! Writes the derivative of the error vector with respect to entry `number` of H, given
            //! the derivatives of r and S.
            template <class Out>
            void change(int number, T dr0, T dr1, T dS00, T dS01, T dS11, Out& out) const
            {
                const T dSlope = (dS01 - slope * dS00) * inverse0,
                        dRest = dr1 - slope * dr0 - r0 * dSlope,
                        dComplement = dS11 - 2 * slope * dS01 + slope * slope * dS00;
                out.derivative(0, number) = scale0 * (dr0 - r0 * inverse0 * dS00 / 2);
                out.derivative(1, number) = scale1 *
                                            (dRest - rest * scale1 * scale1 * dComplement / 2);
            }

            const T r0, inverse0, slope, rest, scale0, scale1, first, second;
        };

        /** Derivatives with respect to the three entries of column `k` of H. Let a and b be the
        rows of A, (u, v) the mapped point, w the reciprocal of its homogeneous coordinate, p
        coordinate `k` of the homogeneous x1, and d the derivative of a with respect to the entry in
        the first row of H. Then d is also the derivative of b with respect to the entry in the
        second row, and the derivatives of a and b with respect to the entry in the third row are
        -u d - (w p) a and -v d - (w p) b. Always inlined, because clang does not vectorize a loop
        with a call. */
        template <class Out>
        CV_ALWAYS_INLINE void column(int k, const Whitening& whitening, Out& out) const
        {
            const T wp = t.w * t.p(k);
            const T d0 = t.w * ((k == 0 ? T(1) : T(0)) - wp * h0),
                    d1 = t.w * ((k == 1 ? T(1) : T(0)) - wp * h1);
            const T e0 = d0 * p1 + d1 * q1, e1 = d1 * s1;  // d L1
            const T ge = g0 * e0 + g1 * e1, ke = k0 * e0 + k1 * e1;
            const T gg = g0 * g0 + g1 * g1, gk = g0 * k0 + g1 * k1, kk = k0 * k0 + k1 * k1;
            whitening.change(k, wp, T(0), 2 * ge, ke, T(0), out);
            whitening.change(3 + k, T(0), wp, T(0), ge, 2 * ke, out);
            whitening.change(6 + k, -t.u * wp, -t.v * wp, -2 * (t.u * ge + wp * gg),
                             -t.u * ke - t.v * ge - 2 * wp * gk, -2 * (t.v * ke + wp * kk), out);
        }

        const TransferError::At<T> t;
        const T h0, h1;                  //!< the first two entries of the third row of H
        const T p2, q2, s2, p1, q1, s1;  //!< L2 = [p2 0; q2 s2] and L1 = [p1 0; q1 s1]
        const T a0, a1, b0, b1;          //!< rows (a0, a1) and (b0, b1) of A
        const T g0, g1, k0, k1;          //!< rows (g0, g1) and (k0, k1) of A L1
        const T scale;                   //!< 1 / sqrt(S00)
    };
};

}  // namespace

}  // namespace usacv20
}  // namespace cv

#endif
