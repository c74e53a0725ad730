// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "scoring/scores.hpp"
#include "numeric/chi_square.hpp"
#include "scoring/marginalized_weights.hpp"
#include "scoring/mixture.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Number of cells of the table over u = error / threshold, see MagsacScore.
constexpr int SIZE = 1024;

/** MAGSAC @cite barath2019magsac: the log-likelihood of the model, averaged over the noise level
sigma, which is uniformly distributed in 0 .. sigma_max, where k sigma_max is the threshold
(k = thresholdInSigmas()).

Given sigma, points with errors up to k sigma are inliers with Gaussian noise; the other points are
outliers, uniformly distributed over the area of the points (Problem::outlierExtent). The
log-likelihood of all points is a sum over the points, and so is its average. For n degrees of
freedom, a point with error r contributes, relative to an outlier, the integral over
sigma = r/k .. sigma_max of

    n log(extent / (sqrt(2 pi) sigma)) - r^2 / (2 sigma^2).

The density of the inliers is that of the error vector. The paper uses the density of the length r
of this vector. For n = 2, the density of the length vanishes at 0, so that a point without error
would get the worst score; for n = 1, the two densities differ only by a factor of 2.

With u = r / threshold and L = logDensityRatio(sigma_max) the integral has a closed form. Scaled to
a loss from 0 to 1 it is

    u + (k^2 / (2 n) u (1 - u) - u log(u)) / (1 + L).

The loss increases strictly with u, because L is at least k^2 / (2 n), the value for which an inlier
at the threshold is as likely as an outlier. The numerator of the fraction is tabulated over u and
interpolated linearly, which takes a square root and a table lookup for each point within the
threshold. For points beyond it, the loss is 1. */
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
    const double k, part;  //!< k: see the comment of the class; part: inlierPart()
    double extent;
    float bends[SIZE + 2];  //!< the numerator of the fraction, tabulated over u
};

}  // namespace

Ptr<Score> createMagsacScore(int errorDimension, double reach)
{
    return makePtr<MagsacScore>(errorDimension, reach);
}

}  // namespace usacv20
}  // namespace cv
