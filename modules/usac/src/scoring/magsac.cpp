// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "scoring/scores.hpp"
#include "core/chi_square.hpp"
#include "scoring/marginalized_weights.hpp"
#include "scoring/mixture.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Cells of the table. Half, double: the same.
constexpr int SIZE = 1024;

/** MAGSAC @cite barath2019magsac: the log-likelihood of the model, averaged over sigma uniform in 0
.. sigma_max.

Given sigma, points within k sigma (thresholdInSigmas) are inliers, Gaussian; the others are
outliers, uniform on the area of the points (outlierExtent). The log-likelihood of the set is a sum
over its points, and so is its average: for n degrees of freedom, a point with error r adds,
measured from an outlier, the integral over sigma = r/k .. sigma_max of

    n log(extent / (sqrt(2 pi) sigma)) - r^2 / (2 sigma^2).

The density of the inliers is that of the error as a vector. The paper has that of its length r,
which for n = 2 vanishes at 0 and would rate a perfect point worst; for n = 1 they are the same.
With u = r / threshold and L = logDensityRatio(sigma_max) the integral is in closed form, and as a
loss from 0 to 1

    u + (k^2 / (2 n) u (1 - u) - u log(u)) / (1 + L).

It grows strictly, as L is at least k^2 / (2 n), where an inlier at the threshold is as likely as an
outlier. What L divides is tabulated over u with linear interpolation: a root and a look-up for each
inlier. */
class MagsacScore : public Score
{
public:
    MagsacScore(int errorDimension, double reach)
        : degrees(errorDimension), k(thresholdInSigmas(degrees)), part(1 / reach), extent(1),
          bends()
    {
        const double curvature = 0.5 * k * k / degrees;
        for (int i = 1; i < SIZE; ++i)
        {
            const double u = (double)i / SIZE;
            bends[i] = (float)(u * (curvature * (1 - u) - std::log(u)));
        }
    }

    double inlierPart() const CV_OVERRIDE { return part; }

    void start(const Context& context) CV_OVERRIDE
    {
        extent = context.points.problem->outlierExtent(context.points);
    }

    void accumulate(float* squaredErrors, int count, float squaredThreshold,
                    Quality& sum) const CV_OVERRIDE
    {
        const int near = keepInliers(squaredErrors, count, squaredThreshold);
        const float factor = 1 / squaredThreshold;
        double line = 0;
        sum.inliers += countWithin(squaredErrors, near, (float)(part * part) * squaredThreshold);
        for (int i = 0; i < near; ++i)
        {
            const float u = std::min(std::sqrt(squaredErrors[i] * factor), 1.f);
            line += u;
            squaredErrors[i] = u * SIZE;
        }
        const double scale = 1 /
                             (1 + logDensityRatio(extent, std::sqrt((double)squaredThreshold) / k,
                                                  degrees));
        sum.cost += count - near + line + scale * sumOfLookUps(bends, squaredErrors, near);
    }

private:
    const int degrees;
    const double k, part;
    double extent;
    float bends[SIZE + 2];
};

}  // namespace

Ptr<Score> createMagsacScore(int errorDimension, double reach)
{
    return makePtr<MagsacScore>(errorDimension, reach);
}

}  // namespace usacv20
}  // namespace cv
