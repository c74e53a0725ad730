// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_FRAMEWORK_HPP
#define OPENCV_USACV20_TEST_FRAMEWORK_HPP

// The test framework. Inside OpenCV, the tests use OpenCV's module `ts`. An installed OpenCV has no
// `ts`. Tests are then built with the GoogleTest of the system (USAC_SYSTEM_GTEST), and this file
// defines the few parts of `ts` that they use.

#ifndef USAC_SYSTEM_GTEST

#include "opencv2/ts.hpp"

//! Skips the rest of a test that cannot run here. To be used only in functions that return void.
#define USAC_SKIP(reason) throw SkipTestException(reason)

#else

#include "opencv2/core.hpp"
#include <gtest/gtest.h>

namespace cvtest {

//! Level of debug output, 0 by default. `--test_debug=1` sets it to 1, so that the tests print what
//! they have measured.
extern int debugLevel;

//! Returns true if `--test_tag_enable=verylong` enables the tests that take minutes or hours.
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

// The GoogleTest of OpenCV has only the old name of this macro. Newer versions of GoogleTest
// deprecate the old name, and clang++ warns about it.
#undef INSTANTIATE_TEST_CASE_P
#define INSTANTIATE_TEST_CASE_P INSTANTIATE_TEST_SUITE_P

#endif

#endif
