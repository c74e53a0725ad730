// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_OUTCOMES_HPP
#define OPENCV_USACV20_OUTCOMES_HPP

#include <map>
#include <set>
#include <vector>
#include "opencv2/ts.hpp"

/** Sets another flag of the module in each repetition of all tests, compares the outcomes with the
list of expected differences, and counts the passed and failed tests.

Only tests that call one of the redirected functions (exchange.hpp) count, and the tests of the list
itself (test_outcomes.cpp). A test that fails with a flag for which the list expects a failure
counts neither as passed nor as failed. To keep the list up to date, two more things count as
failures: a test that passes although the list expects a failure, and an entry of the list for a
test that does not exist. */
class Outcomes : public testing::EmptyTestEventListener
{
public:
    //! Reads the list; its first lines explain the format.
    explicit Outcomes(const std::string& listOfDifferences);

    static int flags();  //!< number of flags of the module

    //! A GoogleTest pattern of the tests whose data files are missing; empty if no file is missing.
    std::string withoutData();

    //! The reason why a test is expected to fail with a flag; empty if it must pass.
    std::string reason(const std::string& flag, const std::string& test) const;

    //! Tests on the list that this program does not have, in alphabetical order.
    std::vector<std::string> missingTests() const;

    bool good() const { return passed > 0 && failed == 0; }

    virtual void OnTestProgramStart(const testing::UnitTest&) CV_OVERRIDE;
    virtual void OnTestIterationStart(const testing::UnitTest&, int iteration) CV_OVERRIDE;
    virtual void OnTestStart(const testing::TestInfo& test) CV_OVERRIDE;
    virtual void OnTestEnd(const testing::TestInfo& test) CV_OVERRIDE;
    virtual void OnTestProgramEnd(const testing::UnitTest&) CV_OVERRIDE;

private:
    typedef std::pair<std::string, std::string> Pair;  // (flag or data file, test)

    std::map<Pair, std::string> fails, data;  // reason of each pair
    std::set<std::string> notOurs;            // tests that call none of the redirected functions
    std::string flag, expected, unexpected;   // current flag, and two texts printed at the end
    int passed, failed;
};

#endif
