// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TRANSFER_ERROR_HPP
#define OPENCV_USACV20_TRANSFER_ERROR_HPP

namespace cv {
namespace usacv20 {

// The contract of a formula is in residual/formula_residual.hpp.
namespace {

/** Transfer error in image 2: p(H x1) - x2, where p is the perspective division
@cite hartley2003multiple. */
struct TransferError
{
    enum { COLUMNS = 4, NUMBERS = 9, COMPONENTS = 2, HOMOGENEOUS = 1, PROJECTION = 1 };

    template <class T>
    struct At
    {
        At(const T* m, T x1, T y1, T x2, T y2)
            : x(x1), y(y1), w(T(1) / (m[6] * x1 + m[7] * y1 + m[8])),
              u((m[0] * x1 + m[1] * y1 + m[2]) * w), v((m[3] * x1 + m[4] * y1 + m[5]) * w),
              du(u - x2), dv(v - y2)
        {}

        T squared() const { return du * du + dv * dv; }
        T cost() const { return squared(); }
        //! Homogeneous coordinate `k` of the point of image 1.
        T p(int k) const { return k == 0 ? x : k == 1 ? y : T(1); }

        template <class Out>
        void linearize(Out& out) const
        {
            out.error(0) = du;
            out.error(1) = dv;
            column(0, out);
            column(1, out);
            column(2, out);
        }

        //! Derivatives with respect to a column of H.
        template <class Out>
        void column(int k, Out& out) const
        {
            const T wp = w * p(k);
            out.derivative(0, k) = out.derivative(1, 3 + k) = wp;
            out.derivative(1, k) = out.derivative(0, 3 + k) = 0;
            out.derivative(0, 6 + k) = -u * wp;
            out.derivative(1, 6 + k) = -v * wp;
        }

        const T x, y, w, u, v, du, dv;
    };
};

/** Symmetric transfer error: the transfer error of H in image 2 and that of its inverse in image 1
@cite hartley2003multiple. The adjugate A of H is used as the inverse, because the factor 1 / det H
cancels in the perspective division. */
struct SymmetricTransferError
{
    enum { COLUMNS = 4, NUMBERS = 9, COMPONENTS = 4, HOMOGENEOUS = 1, PROJECTION = 0 };

    template <class T>
    struct At
    {
        At(const T* m, T x1, T y1, T x2, T y2)
            : A{m[4] * m[8] - m[5] * m[7], m[2] * m[7] - m[1] * m[8], m[1] * m[5] - m[2] * m[4],
                m[5] * m[6] - m[3] * m[8], m[0] * m[8] - m[2] * m[6], m[2] * m[3] - m[0] * m[5],
                m[3] * m[7] - m[4] * m[6], m[1] * m[6] - m[0] * m[7], m[0] * m[4] - m[1] * m[3]},
              determinant(m[0] * A[0] + m[1] * A[3] + m[2] * A[6]), forward(m, x1, y1, x2, y2),
              back(A, x2, y2, x1, y1)
        {}

        T squared() const { return forward.squared() + back.squared(); }
        T cost() const { return squared(); }

        /** The inverse G = A / det H has the differential dG = -G dH G. G maps a point p of image 2
        to (u, v); let w be the reciprocal of the third entry of G p. The derivative c p^T of an
        error component with respect to G, with c = w (1, 0, -u) or w (0, 1, -v), thus becomes the
        derivative -(G^T c) (G p)^T with respect to H. */
        template <class Out>
        void linearize(Out& out) const
        {
            forward.linearize(out);
            out.error(2) = back.du;
            out.error(3) = back.dv;
            row(0, out);
            row(1, out);
            row(2, out);
        }

        //! Derivatives of the error in image 1 with respect to a row of H.
        template <class Out>
        void row(int i, Out& out) const
        {
            const T factor = -1 / determinant;
            const T first = factor * (A[i] - back.u * A[6 + i]),
                    second = factor * (A[3 + i] - back.v * A[6 + i]);
            out.derivative(2, 3 * i) = first * back.u;
            out.derivative(2, 3 * i + 1) = first * back.v;
            out.derivative(2, 3 * i + 2) = first;
            out.derivative(3, 3 * i) = second * back.u;
            out.derivative(3, 3 * i + 1) = second * back.v;
            out.derivative(3, 3 * i + 2) = second;
        }

        const T A[9], determinant;
        const TransferError::At<T> forward, back;
    };
};

}  // namespace

}  // namespace usacv20
}  // namespace cv

#endif
