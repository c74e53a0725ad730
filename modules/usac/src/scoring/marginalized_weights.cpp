// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/chi_square.hpp"
#include "numeric/gamma.hpp"
#include "scoring/marginalized_weights.hpp"

namespace cv {
namespace usacv20 {

int keepInliers(float* squaredErrors, int count, float squaredThreshold)
{
    int kept = 0;
    for (int i = 0; i < count; ++i)
    {
        const float error = squaredErrors[i];
        squaredErrors[kept] = error;
        kept += error <= squaredThreshold ? 1 : 0;
    }
    return kept;
}

double sumOfLookUps(const float* table, const float* positions, int count)
{
    double sums[4] = {0, 0, 0, 0};
    int i = 0;
    for (; i + 4 <= count; i += 4)
        for (int k = 0; k < 4; ++k)
            sums[k] += lookUp(table, positions[i + k]);
    for (; i < count; ++i)
        sums[0] += lookUp(table, positions[i]);
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

double MarginalizedWeights::sumOfLosses(float* u, int count) const
{
    for (int i = 0; i < count; ++i)
        u[i] = (u[i] < 1 ? u[i] : 1.f) * (float)SIZE;
    return sumOfLookUps(losses, u, count);
}

const MarginalizedWeights& MarginalizedWeights::of(int degrees)
{
    static const MarginalizedWeights one(1), two(2), three(3);
    return degrees == 1 ? one : degrees == 2 ? two : three;
}

MarginalizedWeights::MarginalizedWeights(int degrees) : a(0.5 * (degrees - 1))
{
    const double k = thresholdInSigmas(degrees);
    K = 0.5 * k * k;
    scale = 1 / lowerGamma(a + 1, K);
    atEnd = upperGamma(a, K);
    for (int i = 0; i < SIZE + 2; ++i)  // interpolation multiplies the last entry by 0
    {
        const double at = (double)i / (int)SIZE;
        losses[i] = (float)loss(at);
        weights[i] = (float)weight(at * at);
    }
}

double MarginalizedWeights::loss(double u) const
{
    if (u <= 0)
        return 0;
    if (!(u < 1))
        return 1;
    const double x = u * K;
    return scale * (x * (upperGamma(a, x) - atEnd) + lowerGamma(a + 1, x));
}

double MarginalizedWeights::weight(double u) const
{
    if (!(u < 1))
        return 0;
    return scale * K * (upperGamma(a, std::max(u, 1.0 / (int)SIZE) * K) - atEnd);
}

}  // namespace usacv20
}  // namespace cv
