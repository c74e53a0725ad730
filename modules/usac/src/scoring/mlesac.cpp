// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "scoring/scores.hpp"
#include "core/chi_square.hpp"
#include "scoring/mixture.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Points that are less than so many times as likely as inliers than as outliers count as outliers.
//! Half, double: no run of the lists differs.
constexpr double NEGLIGIBLE = 1e-6;
//! So many factors of any float do not overflow a double.
constexpr int GROUP = 4;

/** MLESAC @cite torr2000mlesac: likelihood under a mixture of inliers, Gaussian with sigma =
threshold / thresholdInSigmas, and outliers, uniform on the area of the points (outlierExtent). With
q the ratio of both densities at an error of 0, the log-likelihood of a point, measured from that of
an outlier, is

    log(gamma q exp(-error^2 / (2 sigma^2)) + 1 - gamma),

where the part gamma of inliers is found for each model by expectation and maximization. The cost is
the sum over the points of 1 - this / log(q): 0 if all errors are 0, and never more than the number
of points, which gamma = 0 has. Points that are less than #NEGLIGIBLE times as likely as inliers
than as outliers count as outliers.

One pass over the points, with an exponential for those near the model, and some short ones over
these. */
class MlesacScore : public Score
{
public:
    MlesacScore() : degrees(1), extent(1) {}

    void start(const Context& context) CV_OVERRIDE
    {
        degrees = context.points.problem->errorDimension();
        extent = context.points.problem->outlierExtent(context.points);
    }

    void accumulate(float* squaredErrors, int count, float squaredThreshold,
                    Quality& sum) const CV_OVERRIDE
    {
        if (count == 0)
            return;
        const double k = thresholdInSigmas(degrees), variance = squaredThreshold / (k * k);
        const double logRatio = degrees * logDensityRatio(extent, std::sqrt(variance), degrees);
        const double factor = -0.5 / variance, reach = (std::log(NEGLIGIBLE) - logRatio) / factor;
        int near = 0;
        for (int i = 0; i < count; ++i)
        {
            const float error = squaredErrors[i];
            sum.inliers += error <= squaredThreshold;
            if (error < reach)  // false for NaN
                squaredErrors[near++] = (float)std::min(std::exp(logRatio + factor * error),
                                                        (double)FLT_MAX);
        }
        const double gamma = mixingWeight(squaredErrors, near, count);
        double likelihood = near < count ? (count - near) * std::log1p(-gamma) : 0;
        for (int i = 0; i < near; i += GROUP)  // logarithms are slow
        {
            double product = 1;
            for (int j = i; j < std::min<int>(i + GROUP, near); ++j)
                product *= 1 + gamma * (squaredErrors[j] - 1);
            likelihood += std::log(product);
        }
        sum.cost += std::min(std::max(count - likelihood / logRatio, 0.0), (double)count);
    }

    bool wholeModel() const CV_OVERRIDE { return true; }

private:
    int degrees;
    double extent;
};

}  // namespace

Ptr<Score> createMlesacScore() { return makePtr<MlesacScore>(); }

}  // namespace usacv20
}  // namespace cv
