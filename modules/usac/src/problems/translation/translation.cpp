// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/translation/translation.hpp"
#include "problems/two_view/plane_map.hpp"

namespace cv {
namespace usacv20 {

namespace {

Model translationBy(double x, double y) { return Matx33d(1, 0, x, 0, 1, y, 0, 0, 1); }

//! The translation that maps one point exactly. No sample is degenerate.
class Translation1Solver : public MinimalSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 1; }

    int solve(const Correspondences& p, const int* sample, Model* models) const CV_OVERRIDE
    {
        const int i = sample[0];
        models[0] = translationBy(p.exact[X2][i] - p.exact[X1][i], p.exact[Y2][i] - p.exact[Y1][i]);
        return 1;
    }
};

//! Least squares of the transfer error, in closed form: the mean of the displacements. Only
//! differences from the first displacement are summed, so that little precision is lost if all
//! displacements are long and nearly equal.
class TranslationLeastSquares : public NonMinimalSolver
{
public:
    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int) const CV_OVERRIDE
    {
        if (count < 1)
            return false;
        const double *x1 = points.exact[X1], *y1 = points.exact[Y1], *x2 = points.exact[X2],
                     *y2 = points.exact[Y2];
        const int first = indices[0];
        const double x = x2[first] - x1[first], y = y2[first] - y1[first];
        double sum = 0, sumX = 0, sumY = 0;
        for (int i = 0; i < count; ++i)
        {
            const int k = indices[i];
            const double w = weights ? weights[i] : 1;
            sum += w;
            sumX += w * (x2[k] - x1[k] - x);
            sumY += w * (y2[k] - y1[k] - y);
        }
        const Model fitted = translationBy(x + sumX / sum, y + sumY / sum);
        if (!(sum > 0 && std::abs(fitted.val[2]) <= DBL_MAX &&
              std::abs(fitted.val[5]) <= DBL_MAX))  // NaN is rejected, too
            return false;
        model = fitted;
        return true;
    }
};

}  // namespace

Ptr<Problem> createTranslation2DProblem()
{
    // 120 is SampleCost::time, in point tests; it was measured to be about that of a similarity
    const PlaneMapParts parts = {"translation", 120, true, createTranslation1Solver,
                                 createTranslationLeastSquares};
    return makePtr<PlaneMap<TranslationParameterization>>(parts);
}

Ptr<MinimalSolver> createTranslation1Solver() { return makePtr<Translation1Solver>(); }

Ptr<NonMinimalSolver> createTranslationLeastSquares() { return makePtr<TranslationLeastSquares>(); }

}  // namespace usacv20
}  // namespace cv
