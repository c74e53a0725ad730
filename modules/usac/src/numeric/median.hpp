// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_MEDIAN_HPP
#define OPENCV_USACV20_MEDIAN_HPP

#include <algorithm>

namespace cv {
namespace usacv20 {

//! Of an even number of values, the upper median; `count` > 0. Reorders the values.
template <class T>
T median(T* values, int count)
{
    std::nth_element(values, values + count / 2, values + count);
    return values[count / 2];
}

}  // namespace usacv20
}  // namespace cv

#endif
