// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_FUZZ_RIGID_HPP
#define OPENCV_USACV20_TEST_FUZZ_RIGID_HPP

#include "fuzz/fuzz_bytes.hpp"
#include "fuzz/fuzz_input.hpp"

namespace opencv_test {

//! Reads pairs of 3-D points. In most inputs, some of the pairs come from a scene.
void readSpacePoints(Bytes& bytes, FuzzInput& input);

}  // namespace opencv_test

#endif
