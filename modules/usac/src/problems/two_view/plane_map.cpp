// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/two_view/plane_map.hpp"
#include "problems/two_view/two_view.hpp"
#include "problems/kernels.hpp"

namespace cv {
namespace usacv20 {

Moments::Moments(const Correspondences& points, const int* indices, int count,
                 const double* weights)
{
    const double *x1 = points.exact[X1], *y1 = points.exact[Y1], *x2 = points.exact[X2],
                 *y2 = points.exact[Y2];
    const int first = indices[0];
    const double x0 = x1[first], y0 = y1[first], u0 = x2[first], v0 = y2[first];
    double sum = 0, sx = 0, sy = 0, su = 0, sv = 0;
    xx = xy = yy = xu = xv = yu = yv = 0;
    for (int i = 0; i < count; ++i)
    {
        const int k = indices[i];
        const double w = weights ? weights[i] : 1, x = x1[k] - x0, y = y1[k] - y0, u = x2[k] - u0,
                     v = y2[k] - v0, wx = w * x, wy = w * y;
        sum += w;
        sx += wx;
        sy += wy;
        su += w * u;
        sv += w * v;
        xx += wx * x;
        xy += wx * y;
        yy += wy * y;
        xu += wx * u;
        xv += wx * v;
        yu += wy * u;
        yv += wy * v;
    }
    const double mx = sx / sum, my = sy / sum, mu = su / sum, mv = sv / sum;
    xx -= sx * mx;
    xy -= sx * my;
    yy -= sy * my;
    xu -= sx * mu;
    xv -= sx * mv;
    yu -= sy * mu;
    yv -= sy * mv;
    mean[0] = x0 + mx;
    mean[1] = y0 + my;
    mean[2] = u0 + mu;
    mean[3] = v0 + mv;
}

Matx33d Moments::map(double a, double b, double c, double d) const
{
    return Matx33d(a, b, mean[2] - a * mean[0] - b * mean[1], c, d,
                   mean[3] - c * mean[0] - d * mean[1], 0, 0, 1);
}

int PlaneMapProblem::normalization(int residual) const
{
    return residual == RESIDUAL_SYMMETRIC ? SCALE_COMMON : SCALE_EACH;
}

//! Converts entry by entry, so that the last row stays exactly 0 0 1.
bool PlaneMapProblem::toInput(const Model& model, const Correspondences& points,
                              Model& result) const
{
    const Frame &from = points.frame[0], &to = points.frame[1];
    Matx33d map = Matx33d::eye();
    for (int row = 0; row < 2; ++row)
    {
        const double a = model(row, 0) * from.scale, b = model(row, 1) * from.scale;
        map(row, 0) = a / to.scale;
        map(row, 1) = b / to.scale;
        map(row, 2) = (model(row, 2) - a * from.center[0] - b * from.center[1]) / to.scale +
                      to.center[row];
    }
    result = map;
    const bool linear = map(0, 0) != 0 || map(0, 1) != 0 || map(1, 0) != 0 ||
                        map(1, 1) != 0;  // false: all entries have underflowed
    return linear && checkRange(Mat(map, false));
}

bool PlaneMapProblem::fromOutput(const std::vector<double>& output, const Correspondences& points,
                                 Model& model) const
{
    if (output.size() != 6)
        return false;
    const Frame &from = points.frame[0], &to = points.frame[1];
    Matx33d map = Matx33d::eye();
    for (int row = 0; row < 2; ++row)
    {
        const double *given = &output[3 * row], a = given[0], b = given[1];
        map(row, 0) = a * to.scale / from.scale;
        map(row, 1) = b * to.scale / from.scale;
        map(row, 2) = (a * from.center[0] + b * from.center[1] + given[2] - to.center[row]) *
                      to.scale;
    }
    model = closest(map);
    return checkRange(Mat(3, 3, CV_64F, model.val));
}

Mat PlaneMapProblem::toOutput(const Model& model) const
{
    return Mat(2, 3, CV_64F, (void*)model.val).clone();
}

Model PlaneMapProblem::ofOutput(const Mat& output) const
{
    Matx33d map = Matx33d::eye();
    output.copyTo(Mat(2, 3, CV_64F, map.val));
    return map;
}

Ptr<Residual> PlaneMapProblem::createResidual(int type) const
{
    return type == RESIDUAL_SYMMETRIC ? createResidualOf<SymmetricTransferError>()
                                      : createResidualOf<TransferError>();
}

/** Every orientation of a sample is valid for an affine map, and dominant planes are not a
degeneracy. Therefore only repeated points and crowded places are checked. The set of all flags
means all checks that exist for a problem. Any other set with #DEGENERACY_DEGENSAC is an error,
because the caller expects a check that does not exist. */
void PlaneMapProblem::createDegeneracies(int flags,
                                         std::vector<Ptr<Degeneracy>>& degeneracies) const
{
    createChecksOfMaps(flags, name(), degeneracies);
}

}  // namespace usacv20
}  // namespace cv
