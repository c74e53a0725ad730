// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/affinity/affinity.hpp"
#include "problems/affinity/affinity_parameterization.hpp"
#include "problems/two_view/moments.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Points are collinear if the determinant of their second moments in image 1 is at most this part
//! of the squared trace, which rounding alone can cause, with a margin for points close together.
constexpr double ON_A_LINE = 1e-13;

//! Least squares of the transfer error, in closed form: A is the cross-covariance of the images
//! times the inverse covariance of image 1.
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
        if (!(determinant > ON_A_LINE * trace * trace))  // false for NaN
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

Ptr<NonMinimalSolver> createAffinityLeastSquares() { return makePtr<AffinityLeastSquares>(); }

}  // namespace usacv20
}  // namespace cv
