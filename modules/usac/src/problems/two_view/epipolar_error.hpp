// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_EPIPOLAR_ERROR_HPP
#define OPENCV_USACV20_EPIPOLAR_ERROR_HPP

#include <cmath>

namespace cv {
namespace usacv20 {

// residual/formula_residual.hpp describes the members that the formula of an error must have.
namespace {

//! If both points of a match are epipoles, the numerator and the denominator of the Sampson
//! distance are 0. For a term of the symmetric epipolar distance, both are 0 even if only one point
//! is an epipole. For the Sampson distance with covariances, both are 0 even if only one point is
//! an epipole, provided that its covariance is 0. Fits add this constant to each denominator, so
//! that the quotient is then 0. The constant is far below any other denominator.
constexpr double BOTH_EPIPOLES = 1e-200;

//! Computes the first two entries (a, b) of F x1 and (d, e) of F^T x2, and r = x2^T F x1.
template <class T>
struct EpipolarLines
{
    EpipolarLines(const T* m, T x1_, T y1_, T x2_, T y2_)
        : x1(x1_), y1(y1_), x2(x2_), y2(y2_), a(m[0] * x1 + m[1] * y1 + m[2]),
          b(m[3] * x1 + m[4] * y1 + m[5]), d(m[0] * x2 + m[3] * y2 + m[6]),
          e(m[1] * x2 + m[4] * y2 + m[7]), r(x2 * a + y2 * b + (m[6] * x1 + m[7] * y1 + m[8]))
    {}

    //! Computes the error component r / sqrt(D) and its derivative. D is the sum of the squares of
    //! a and b (if `first` is true) and of d and e (if `second` is true).
    template <class Out>
    void linearize(int component, bool first, bool second, Out& out) const
    {
        const T a0 = first ? a : 0, b0 = first ? b : 0, d0 = second ? d : 0, e0 = second ? e : 0;
        linearize(component, a0, b0, d0, e0, a0 * a0 + b0 * b0 + d0 * d0 + e0 * e0, out);
    }

    /** Computes the error component r / sqrt(D) and its derivative with respect to F. D is `form`,
    the sum of a quadratic form of (a, b) and one of (d, e); half the derivatives of D with respect
    to (a, b) and to (d, e) are (a0, b0) and (d0, e0). The derivative is
    (x2 x1^T - r / D ((a0, b0, 0)^T x1^T + x2 (d0, e0, 0))) / sqrt(D). */
    template <class Out>
    void linearize(int component, T a0, T b0, T d0, T e0, T form, Out& out) const
    {
        const T D = form + BOTH_EPIPOLES;
        const T s = 1 / std::sqrt(D), q = r * s * s;
        const T left0 = s * (x2 - q * a0), left1 = s * (y2 - q * b0);
        const T right0 = s * q * d0, right1 = s * q * e0;
        out.derivative(component, 0) = left0 * x1 - x2 * right0;
        out.derivative(component, 1) = left0 * y1 - x2 * right1;
        out.derivative(component, 2) = left0;
        out.derivative(component, 3) = left1 * x1 - y2 * right0;
        out.derivative(component, 4) = left1 * y1 - y2 * right1;
        out.derivative(component, 5) = left1;
        out.derivative(component, 6) = s * x1 - right0;
        out.derivative(component, 7) = s * y1 - right1;
        out.derivative(component, 8) = s;
        out.error(component) = r * s;
    }

    const T x1, y1, x2, y2, a, b, d, e, r;
};

/** Sampson distance, squared: (x2^T F x1)^2 / (|(F x1)_{1,2}|^2 + |(F^T x2)_{1,2}|^2)
@cite hartley2003multiple. */
struct SampsonError
{
    enum { COLUMNS = 4, NUMBERS = 9, COMPONENTS = 1, HOMOGENEOUS = 1, PROJECTION = 0 };

    template <class T>
    struct At
    {
        At(const T* m, T x1, T y1, T x2, T y2) : l(m, x1, y1, x2, y2) {}

        T squared() const { return l.r * l.r / (l.a * l.a + l.b * l.b + l.d * l.d + l.e * l.e); }
        T cost() const
        {
            return l.r * l.r / (l.a * l.a + l.b * l.b + l.d * l.d + l.e * l.e + BOTH_EPIPOLES);
        }
        template <class Out>
        void linearize(Out& out) const
        {
            l.linearize(0, true, true, out);
        }

        const EpipolarLines<T> l;
    };
};

/** Sampson distance, squared, if x2 and x1 have the covariances L2 L2^T and L1 L1^T: the square of
r = x2^T F x1 divided by the variance of r, to first order,
r^2 / (|L2^T (F x1)_{1,2}|^2 + |L1^T (F^T x2)_{1,2}|^2) @cite hartley2003multiple. If both
covariances are unit matrices, this is SampsonError. */
struct WhitenedSampsonError
{
    enum { COLUMNS = 10, NUMBERS = 9, COMPONENTS = 1, HOMOGENEOUS = 1, PROJECTION = 0 };

    template <class T>
    struct At
    {
        At(const T* m, T x1, T y1, T x2, T y2, T p2_, T q2_, T s2_, T p1_, T q1_, T s1_)
            : l(m, x1, y1, x2, y2), p2(p2_), q2(q2_), s2(s2_), p1(p1_), q1(q1_), s1(s1_),
              a(p2 * l.a + q2 * l.b), b(s2 * l.b), d(p1 * l.d + q1 * l.e), e(s1 * l.e)
        {}

        T squared() const { return l.r * l.r / variance(); }
        T cost() const { return l.r * l.r / (variance() + BOTH_EPIPOLES); }
        T variance() const { return a * a + b * b + d * d + e * e; }

        template <class Out>
        void linearize(Out& out) const
        {
            l.linearize(0, p2 * a, q2 * a + s2 * b, p1 * d, q1 * d + s1 * e, variance(), out);
        }

        const EpipolarLines<T> l;
        const T p2, q2, s2, p1, q1, s1;  //!< L2 = [p2 0; q2 s2] and L1 = [p1 0; q1 s1]
        const T a, b, d, e;              //!< L2^T (F x1)_{1,2} and L1^T (F^T x2)_{1,2}
    };
};

/** Symmetric epipolar distance, squared:
(x2^T F x1)^2 (1 / |(F x1)_{1,2}|^2 + 1 / |(F^T x2)_{1,2}|^2) @cite hartley2003multiple. */
struct SymmetricEpipolarError
{
    enum { COLUMNS = 4, NUMBERS = 9, COMPONENTS = 2, HOMOGENEOUS = 1, PROJECTION = 0 };

    template <class T>
    struct At
    {
        At(const T* m, T x1, T y1, T x2, T y2) : l(m, x1, y1, x2, y2) {}

        T squared() const
        {
            return l.r * l.r * (T(1) / (l.a * l.a + l.b * l.b) + T(1) / (l.d * l.d + l.e * l.e));
        }
        T cost() const
        {
            return l.r * l.r *
                   (T(1) / (l.a * l.a + l.b * l.b + BOTH_EPIPOLES) +
                    T(1) / (l.d * l.d + l.e * l.e + BOTH_EPIPOLES));
        }
        template <class Out>
        void linearize(Out& out) const
        {
            l.linearize(0, true, false, out);
            l.linearize(1, false, true, out);
        }

        const EpipolarLines<T> l;
    };
};

}  // namespace

}  // namespace usacv20
}  // namespace cv

#endif
