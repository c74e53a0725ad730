// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/similarity/similarity.hpp"
#include "problems/two_view/plane_map.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** The similarity that maps two points exactly. With points as complex numbers, the difference of
the points in image 2 is their difference in image 1 times a + bi. A sample with two equal points in
either image is degenerate. */
class Similarity2Solver : public MinimalSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 2; }

    int solve(const Correspondences& p, const int* sample, Model* models) const CV_OVERRIDE
    {
        const double *x1 = p.exact[X1], *y1 = p.exact[Y1], *x2 = p.exact[X2], *y2 = p.exact[Y2];
        const int i = sample[0], k = sample[1];
        const double u = x1[k] - x1[i], v = y1[k] - y1[i], s = x2[k] - x2[i], t = y2[k] - y2[i];
        const double square = u * u + v * v;
        const double a = (s * u + t * v) / square, b = (t * u - s * v) / square;
        const double size = a * a + b * b;
        if (!(square > 0 && size > 0 && size <= DBL_MAX))
            return 0;
        models[0] = Matx33d(a, -b, x2[i] - a * x1[i] + b * y1[i], b, a,
                            y2[i] - b * x1[i] - a * y1[i], 0, 0, 1);
        return 1;
    }
};

/** Least squares of the transfer error, in closed form. With the points as complex numbers, this is
linear regression with one coefficient a + bi: the cross-covariance of the points in the two images
divided by their variance in image 1. */
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

Ptr<MinimalSolver> createSimilarity2Solver() { return makePtr<Similarity2Solver>(); }

Ptr<NonMinimalSolver> createSimilarityLeastSquares() { return makePtr<SimilarityLeastSquares>(); }

Ptr<Problem> createSimilarity2DProblem()
{
    // 120 is SampleCost::time, in point tests; it was measured together with that of a homography
    const PlaneMapParts parts = {"similarity", 120, false, createSimilarity2Solver,
                                 createSimilarityLeastSquares};
    return makePtr<PlaneMap<SimilarityParameterization>>(parts);
}

}  // namespace usacv20
}  // namespace cv
