// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_PRECOMP_HPP
#define OPENCV_USACV20_TEST_PRECOMP_HPP

#include "support/framework.hpp"
#include "opencv2/usac/geometry.hpp"
#include "opencv2/usac.hpp"
#include "support/problem_lists.hpp"
#include "support/scenes.hpp"

namespace opencv_test {
using namespace cv::usacv20;

//! A list as a matrix with one element per row. With OpenCV 5, Mat(list) would have only one
//! dimension.
template <typename Element>
Mat column(const std::vector<Element>& list)
{
    return Mat((int)list.size(), 1, traits::Type<Element>::value, (void*)list.data());
}
}

#endif
