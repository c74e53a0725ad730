// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_FUZZ_CONTRACTS_HPP
#define OPENCV_USACV20_TEST_FUZZ_CONTRACTS_HPP

#include <string>
#include "fuzz/fuzz_input.hpp"

namespace opencv_test {

/** Makes the call twice. Returns a description of the first contract that is broken, or "" if none
is. A call must raise a cv::Exception if and only if an argument is wrong, and the message begins
with the name of an argument. For camera matrices that are nearly singular or have a huge
determinant, an exception is allowed. The input must not change. The result must be either no model,
a zero mask and a reason (Report::stop), or a finite model of the documented norm and rank with
mask == (error <= threshold). Both calls must give the same bits. */
std::string brokenContract(const FuzzInput& input);

}  // namespace opencv_test

#endif
