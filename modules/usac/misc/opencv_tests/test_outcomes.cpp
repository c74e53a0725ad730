// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Tests of reading the list of differences (class Outcomes). The list can contain these tests, too.

#include "outcomes.hpp"
#include <cstdio>
#include <fstream>
#include "opencv2/core/version.hpp"
#include "versions.hpp"

namespace {

TEST(Usac_Differences, versions)
{
    EXPECT_TRUE(isForVersion("", "4.6.0"));
    const char* const versions[] = {"3.4.20",     "4.6.0",  "4.9.1", "4.10.0",
                                    "4.10.1-dev", "4.11.0", "5.0.0"};
    for (int i = 0; i < 7; ++i)
    {
        EXPECT_EQ(i >= 3, isForVersion(">=4.10", versions[i])) << versions[i];
        EXPECT_EQ(i < 3, isForVersion("<4.10", versions[i])) << versions[i];
        EXPECT_EQ(i >= 1, isForVersion(">=4.6.0", versions[i])) << versions[i];
        EXPECT_EQ(i < 2, isForVersion("<4.9", versions[i])) << versions[i];
    }
    EXPECT_TRUE(isForVersion(">=4.6", CV_VERSION)) << "the module needs OpenCV 4.6 or later";
    const char* const mistakes[] = {"4.10", "=4.10", ">4.10",      ">=",    "<",
                                    ">=4",  "<4.x",  ">=4.10-dev", "<=4.10"};
    for (const char* mistake : mistakes)
        EXPECT_THROW(isForVersion(mistake, "4.10.0"), cv::Exception) << mistake;
}

//! The reason that a list with these lines gives for the failure of a test; "refused" if the lines
//! are invalid.
std::string reasonOf(const std::string& lines, const std::string& flag, const std::string& test)
{
    const std::string path = cv::tempfile(".txt");
    std::ofstream(path.c_str()) << lines;
    std::string reason;
    try
    {
        reason = Outcomes(path).reason(flag, test);
    }
    catch (const cv::Exception&)
    {
        reason = "refused";
    }
    std::remove(path.c_str());
    return reason;
}

TEST(Usac_Differences, lines)
{
    const std::string lines = "# fails * A.b comment\n"
                              "fails * A.all why\n"
                              "fails USACV20,USACV20_FAST A.some so\n  and so on\n"
                              "fails>=4.6 * A.now yes\n"
                              "fails<4.6 * A.before no\n";
    EXPECT_EQ("why", reasonOf(lines, "USACV20_MAGSAC", "A.all"));
    EXPECT_EQ("so and so on", reasonOf(lines, "USACV20_FAST", "A.some"));
    EXPECT_EQ("", reasonOf(lines, "USACV20_MAGSAC", "A.some"));
    EXPECT_EQ("yes", reasonOf(lines, "USACV20", "A.now"));
    EXPECT_EQ("", reasonOf(lines, "USACV20", "A.before"));
    EXPECT_EQ("", reasonOf(lines, "USACV20", "A.b"));
    const char* const mistakes[] = {
        "fails * A.b",      "fail * A.b why",           "fails NOFLAG A.b why",
        "fails= * A.b why", "fails<4.6 NOFLAG A.b why", "data>=x file A.b why"};
    for (const char* mistake : mistakes)
        EXPECT_EQ("refused", reasonOf(mistake, "USACV20", "A.b")) << mistake;
}

//! A line about a test that this version of OpenCV does not have must be reported, since it would
//! have no effect otherwise.
TEST(Usac_Differences, everyTestIsThere)
{
    const std::string path = cv::tempfile(".txt");
    std::ofstream(path.c_str())
        << "fails * Usac_Differences.lines is there\nfails * Usac_Differences.gone is not\n"
           "fails<4.6 * Usac_Differences.goneToo is not for this version\n"
           "data file Usac_Differences.without is not\n";
    const std::vector<std::string> missing = Outcomes(path).missingTests();
    std::remove(path.c_str());
    ASSERT_EQ(2u, missing.size());
    EXPECT_EQ("Usac_Differences.gone", missing[0]);
    EXPECT_EQ("Usac_Differences.without", missing[1]);
}

}  // namespace
