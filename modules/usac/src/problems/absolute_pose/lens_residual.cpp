// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/absolute_pose/lens_residual.hpp"
#include "problems/absolute_pose/reprojection_error.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Numbers in a datum: three of the object point and two of the image point (COLUMNS) and, if there
//! are covariances, three of the root of the image point's covariance (ROOT).
enum { COLUMNS = 5, ROOT = 3 };
//! Value of both components of the error of a point that the camera does not see. Its square
//! exceeds any sum of squared errors of visible points.
constexpr double UNSEEN = 1e100;

//! Multiplies the vector (x, y) by the inverse of the root [p 0; q s] of a covariance; `root` is
//! p, q, s.
void whiten(const double* root, double& x, double& y)
{
    const InverseRoot<double> inverse(root[0], root[1], root[2]);
    x = inverse.first(x);
    y = inverse.second(x, y);
}

}  // namespace

//! Projects the object point of a datum. False if the camera does not see the point. `derivative`,
//! unless null, is the derivative of `seenAt` with respect to the product of PoseCamera::matrix and
//! the vector R X + t, that is, the point before the division by its depth.
bool LensResidual::project(const Model& model, const double* datum, Vec2d& seenAt,
                           Matx<double, 2, 3>* derivative) const
{
    const double *m = model.val, X = datum[0], Y = datum[1], Z = datum[2];
    const double depth = m[8] * X + m[9] * Y + m[10] * Z + m[11], w = 1 / depth;
    if (!(depth > 0))
        return false;
    const double u = (m[0] * X + m[1] * Y + m[2] * Z + m[3]) * w,
                 v = (m[4] * X + m[5] * Y + m[6] * Z + m[7]) * w;
    const Matx33d& inverse = camera.inverse;
    const Vec2d point(inverse(0, 0) * u + inverse(0, 1) * v, inverse(1, 0) * u + inverse(1, 1) * v);
    Matx22d J;
    if (!camera.see(point, seenAt, derivative ? &J : 0))
        return false;
    if (derivative)
    {
        J = J * Matx22d(inverse(0, 0), inverse(0, 1), inverse(1, 0), inverse(1, 1)) * w;
        *derivative = Matx<double, 2, 3>(J(0, 0), J(0, 1), -(J(0, 0) * u + J(0, 1) * v), J(1, 0),
                                         J(1, 1), -(J(1, 0) * u + J(1, 1) * v));
    }
    return true;
}

int LensResidual::error(const Model& model, const double* datum, double* error) const
{
    Vec2d seenAt;
    const bool seen = project(model, datum, seenAt, 0);
    for (int k = 0; k < 2; ++k)
        error[k] = seen ? seenAt[k] - datum[3 + k] : UNSEEN;
    if (seen && whitened)
        whiten(datum + COLUMNS, error[0], error[1]);
    return 2;
}

int LensResidual::linearize(const Model& model, const double* datum, double* error,
                            double* derivative) const
{
    Vec2d seenAt;
    Matx<double, 2, 3> J = Matx<double, 2, 3>::zeros();
    const bool seen = project(model, datum, seenAt, &J);
    const double point[4] = {datum[0], datum[1], datum[2], 1};
    for (int k = 0; k < 2; ++k)
    {
        error[k] = seen ? seenAt[k] - datum[3 + k] : UNSEEN;
        for (int row = 0; row < 3; ++row)
            for (int col = 0; col < 4; ++col)
                derivative[12 * k + 4 * row + col] = J(k, row) * point[col];
    }
    if (!whitened)
        return 2;
    if (seen)
        whiten(datum + COLUMNS, error[0], error[1]);
    for (int i = 0; i < 12; ++i)
        whiten(datum + COLUMNS, derivative[i], derivative[12 + i]);
    return 2;
}

double LensResidual::squared(const Model& model, const double* const* columns, int i) const
{
    double datum[COLUMNS + ROOT];
    for (int k = 0; k < COLUMNS + (whitened ? (int)ROOT : 0); ++k)
        datum[k] = columns[k][i];
    Vec2d seenAt;
    if (!project(model, datum, seenAt, 0))
        return INFINITY;
    double dx = seenAt[0] - datum[3], dy = seenAt[1] - datum[4];
    if (whitened)
        whiten(datum + COLUMNS, dx, dy);
    return dx * dx + dy * dy;
}

void LensResidual::squaredErrors(const Model& model, const double* const* columns, int count,
                                 double* errors) const
{
    for (int i = 0; i < count; ++i)
        errors[i] = squared(model, columns, i);
}

void LensResidual::squaredErrors(const Correspondences& points, const Model& model, int begin,
                                 int end, float* errors) const
{
    for (int i = begin; i < end; ++i)
        errors[i - begin] = (float)squared(model, points.exact, i);
}

}  // namespace usacv20
}  // namespace cv
