// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/affinity/affinity.hpp"
#include "problems/two_view/plane_map.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Three points count as collinear if twice the area of their triangle is at most this fraction of
//! the square of the longer side at the first point. The value is the same as for a homography.
constexpr double COLLINEAR = 1e-6;

//! Computes the two sides of a triangle that start at its first point, as columns of a 2x2 matrix.
//! @return false if the points are (nearly) collinear
bool sidesOf(const double* x, const double* y, const int* s, double* side)
{
    for (int k = 0; k < 2; ++k)
    {
        side[k] = x[s[k + 1]] - x[s[0]];
        side[2 + k] = y[s[k + 1]] - y[s[0]];
    }
    const double longest = std::max(side[0] * side[0] + side[2] * side[2],
                                    side[1] * side[1] + side[3] * side[3]);
    // a NaN makes the comparison false
    return std::abs(side[0] * side[3] - side[1] * side[2]) > COLLINEAR * longest;
}

//! Computes the affine map that maps the triangle of three points in image 1 exactly to that in
//! image 2.
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
        return norm(map) <= DBL_MAX;  // no model if an entry is infinite or NaN
    }
};

//! Points count as collinear if the determinant of the matrix of their second moments in image 1 is
//! at most this fraction of the squared trace. Rounding alone can cause a determinant of about
//! DBL_EPSILON times the squared trace; the value includes a margin for points that are close
//! together, whose rounding errors are larger relative to their distances.
constexpr double ON_A_LINE = 1e-13;

//! Least squares of the transfer error, in closed form: the linear part of the map is the
//! cross-covariance of the points in the two images times the inverse of their covariance in
//! image 1.
class AffinityLeastSquares : public NonMinimalSolver
{
public:
    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int) const CV_OVERRIDE
    {
        if (count < 3)
            return false;
        const Moments m(points, indices, count, weights);
        const double determinant = m.xx * m.yy - m.xy * m.xy, trace = m.xx + m.yy;
        if (!(determinant > ON_A_LINE * trace * trace))  // a NaN is rejected, too
            return false;
        const double f = 1 / determinant;
        const Model fitted = m.map((m.xu * m.yy - m.yu * m.xy) * f, (m.yu * m.xx - m.xu * m.xy) * f,
                                   (m.xv * m.yy - m.yv * m.xy) * f,
                                   (m.yv * m.xx - m.xv * m.xy) * f);
        if (!AffinityParameterization(fitted).hasFullRank())
            return false;
        model = fitted;
        return true;
    }
};

}  // namespace

Ptr<MinimalSolver> createAffinity3Solver() { return makePtr<Affinity3Solver>(); }

Ptr<NonMinimalSolver> createAffinityLeastSquares() { return makePtr<AffinityLeastSquares>(); }

Ptr<Problem> createAffinity2DProblem()
{
    // 150 is SampleCost::time, in point tests; it was measured together with that of a homography
    const PlaneMapParts parts = {"affinity", 150, false, createAffinity3Solver,
                                 createAffinityLeastSquares};
    return makePtr<PlaneMap<AffinityParameterization>>(parts);
}

}  // namespace usacv20
}  // namespace cv
