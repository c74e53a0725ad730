// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "outcomes.hpp"

int main(int argc, char** argv)
{
    cvtest::TS::ptr()->init("");
    testing::InitGoogleTest(&argc, argv);
    Outcomes* const outcomes = new Outcomes(USAC_DIFFERENCES);
    testing::UnitTest::GetInstance()->listeners().Append(outcomes);  // GoogleTest deletes outcomes
    const std::string missing = outcomes->withoutData();
    std::string& filter = testing::GTEST_FLAG(filter);
    if (!missing.empty())
        filter += (filter.find('-') == std::string::npos ? "-" : ":") + missing;
    testing::GTEST_FLAG(repeat) = Outcomes::flags();
    cvtest::parseCustomOptions(argc, argv);
    const int result = RUN_ALL_TESTS();  // 1 even if all failures are expected
    return outcomes->good() ? 0 : std::max(result, 1);
}
