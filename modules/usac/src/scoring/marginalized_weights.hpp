// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_MARGINALIZED_WEIGHTS_HPP
#define OPENCV_USACV20_MARGINALIZED_WEIGHTS_HPP

#include <cmath>
#include "opencv2/usac/params.hpp"

namespace cv {
namespace usacv20 {

//! Interpolates linearly in a table at a position >= 0, where 1 is the length of a cell. A table
//! with n cells must have n + 1 entries, or n + 2 if the position n occurs.
inline float lookUp(const float* table, float position)
{
    const int cell = (int)position;
    return table[cell] + (position - cell) * (table[cell + 1] - table[cell]);
}

//! Moves the errors within the threshold to the front of the array, without branches in the loop.
//! NaN is not within the threshold. @return number of these errors
int keepInliers(float* squaredErrors, int count, float squaredThreshold);

//! Number of errors within the threshold.
inline int countWithin(const float* squaredErrors, int count, float squaredThreshold)
{
    int within = 0;
    for (int i = 0; i < count; ++i)
        within += squaredErrors[i] <= squaredThreshold;
    return within;
}

//! Sum of the interpolated values at `count` positions. There are four partial sums, so that an
//! addition does not have to wait for the result of the previous addition.
double sumOfLookUps(const float* table, const float* positions, int count);

/** @brief Weights and loss of MAGSAC++ @cite barath2020magsac.

The error r of an inlier is distributed as sigma times chi with n degrees of freedom, cut off at k
sigma (k = thresholdInSigmas()); sigma is uniformly distributed in 0 .. sigma_max. The weight of a
point is its likelihood as an inlier, marginalized over sigma: the integral of sigma^-n r^(n-1)
exp(-r^2 / (2 sigma^2)) over sigma = r/k .. sigma_max. With a = (n - 1)/2, x = r^2 / (2
sigma_max^2), K = k^2/2 and the upper incomplete gamma function G, the weight is proportional to

    G(a, x) - G(a, K).

Iteratively re-weighted least squares with these weights minimizes a loss, the integral of the
weight over x, which is proportional to

    x (G(a, x) - G(a, K)) + g(a + 1, x)

with the lower incomplete gamma function g. Weight and loss are functions of u = x/K, the squared
error in units of the squared threshold. The loss is scaled to 1 at u = 1, and the weight is its
derivative with respect to u. For u >= 1, the loss is 1 and the weight is 0. For n = 1 the weight
grows like -log(u) toward u = 0. Therefore, for any n, the weight is constant below u = 1/2048, that
is, for errors below 1/45 of the threshold.

The tables have 2048 cells of equal length, in u for the loss and in sqrt(u) for the weight, with
linear interpolation. The interpolation error is below 1e-3: absolute for the loss, relative for the
weight. */
class MarginalizedWeights
{
public:
    //! Number of cells of the tables; below u = 1/SIZE the weight is constant. See
    //! doc/constants.md.
    enum { SIZE = 2048 };

    //! The instance for errors with 1, 2 or 3 degrees of freedom, created at the first call.
    static const MarginalizedWeights& of(int degrees);

    explicit MarginalizedWeights(int degrees);

    //! Loss and weight by the formulas above.
    double loss(double u) const;
    double weight(double u) const;

    //! Loss and weight from the tables. u >= 0 may be infinite; NaN is treated as infinite.
    float tabulatedLoss(float u) const { return interpolate(losses, u < 1 ? u : 1.f); }
    float tabulatedWeight(float u) const { return interpolate(weights, sqrtf(u < 1 ? u : 1.f)); }
    //! Sum of tabulatedLoss(u[i]); overwrites u.
    double sumOfLosses(float* u, int count) const;

private:
    static float interpolate(const float* table, float at)
    {
        return lookUp(table, at * (float)SIZE);
    }

    double a, K, scale, atEnd;  //!< a and K as above; factor of the loss; G(a, K)
    float losses[SIZE + 2], weights[SIZE + 2];
};

}  // namespace usacv20
}  // namespace cv

#endif
