// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLES_TUKEY_SCORE_HPP
#define OPENCV_USACV20_SAMPLES_TUKEY_SCORE_HPP

#include <algorithm>
#include "opencv2/usac.hpp"

namespace custom {

/** Tukey's biweight: the cost of a point is 1 - (1 - e^2 / t^2)^3 for an error e within the threshold t, 1 outside. It
rises faster than MSAC's e^2 / t^2, so that a few exact points are worth more than many that are just within the
threshold. */
class TukeyScore : public cv::usacv20::Score
{
public:
    void accumulate(float* squaredErrors, int count, float squaredThreshold,
                    cv::usacv20::Quality& sum) const CV_OVERRIDE
    {
        Sums sums;
        int i = 0;
        for (; i + LANES <= count; i += LANES)
            for (int k = 0; k < LANES; ++k)
                sums.add(k, squaredErrors[i + k], squaredThreshold);
        for (int k = 0; i < count; ++i, ++k)
            sums.add(k, squaredErrors[i], squaredThreshold);
        sums.addTo(sum);
    }

    //! For Sampson's distance, the residual of F and E, the same without the array of errors between.
    cv::usacv20::FusedKernel fused(const cv::usacv20::Residual& residual) const CV_OVERRIDE
    {
        return residual.kind() == cv::usacv20::Residual::SAMPSON ? sampsonKernel : 0;
    }

private:
    //! Sums in so many parts, of which a compiler makes vector code.
    enum { LANES = 16 };

    struct Sums
    {
        Sums() : cost(), inliers() {}
        void add(int lane, float squaredError, float squaredThreshold)
        {
            const float part = squaredError / squaredThreshold, rest = part < 1 ? 1 - part : 0;  // 0 for NaN
            cost[lane] += 1 - rest * rest * rest;
            inliers[lane] += squaredError <= squaredThreshold;
        }
        void addTo(cv::usacv20::Quality& sum) const
        {
            for (int k = 0; k < LANES; ++k)
            {
                sum.cost += cost[k];
                sum.inliers += inliers[k];
            }
        }
        float cost[LANES];
        int inliers[LANES];
    };

    static float sampson(const float* F, float x1, float y1, float x2, float y2)
    {
        const float a = F[0] * x1 + F[1] * y1 + F[2], b = F[3] * x1 + F[4] * y1 + F[5];
        const float d = F[0] * x2 + F[3] * y2 + F[6], e = F[1] * x2 + F[4] * y2 + F[7];
        const float r = x2 * a + y2 * b + (F[6] * x1 + F[7] * y1 + F[8]);
        return r * r / (a * a + b * b + d * d + e * e);
    }

    static void sampsonKernel(const cv::usacv20::Correspondences& points, const float* model, float squaredThreshold,
                              int begin, int end, cv::usacv20::Quality& sum)
    {
        using namespace cv::usacv20;
        const float *x1 = points.column[X1], *y1 = points.column[Y1], *x2 = points.column[X2], *y2 = points.column[Y2];
        float F[9];
        std::copy(model, model + 9, F);
        Sums sums;
        int i = begin;
        for (; i + LANES <= end; i += LANES)
            for (int k = 0; k < LANES; ++k)
                sums.add(k, sampson(F, x1[i + k], y1[i + k], x2[i + k], y2[i + k]), squaredThreshold);
        for (int k = 0; i < end; ++i, ++k)
            sums.add(k, sampson(F, x1[i], y1[i], x2[i], y2[i]), squaredThreshold);
        sums.addTo(sum);
    }
};

}  // namespace custom

#endif
