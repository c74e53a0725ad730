// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "residual/kernels.hpp"
#include "scoring/scores.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** MSAC @cite torr2000mlesac: the cost of a point is min(error^2 / threshold^2, 1). Errors and
score are computed in one pass over the points (Score::fused). */
class MsacScore : public Score
{
public:
    void accumulate(float* squaredErrors, int count, float squaredThreshold,
                    Quality& sum) const CV_OVERRIDE
    {
        const float scale = 1 / squaredThreshold;
        for (int i = 0; i < count; ++i)
        {
            sum.inliers += squaredErrors[i] <= squaredThreshold;
            sum.cost += msacCost(squaredErrors[i], scale);
        }
    }

    FusedKernel fused(const Residual& residual) const CV_OVERRIDE
    {
        return residual.kernels() ? residual.kernels()->msac : 0;
    }
};

}  // namespace

Ptr<Score> createMsacScore() { return makePtr<MsacScore>(); }

}  // namespace usacv20
}  // namespace cv
