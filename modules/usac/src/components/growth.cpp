// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/growth.hpp"

namespace cv {
namespace usacv20 {

//! T_N of PROSAC, see Growth: about the number of samples after which the set of the best points
//! contains all points @cite chum2005matching. The larger T_N is, the more slowly the set grows.
//! See doc/constants.md.
constexpr double UNIFORM_SAMPLES = 200000;

Growth::Growth(int sampleSize, int pointCount)
    : m(sampleSize), n(sampleSize), expected(UNIFORM_SAMPLES), limit(1)
{
    double share = 1;  // fraction of the uniform samples that lie within the m best points
    for (int i = 0; i < m; ++i)
        share *= (double)(m - i) / (pointCount - i);
    expected = std::min(expected * share, 1.);
}

void Growth::grow()
{
    const double grown = expected * (n + 1) / (n + 1 - m);
    ++n;
    limit += std::ceil(grown - expected);
    expected = grown;
}

void GrowingSet::next()
{
    ++drawn;
    if (drawn > growth.samples() && growth.size() < total)
        growth.grow();
}

}  // namespace usacv20
}  // namespace cv
