// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/two_view/two_view.hpp"
#include "problems/two_view/epipole.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Oriented epipolar constraint @cite chum2004epipolar: points in front of both cameras fulfill
[e2]x x2 = s F x1, where e2 is the epipole of image 2 and s is a factor that differs from point to
point but has the same sign for all points. Either sign is possible, because the signs of F and e2
are arbitrary. A model whose own sample violates this constraint is rejected before any other point
is tested. */
class OrientedEpipolar : public Degeneracy
{
public:
    bool validModel(const Context& context, const int* sample, const Model& F) const CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const Vec3d e = epipole2(F);
        int positive = 0;
        const int m = context.components.minimalSolver->sampleSize();
        for (int k = 0; k < m; ++k)
        {
            const int i = sample[k];
            const double x = p.exact[X2][i], y = p.exact[Y2][i];
            // the first two entries of [e]x x2 and F x1 suffice, because the vectors are parallel
            const double a = e[1] - e[2] * y, b = e[2] * x - e[0];
            const double c = F(0, 0) * p.exact[X1][i] + F(0, 1) * p.exact[Y1][i] + F(0, 2);
            const double d = F(1, 0) * p.exact[X1][i] + F(1, 1) * p.exact[Y1][i] + F(1, 2);
            positive += a * c + b * d > 0;
        }
        return positive == 0 || positive == m;
    }
};

}  // namespace

Ptr<Degeneracy> createOrientedEpipolar() { return makePtr<OrientedEpipolar>(); }

}  // namespace usacv20
}  // namespace cv
