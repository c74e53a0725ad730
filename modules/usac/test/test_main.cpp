// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

#ifndef USAC_SYSTEM_GTEST

CV_TEST_MAIN("cv")

#else

namespace cvtest {

int debugLevel = 0;

namespace {
bool veryLong = false;
}

bool runsVeryLong() { return veryLong; }

}  // namespace cvtest

//! Reads GoogleTest's options and those options of OpenCV's module `ts` that the tests use.
int main(int argc, char** argv)
{
    testing::InitGoogleTest(&argc, argv);
    const cv::CommandLineParser options(argc, argv, "{test_debug|0|}{test_tag_enable||}");
    cvtest::debugLevel = options.get<int>("test_debug");
    cvtest::veryLong = options.get<std::string>("test_tag_enable") == CV_TEST_TAG_VERYLONG;
    return RUN_ALL_TESTS();
}

#endif
