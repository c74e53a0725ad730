// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "lanes/essential_basis.hpp"

namespace cv {
namespace usacv20 {

namespace {

double product(const double* a, const double* b)
{
    double sum = 0;
    for (int i = 0; i < 9; ++i)
        sum += a[i] * b[i];
    return sum;
}

//! Gram-Schmidt step: makes the k-th vector orthogonal to the vectors before it, which are
//! orthonormal, and scales it to unit length. @return the length before this scaling
double orthonormalize(double (*vectors)[9], int k)
{
    double* const v = vectors[k];
    for (int j = 0; j < k; ++j)
    {
        const double along = product(vectors[j], v);
        for (int i = 0; i < 9; ++i)
            v[i] -= along * vectors[j][i];
    }
    const double length = std::sqrt(product(v, v)), inverse = 1 / length;
    for (int i = 0; i < 9; ++i)
        v[i] *= inverse;
    return length;
}

//! The rotation that maps the viewing directions of the points in image 1 to those in image 2, in
//! the sense of least squares @cite umeyama1991least.
Matx33d rotationOf(const Correspondences& p, const int* sample)
{
    Matx33d sum = Matx33d::zeros(), U, Vt;
    for (int k = 0; k < 5; ++k)
    {
        const int i = sample[k];
        const Vec3d a(p.exact[X1][i], p.exact[Y1][i], 1), b(p.exact[X2][i], p.exact[Y2][i], 1);
        sum += b * a.t() * (1 / std::sqrt(a.dot(a) * b.dot(b)));
    }
    Vec3d w;
    SVD::compute(sum, w, U, Vt);
    return U * Matx33d::diag(Vec3d(1, 1, determinant(U) * determinant(Vt) < 0 ? -1 : 1)) * Vt;
}

}  // namespace

void align(const Correspondences& points, const int* sample, EssentialBasis& basis)
{
    //! Three times a 3x3 rotation matrix without small entries. It mixes the three matrices [t]x R
    //! with t along an axis, so that x, y and z are finite even if the true t is along an axis.
    static const double ROTATION[3][3] = {{2, -2, 1}, {2, 1, -2}, {1, 2, 2}};
    const double SMALLEST = 1e-6;  // lower bound of the length of Z, because of rounding errors
    EssentialBasis q;
    for (int k = 0; k < 4; ++k)
        orthonormalize(basis, k);
    const Matx33d R = rotationOf(points, sample);
    double inside = 1;  // squared cosine of the largest angle between a matrix [t]x R, with t along
                        // an axis, and the space that the basis spans
    for (int k = 0; k < 3; ++k)
    {
        const Matx33d crossed(0, -(k == 2), k == 1, k == 2, 0, -(k == 0), -(k == 1), k == 0, 0);
        const Matx33d rotation = crossed * R * std::sqrt(0.5);
        std::fill(q[k], q[k] + 9, 0.);
        for (int j = 0; j < 4; ++j)
        {
            const double along = product(rotation.val, basis[j]);
            for (int i = 0; i < 9; ++i)
                q[k][i] += along * basis[j][i];
        }
        inside = std::min(inside, product(q[k], q[k]));
        orthonormalize(q, k);
    }
    double most = 0, rest[9] = {0};
    for (int j = 0; j < 4; ++j)
    {
        std::copy(basis[j], basis[j] + 9, q[3]);
        const double length = orthonormalize(q, 3);
        if (length > most)
        {
            most = length;
            std::copy(q[3], q[3] + 9, rest);
        }
    }
    const double scale = std::max(std::sqrt(1 - inside), SMALLEST);
    for (int i = 0; i < 9; ++i)
    {
        for (int k = 0; k < 3; ++k)
            basis[k == 2 ? 3 : k][i] = (ROTATION[k][0] * q[0][i] + ROTATION[k][1] * q[1][i] +
                                        ROTATION[k][2] * q[2][i]) /
                                       3;
        basis[2][i] = scale * rest[i];
    }
}

}  // namespace usacv20
}  // namespace cv
