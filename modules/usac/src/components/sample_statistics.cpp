// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/tails.hpp"
#include "components/sample_statistics.hpp"

namespace cv {
namespace usacv20 {

double goodSampleProbability(double inliers, int n, int m, bool exact)
{
    double p = 1;
    for (int i = 0; i < m; ++i)
        p *= exact ? std::max(inliers - i, 0.0) / (n - i) : inliers / n;
    return std::min(p, 1.0);
}

int samplesNeeded(double p, double logFailure)
{
    if (!(p > 0))
        return INT_MAX;
    if (p >= 1 || logFailure >= 0)
        return logFailure >= 0 ? 0 : 1;
    const double k = std::ceil(logFailure / std::log1p(-p));
    return k < INT_MAX ? (int)k : INT_MAX;
}

double chanceOf(int inliers, int n, int m, double randomRatio)
{
    if (inliers <= m)
        return 1;
    if (inliers > n || !(randomRatio > 0))
        return 0;
    return randomRatio < 1 ? binomialTail(inliers - m, n - m, randomRatio) : 1;
}

}  // namespace usacv20
}  // namespace cv
