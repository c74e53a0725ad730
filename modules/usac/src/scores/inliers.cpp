// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "residuals/kernels.hpp"
#include "scores/scores.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Number of inliers @cite fischler1981random. The cost of a point is 0 within the threshold, else 1; the errors
themselves are not used. One pass over the points, fused with the residual. */
class InlierScore : public Score
{
public:
    void accumulate(float* squaredErrors, int count, float squaredThreshold, Quality& sum) const CV_OVERRIDE
    {
        for (int i = 0; i < count; ++i)
        {
            const bool inlier = squaredErrors[i] <= squaredThreshold;
            sum.inliers += inlier;
            sum.cost += !inlier;
        }
    }

    FusedKernel fused(const Residual& residual) const CV_OVERRIDE
    {
        return residual.kind() == Residual::CUSTOM ? 0 : kernels().inliers[residual.kind()];
    }
};

}  // namespace

Ptr<Score> createInlierScore() { return makePtr<InlierScore>(); }

}  // namespace usacv20
}  // namespace cv
