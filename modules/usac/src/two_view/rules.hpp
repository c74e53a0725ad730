// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RULES_HPP
#define OPENCV_USACV20_RULES_HPP

namespace cv {
namespace usacv20 {

//! Samples. Those of a right sample are not always a good one: its points may be near to each
//! other. That many cost less than 2 ms.
enum { LEAST_SAMPLES = 500 };

}  // namespace usacv20
}  // namespace cv

#endif
