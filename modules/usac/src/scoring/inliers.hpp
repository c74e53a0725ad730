// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_INLIERS_HPP
#define OPENCV_USACV20_INLIERS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** Number of inliers @cite fischler1981random. The cost of a point is 0 within the threshold,
else 1. One pass over the points, fused with the residual. */
class InlierScore : public Score
{
public:
    void accumulate(float* squaredErrors, int count, float squaredThreshold,
                    Quality& sum) const CV_OVERRIDE;
    FusedKernel fused(const Residual& residual) const CV_OVERRIDE;
    bool countsInliers() const CV_OVERRIDE { return true; }
};

}  // namespace usacv20
}  // namespace cv

#endif
