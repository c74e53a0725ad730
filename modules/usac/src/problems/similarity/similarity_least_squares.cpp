// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/similarity/similarity.hpp"
#include "problems/similarity/similarity_parameterization.hpp"
#include "problems/two_view/moments.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Least squares of the transfer error, in closed form. With the points as complex numbers, this is
linear regression with one coefficient a + bi: the cross-covariance of the images divided by the
variance of image 1. */
class SimilarityLeastSquares : public NonMinimalSolver
{
public:
    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int) const CV_OVERRIDE
    {
        if (count < 2)
            return false;
        const Moments m(points, indices, count, weights);
        const double variance = m.xx + m.yy;
        const double a = (m.xu + m.yv) / variance, b = (m.xv - m.yu) / variance;
        const Model fitted = m.map(a, -b, b, a);
        if (!(variance > 0 && a * a + b * b <= DBL_MAX) ||
            !SimilarityParameterization(fitted).hasFullRank())
            return false;
        model = fitted;
        return true;
    }
};

}  // namespace

Ptr<NonMinimalSolver> createSimilarityLeastSquares() { return makePtr<SimilarityLeastSquares>(); }

}  // namespace usacv20
}  // namespace cv
