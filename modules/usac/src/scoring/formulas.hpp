// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_FORMULAS_HPP
#define OPENCV_USACV20_FORMULAS_HPP

namespace cv {
namespace usacv20 {

/* The formulas of the geometric errors, for float and double. They are inside an
unnamed namespace because this file is compiled several times for different instruction sets, and
the linker would merge inline functions with external linkage; for the same reason they call sqrtf()
and fabsf() instead of functions of std. `m` is the model row by row, NUMBERS numbers; a datum has
COLUMNS numbers. Where an error is undefined, the result is NaN or infinite. */
namespace {

//! MSAC cost: truncated squared error in units of the squared threshold @cite torr2000mlesac.
inline float msacCost(float squaredError, float scale)
{
    const float cost = squaredError * scale;
    return cost < 1.f ? cost : 1.f;  // also for NaN
}

/** Transfer error in image 2, squared: |p(H x1) - x2|^2 with p the perspective division
@cite hartley2003multiple. */
struct TransferError
{
    enum { COLUMNS = 4, NUMBERS = 9 };

    template <typename T>
    static inline T squared(const T* m, T x1, T y1, T x2, T y2)
    {
        const T w = T(1) / (m[6] * x1 + m[7] * y1 + m[8]);
        const T dx = (m[0] * x1 + m[1] * y1 + m[2]) * w - x2;
        const T dy = (m[3] * x1 + m[4] * y1 + m[5]) * w - y2;
        return dx * dx + dy * dy;
    }
};

//! First two entries (a, b) of F x1 and (d, e) of F^T x2, and r = x2^T F x1.
template <typename T>
struct EpipolarLines
{
    EpipolarLines(const T* m, T x1, T y1, T x2, T y2)
        : a(m[0] * x1 + m[1] * y1 + m[2]), b(m[3] * x1 + m[4] * y1 + m[5]),
          d(m[0] * x2 + m[3] * y2 + m[6]), e(m[1] * x2 + m[4] * y2 + m[7]),
          r(x2 * a + y2 * b + (m[6] * x1 + m[7] * y1 + m[8]))
    {}
    T a, b, d, e, r;
};

/** Sampson distance, squared: (x2^T F x1)^2 / (|(F x1)_{1,2}|^2 + |(F^T x2)_{1,2}|^2)
@cite hartley2003multiple. */
struct SampsonError
{
    enum { COLUMNS = 4, NUMBERS = 9 };

    template <typename T>
    static inline T squared(const T* m, T x1, T y1, T x2, T y2)
    {
        const EpipolarLines<T> l(m, x1, y1, x2, y2);
        return l.r * l.r / (l.a * l.a + l.b * l.b + l.d * l.d + l.e * l.e);
    }
};

/** Symmetric transfer error, squared: that of H in image 2 plus that of its inverse in image 1
@cite hartley2003multiple. The adjugate serves as the inverse, because a factor cancels; it does not
depend on the point. */
struct SymmetricTransferError
{
    enum { COLUMNS = 4, NUMBERS = 9 };

    template <typename T>
    static inline T squared(const T* m, T x1, T y1, T x2, T y2)
    {
        const T a[9] = {
            m[4] * m[8] - m[5] * m[7], m[2] * m[7] - m[1] * m[8], m[1] * m[5] - m[2] * m[4],
            m[5] * m[6] - m[3] * m[8], m[0] * m[8] - m[2] * m[6], m[2] * m[3] - m[0] * m[5],
            m[3] * m[7] - m[4] * m[6], m[1] * m[6] - m[0] * m[7], m[0] * m[4] - m[1] * m[3]};
        return TransferError::squared(m, x1, y1, x2, y2) +
               TransferError::squared(a, x2, y2, x1, y1);
    }
};

/** Symmetric epipolar distance, squared: (x2^T F x1)^2 (1 / |(F x1)_{1,2}|^2 + 1 / |(F^T
x2)_{1,2}|^2) @cite hartley2003multiple. */
struct SymmetricEpipolarError
{
    enum { COLUMNS = 4, NUMBERS = 9 };

    template <typename T>
    static inline T squared(const T* m, T x1, T y1, T x2, T y2)
    {
        const EpipolarLines<T> l(m, x1, y1, x2, y2);
        return l.r * l.r * (T(1) / (l.a * l.a + l.b * l.b) + T(1) / (l.d * l.d + l.e * l.e));
    }
};

/** Reprojection error, squared: |p(P X) - x|^2 for a point X of space and the 3x4 matrix P of a
camera @cite hartley2003multiple. Infinite for a point that is not in front of the camera. */
struct ReprojectionError
{
    enum { COLUMNS = 5, NUMBERS = 12 };

    template <typename T>
    static inline T squared(const T* m, T X, T Y, T Z, T u, T v)
    {
        const T depth = m[8] * X + m[9] * Y + m[10] * Z + m[11], w = T(1) / depth;
        const T dx = (m[0] * X + m[1] * Y + m[2] * Z + m[3]) * w - u;
        const T dy = (m[4] * X + m[5] * Y + m[6] * Z + m[7]) * w - v;
        const T square = dx * dx + dy * dy;
        return depth > T(0) ? square : T(INFINITY);  // false for NaN
    }
};

/** Distance in space, squared: |A X1 + t - X2|^2 for the 3x4 matrix [A t]. */
struct SpaceTransferError
{
    enum { COLUMNS = 6, NUMBERS = 12 };

    template <typename T>
    static inline T squared(const T* m, T X1, T Y1, T Z1, T X2, T Y2, T Z2)
    {
        const T dx = m[0] * X1 + m[1] * Y1 + m[2] * Z1 + m[3] - X2;
        const T dy = m[4] * X1 + m[5] * Y1 + m[6] * Z1 + m[7] - Y2;
        const T dz = m[8] * X1 + m[9] * Y1 + m[10] * Z1 + m[11] - Z2;
        return dx * dx + dy * dy + dz * dz;
    }
};

}  // namespace

}  // namespace usacv20
}  // namespace cv

#endif
