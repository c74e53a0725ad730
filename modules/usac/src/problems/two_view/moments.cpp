// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/two_view/moments.hpp"

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

}  // namespace usacv20
}  // namespace cv
