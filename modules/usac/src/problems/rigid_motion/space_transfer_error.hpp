// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SPACE_TRANSFER_ERROR_HPP
#define OPENCV_USACV20_SPACE_TRANSFER_ERROR_HPP

namespace cv {
namespace usacv20 {

// The contract of a formula is in residual/formula_residual.hpp.
namespace {

/** Error vector in space 2: A X1 + t - X2 for the 3x4 matrix [A t]. */
struct SpaceTransferError
{
    enum { COLUMNS = 6, NUMBERS = 12, COMPONENTS = 3, HOMOGENEOUS = 0, PROJECTION = 0 };

    template <class T>
    struct At
    {
        At(const T* m, T X1, T Y1, T Z1, T X2, T Y2, T Z2)
            : X(X1), Y(Y1), Z(Z1), dx(m[0] * X1 + m[1] * Y1 + m[2] * Z1 + m[3] - X2),
              dy(m[4] * X1 + m[5] * Y1 + m[6] * Z1 + m[7] - Y2),
              dz(m[8] * X1 + m[9] * Y1 + m[10] * Z1 + m[11] - Z2)
        {}

        T squared() const { return dx * dx + dy * dy + dz * dz; }
        T cost() const { return squared(); }

        template <class Out>
        void linearize(Out& out) const
        {
            out.error(0) = dx;
            out.error(1) = dy;
            out.error(2) = dz;
            for (int k = 0; k < 12; ++k)  // row k / 4 of [A t] affects only component k / 4
            {
                const T p = k % 4 == 0 ? X : k % 4 == 1 ? Y : k % 4 == 2 ? Z : T(1);
                out.derivative(0, k) = k / 4 == 0 ? p : T(0);
                out.derivative(1, k) = k / 4 == 1 ? p : T(0);
                out.derivative(2, k) = k / 4 == 2 ? p : T(0);
            }
        }

        const T X, Y, Z, dx, dy, dz;
    };
};

}  // namespace

}  // namespace usacv20
}  // namespace cv

#endif
