// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Included by arcs.inl.hpp, once for each instruction set, and by PlaneParallax.

#include <cmath>
#include "scoring/kernels.hpp"

namespace cv {
namespace usacv20 {
namespace {

/* Position of the point u + t v on a line, t = s / c, as a number that increases with t and needs
no arc tangent: t itself if |t| <= 1, else 2 - 1 / t. -1 and 3 are the same point: the projective
line is closed. */
inline float placeOf(float s, float c)
{
    const bool small = fabsf(s) <= fabsf(c);
    const float ratio = (small ? s : c) / (small ? c : s);
    return small ? ratio : 2.f - ratio;
}

//! Bin of a result of placeOf(); the first bin for NaN.
inline int binOf(float place)
{
    const float bin = (place + 1) * (0.25f * ARCS_BINS);
    const float low = bin > 0 ? bin : 0.f, last = (float)(ARCS_BINS - 1);
    return (int)(low < last ? low : last);
}

}  // namespace
}  // namespace usacv20
}  // namespace cv
