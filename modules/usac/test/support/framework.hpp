// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_FRAMEWORK_HPP
#define OPENCV_USACV20_TEST_FRAMEWORK_HPP

// The test framework. Inside OpenCV it is OpenCV's module `ts`. An installed OpenCV has no `ts`;
// there it is GoogleTest of the system with the few parts of `ts` that the tests use
// (USAC_SYSTEM_GTEST).

#ifndef USAC_SYSTEM_GTEST

#include "opencv2/ts.hpp"

//! Ends the test as skipped because it cannot run here; only in functions that return void.
#define USAC_SKIP(reason) throw SkipTestException(reason)

#else

#include "opencv2/core.hpp"
#include <gtest/gtest.h>

namespace cvtest {

//! Level of debug output, by default 0. With `--test_debug=1` it is 1, and the tests print what
//! they have measured.
extern int debugLevel;

//! Returns true if `--test_tag_enable=verylong` asks for the tests that take minutes.
bool runsVeryLong();

using cv::norm;

}  // namespace cvtest

namespace opencv_test {
using namespace cvtest;
using namespace cv;
}  // namespace opencv_test

#define USAC_SKIP(reason) GTEST_SKIP() << (reason)
#define CV_TEST_TAG_VERYLONG "verylong"
#define applyTestTag(tag)                                                                          \
    do                                                                                             \
        if (!cvtest::runsVeryLong())                                                               \
            USAC_SKIP(tag);                                                                        \
    while (0)

// OpenCV's GoogleTest has only the old name; newer GoogleTests deprecate it, and clang++ warns.
#undef INSTANTIATE_TEST_CASE_P
#define INSTANTIATE_TEST_CASE_P INSTANTIATE_TEST_SUITE_P

#endif

#endif
