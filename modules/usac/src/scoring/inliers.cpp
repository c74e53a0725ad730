// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "residual/kernels.hpp"
#include "scoring/scores.hpp"

namespace cv {
namespace usacv20 {

void InlierScore::accumulate(float* squaredErrors, int count, float squaredThreshold,
                             Quality& sum) const
{
    for (int i = 0; i < count; ++i)
    {
        const bool inlier = squaredErrors[i] <= squaredThreshold;
        sum.inliers += inlier;
        sum.cost += !inlier;
    }
}

FusedKernel InlierScore::fused(const Residual& residual) const
{
    return residual.kernels() ? residual.kernels()->inliers : 0;
}

Ptr<Score> createInlierScore() { return makePtr<InlierScore>(); }

}  // namespace usacv20
}  // namespace cv
