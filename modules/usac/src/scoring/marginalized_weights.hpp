// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_MARGINALIZED_WEIGHTS_HPP
#define OPENCV_USACV20_MARGINALIZED_WEIGHTS_HPP

#include <cmath>
#include "opencv2/usac/params.hpp"

namespace cv {
namespace usacv20 {

//! Between the entries of a table, to both sides of a position >= 0; one entry more than there are
//! cells.
inline float lookUp(const float* table, float position)
{
    const int cell = (int)position;
    return table[cell] + (position - cell) * (table[cell + 1] - table[cell]);
}

//! Moves the errors up to a limit to the front, without a branch. @return their number; NaN is not
//! among them
int keepInliers(float* squaredErrors, int count, float squaredThreshold);

//! Of errors that are numbers.
inline int countWithin(const float* squaredErrors, int count, float squaredThreshold)
{
    int within = 0;
    for (int i = 0; i < count; ++i)
        within += squaredErrors[i] <= squaredThreshold;
    return within;
}

//! Sum of the values at `count` positions. Four sums side by side, so that no addition waits for
//! the one before.
double sumOfLookUps(const float* table, const float* positions, int count);

/** @brief Weights and loss of MAGSAC++ @cite barath2020magsac.

The error r of an inlier is distributed as sigma times chi with n degrees of freedom, cut off at k
sigma (thresholdInSigmas); sigma is uniform in 0 .. sigma_max. The weight of a point is its
likelihood, marginalized over sigma: the integral of sigma^-n r^(n-1) exp(-r^2 / (2 sigma^2)) over
sigma = r/k .. sigma_max. With a = (n - 1)/2, x = r^2 / (2 sigma_max^2), K = k^2/2 and the upper
incomplete gamma function G this is proportional to

    G(a, x) - G(a, K),

and the loss whose re-weighted least squares have these weights, its integral over x, to

    x (G(a, x) - G(a, K)) + g(a + 1, x)

with the lower function g. Both take u = x/K, the squared error in units of the squared threshold.
The loss is scaled to 1 at u = 1, and the weight is its derivative by u. For n = 1 the weight grows
with -log(u) towards u = 0; it is kept where it is at u = 1/2048, for errors below 1/45 of the
threshold.

The tables have 2048 cells of equal length, in u for the loss and in the root of u for the weight,
and linear interpolation. Errors are below 1e-3, those of the weight relative to it. */
class MarginalizedWeights
{
public:
    //! Cells of the tables; below u = 1/SIZE the weight is constant. Half, double: errors within 1
    //! %.
    enum { SIZE = 2048 };

    //! Those of errors of so many degrees of freedom, made at first use.
    static const MarginalizedWeights& of(int degrees);

    explicit MarginalizedWeights(int degrees);

    //! By the formulas.
    double loss(double u) const;
    double weight(double u) const;

    //! From the tables. 0 <= u, also infinite; NaN is taken as infinite.
    float tabulatedLoss(float u) const { return interpolate(losses, u < 1 ? u : 1.f); }
    float tabulatedWeight(float u) const { return interpolate(weights, sqrtf(u < 1 ? u : 1.f)); }
    //! Sum of tabulatedLoss(u[i]); u is changed.
    double sumOfLosses(float* u, int count) const;

private:
    static float interpolate(const float* table, float at)
    {
        return lookUp(table, at * (float)SIZE);
    }

    double a, K, scale, atEnd;
    float losses[SIZE + 2], weights[SIZE + 2];
};

}  // namespace usacv20
}  // namespace cv

#endif
