// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/fundamental/fundamental_parameterization.hpp"
#include "core/elimination.hpp"
#include "core/polynomial.hpp"
#include "problems/fundamental/fundamental.hpp"

namespace cv {
namespace usacv20 {

namespace {

void cofactors(const double* m, double* c)
{
    c[0] = m[4] * m[8] - m[5] * m[7];
    c[1] = m[5] * m[6] - m[3] * m[8];
    c[2] = m[3] * m[7] - m[4] * m[6];
    c[3] = m[2] * m[7] - m[1] * m[8];
    c[4] = m[0] * m[8] - m[2] * m[6];
    c[5] = m[1] * m[6] - m[0] * m[7];
    c[6] = m[1] * m[5] - m[2] * m[4];
    c[7] = m[2] * m[3] - m[0] * m[5];
    c[8] = m[0] * m[4] - m[1] * m[3];
}

double dot9(const double* a, const double* b)
{
    double sum = 0;
    for (int i = 0; i < 9; ++i)
        sum += a[i] * b[i];
    return sum;
}

/** @brief One to three fundamental matrices from seven points @cite hartley2003multiple.

The epipolar constraints leave F = s F1 + t F2; det F = 0 is a homogeneous cubic in (s, t). Repeated
points lower the rank of the constraints, so that the sample is degenerate. Collinear points fit
l2 l1^T, which has rank 1 and is no epipolar geometry. */
class Fundamental7Solver : public MinimalSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 7; }

    int solve(const Correspondences& p, const int* sample, Model* models) const CV_OVERRIDE
    {
        double A[9][8] = {{0}}, F[2][9];
        for (int i = 0; i < 7; ++i)
        {
            const double x1 = p.exact[X1][sample[i]], y1 = p.exact[Y1][sample[i]],
                         x2 = p.exact[X2][sample[i]], y2 = p.exact[Y2][sample[i]];
            const double row[9] = {x2 * x1, x2 * y1, x2, y2 * x1, y2 * y1, y2, x1, y1, 1};
            for (int k = 0; k < 9; ++k)
                A[k][i] = row[k];
        }
        if (!nullSpace<7>(A, F))
            return 0;
        // det(s F1 + t F2) = s^3 det F1 + s^2 t <cof F1, F2> + s t^2 <F1, cof F2> + t^3 det F2
        double c1[9], c2[9];
        cofactors(F[0], c1);
        cofactors(F[1], c2);
        double cubic[4] = {dot9(c2, F[1]) / 3, dot9(c2, F[0]), dot9(c1, F[1]), dot9(c1, F[0]) / 3};
        // the ratio whose cubic has the larger leading coefficient, so that no root is at infinity
        int s = 0, t = 1;
        if (std::abs(cubic[0]) > std::abs(cubic[3]))
        {
            std::swap(cubic[0], cubic[3]);
            std::swap(cubic[1], cubic[2]);
            std::swap(s, t);
        }
        double roots[MAX_DEGREE];
        const int count = realRoots(cubic, 3, roots);
        int found = 0;
        for (int r = 0; r < count; ++r)
        {
            double squares = 0;
            Matx33d root;
            for (int i = 0; i < 9; ++i)
            {
                root.val[i] = roots[r] * F[s][i] + F[t][i];
                squares += root.val[i] * root.val[i];
            }
            if (!(squares > 0 && squares <= DBL_MAX))
                continue;
            models[found] = root * (1 / std::sqrt(squares));
            double c[9];
            cofactors(models[found].val, c);
            found += dot9(c, c) >
                     LEAST_RATIO * LEAST_RATIO;  // norm: product of the singular values
        }
        return found;
    }
};

}  // namespace

Ptr<MinimalSolver> createFundamental7Solver() { return makePtr<Fundamental7Solver>(); }

}  // namespace usacv20
}  // namespace cv
