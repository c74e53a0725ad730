// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Included by arcs.inl.hpp, once for each instruction set, and by PlaneParallax.

#include <cmath>
#include "scoring/kernels.hpp"

namespace cv {
namespace usacv20 {
namespace {

/* The place u + t v of a line as a number that grows with t and needs no arc tangent: t = s / c
itself up to 1, beyond that 2 - 1 / t. The circle closes at -1 and 3. */
inline float placeOf(float s, float c)
{
    const bool small = fabsf(s) <= fabsf(c);
    const float ratio = (small ? s : c) / (small ? c : s);
    return small ? ratio : 2.f - ratio;
}

//! NaN is in the first bin.
inline int binOf(float place)
{
    const float bin = (place + 1) * (0.25f * ARCS_BINS);
    const float low = bin > 0 ? bin : 0.f, last = (float)(ARCS_BINS - 1);
    return (int)(low < last ? low : last);
}

}  // namespace
}  // namespace usacv20
}  // namespace cv
