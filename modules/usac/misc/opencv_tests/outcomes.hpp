// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_OUTCOMES_HPP
#define OPENCV_USACV20_OUTCOMES_HPP

#include <map>
#include <set>
#include <vector>
#include "opencv2/ts.hpp"

/** Runs all tests once with each flag of the module, compares what comes out with the list of
differences, and counts.

Only a test that has called one of the exchanged functions counts. One that fails with a flag for
which it is on the list is neither passed nor failed; one that is on the list and passes is a
failure, and so is one that is on the list and not among the tests, so that the list stays true. The
tests of the list itself (test_outcomes.cpp) count, too. */
class Outcomes : public testing::EmptyTestEventListener
{
public:
    //! Reads the list; its first lines say what is in it.
    explicit Outcomes(const std::string& listOfDifferences);

    static int flags();

    //! The pattern of the tests whose data are missing, for the filter; empty if all are there.
    std::string withoutData();

    //! Why a test is expected to fail with a flag; empty: it is not.
    std::string reason(const std::string& flag, const std::string& test) const;

    //! Tests that are on the list and that this program does not have, in alphabetical order.
    std::vector<std::string> missingTests() const;

    bool good() const { return passed > 0 && failed == 0; }

    virtual void OnTestProgramStart(const testing::UnitTest&) CV_OVERRIDE;
    virtual void OnTestIterationStart(const testing::UnitTest&, int iteration) CV_OVERRIDE;
    virtual void OnTestStart(const testing::TestInfo& test) CV_OVERRIDE;
    virtual void OnTestEnd(const testing::TestInfo& test) CV_OVERRIDE;
    virtual void OnTestProgramEnd(const testing::UnitTest&) CV_OVERRIDE;

private:
    typedef std::pair<std::string, std::string> Pair;  // flag or file, test

    std::map<Pair, std::string> fails, data;  // their reasons
    std::set<std::string> notOurs;            // tests that call none of the functions
    std::string flag, expected, unexpected;   // the last two: what is printed at the end
    int passed, failed;
};

#endif
