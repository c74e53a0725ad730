// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/affinity/affinity.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Points are collinear if twice the area of their triangle is at most this part of the square of
//! the longer side at the first point; the same value as for a homography.
constexpr double COLLINEAR = 1e-6;

//! The sides of the triangle at its first point, as columns. @return false if the points are
//! (nearly) collinear
bool sidesOf(const double* x, const double* y, const int* s, double* side)
{
    for (int k = 0; k < 2; ++k)
    {
        side[k] = x[s[k + 1]] - x[s[0]];
        side[2 + k] = y[s[k + 1]] - y[s[0]];
    }
    const double longest = std::max(side[0] * side[0] + side[2] * side[2],
                                    side[1] * side[1] + side[3] * side[3]);
    return std::abs(side[0] * side[3] - side[1] * side[2]) > COLLINEAR * longest;  // false for NaN
}

//! Affine map from three points, exact: the sides of one triangle are mapped to those of the other.
class Affinity3Solver : public MinimalSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 3; }

    int solve(const Correspondences& p, const int* sample, Model* models) const CV_OVERRIDE
    {
        double u[4], v[4];
        if (!sidesOf(p.exact[X1], p.exact[Y1], sample, u) ||
            !sidesOf(p.exact[X2], p.exact[Y2], sample, v))
            return 0;
        const double factor = 1 / (u[0] * u[3] - u[1] * u[2]);
        Matx33d map = Matx33d::eye();
        for (int row = 0; row < 2; ++row)
        {
            const double a = (v[2 * row] * u[3] - v[2 * row + 1] * u[2]) * factor,
                         b = (v[2 * row + 1] * u[0] - v[2 * row] * u[1]) * factor;
            map(row, 0) = a;
            map(row, 1) = b;
            map(row, 2) = p.exact[row ? Y2 : X2][sample[0]] - a * p.exact[X1][sample[0]] -
                          b * p.exact[Y1][sample[0]];
        }
        models[0] = map;
        return norm(map) <= DBL_MAX;  // false for NaN
    }
};

}  // namespace

Ptr<MinimalSolver> createAffinity3Solver() { return makePtr<Affinity3Solver>(); }

}  // namespace usacv20
}  // namespace cv
