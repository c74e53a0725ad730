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
    for (int i = 0; i < m; ++i)
        expected *= (double)(m - i) / (total - i);
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
