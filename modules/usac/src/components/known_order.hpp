// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_KNOWN_ORDER_HPP
#define OPENCV_USACV20_KNOWN_ORDER_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! True if the order of the points is given, by scores or by the caller; false if it is guessed.
inline bool orderIsKnown(const Context& context)
{
    const Ptr<Ordering>& ordering = context.components.ordering;
    return ordering && ordering->informative(context);
}

}  // namespace usacv20
}  // namespace cv

#endif
