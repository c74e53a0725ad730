// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "scoring/scores.hpp"
#include "numeric/chi_square.hpp"
#include "scoring/mixture.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! A point counts as a certain outlier if its density as an inlier is below this multiple of its
//! density as an outlier.
constexpr double NEGLIGIBLE = 1e-6;
//! Number of likelihoods that are multiplied before a logarithm is taken. A product of 4 floats
//! does not overflow a double.
constexpr int GROUP = 4;

/** MLESAC @cite torr2000mlesac: likelihood under a mixture of inliers and outliers. Inliers have
Gaussian noise with sigma = threshold / thresholdInSigmas(); outliers are uniformly distributed over
the area of the points (Problem::outlierExtent). Let q be the density of an inlier at an error of 0
divided by that of an outlier. Then the log-likelihood of a point, relative to that of an outlier,
is

    l = log(gamma q exp(-error^2 / (2 sigma^2)) + 1 - gamma),

where the inlier ratio gamma is found for each model by expectation maximization. The cost is the
sum of 1 - l / log(q) over the points: 0 if all errors are 0, and at most the number of points,
which is the cost for gamma = 0.

There is one pass over all points, with an exponential for each point near the model, and then
several passes over the points near the model. All points except the certain outliers (see
NEGLIGIBLE) are called near. */
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
            if (error < reach)  // NaN is not near the model
                squaredErrors[near++] = (float)std::min(std::exp(logRatio + factor * error),
                                                        (double)FLT_MAX);
        }
        const double gamma = mixingWeight(squaredErrors, near, count);
        double likelihood = near < count ? (count - near) * std::log1p(-gamma) : 0;
        for (int i = 0; i < near;
             i += GROUP)  // one logarithm for each group, because logarithms are slow
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
