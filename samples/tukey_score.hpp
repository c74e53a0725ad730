// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLES_TUKEY_SCORE_HPP
#define OPENCV_USACV20_SAMPLES_TUKEY_SCORE_HPP

#include "opencv2/usac.hpp"

namespace custom {

/** Tukey's biweight: the cost of a point is 1 - (1 - e^2 / t^2)^3 for an error e within the
threshold t, and 1 outside. For small errors it rises faster than MSAC's e^2 / t^2, so that a few
accurate points outweigh many points just within the threshold. */
class TukeyScore : public cv::usacv20::Score
{
public:
    void accumulate(float* squaredErrors, int count, float squaredThreshold,
                    cv::usacv20::Quality& sum) const CV_OVERRIDE
    {
        for (int i = 0; i < count; ++i)
        {
            const bool inlier = squaredErrors[i] <= squaredThreshold;  // NaN is an outlier
            const double rest = inlier ? 1 - squaredErrors[i] / squaredThreshold : 0;
            sum.cost += 1 - rest * rest * rest;
            sum.inliers += inlier;
        }
    }
};

}  // namespace custom

#endif
