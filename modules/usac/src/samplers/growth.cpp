// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "samplers/growth.hpp"

namespace cv {
namespace usacv20 {

GrowingSet::GrowingSet(int sampleSize, int pointCount)
    : m(sampleSize), total(pointCount), n(sampleSize), expected(200000), limit(1), drawn(0)
{
    double share = 1;  // of the samples that lie within the m best points
    for (int i = 0; i < m; ++i)
        share *= (double)(m - i) / (total - i);
    expected = std::min(expected * share, 1.);
}

void GrowingSet::next()
{
    ++drawn;
    if (drawn > limit && n < total)
    {
        const double grown = expected * (n + 1) / (n + 1 - m);
        ++n;
        limit += std::ceil(grown - expected);
        expected = grown;
    }
}

} // namespace usacv20
} // namespace cv
