// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_TALLY_HPP
#define OPENCV_USACV20_BENCHMARK_TALLY_HPP

#include <ostream>
#include <string>
#include <vector>
#include "call.hpp"
#include "judge.hpp"

namespace benchmark {

//! A proportion with Wilson's 95 % confidence interval.
struct Proportion
{
    Proportion(int count, int of);
    //! In percent, as "1.20"; "-" if `of` is 0.
    std::string text() const;

    int of;                   //!< number of cases
    double value, low, high;  //!< the proportion and its interval, 0 .. 1
};

/** Counts of the results of one method on the scenes of one or more cells (see Cell). */
class Tally
{
public:
    Tally();

    void add(const Call& call, const Verdict& verdict);
    //! Adds the counts of a whole cell.
    void add(const Tally& cell);

    //! Proportion of search failures among the calls that did not reach the limit of iterations.
    Proportion failures() const { return Proportion(failed - limitedFailed, calls - limited); }

    int size() const { return calls; }
    bool empty() const { return calls == 0; }

    enum { COLUMNS = 6 };  //!< number of columns in a Markdown table
    static std::string markdownHeader();
    std::string markdown() const;
    //! A table entry: failures() and, after a plus sign, the percentage of calls that reached the
    //! limit of iterations and failed (left out if there are no such calls).
    std::string brief() const;
    static std::string csvHeader();
    std::string csv() const;

private:
    //! Negative if there are no calls, or if a call has not reported its number of iterations.
    double meanIterations() const;

    int calls, limited, failed, limitedFailed, worse, wrong, none;
    double iterations;  //!< sum over the calls
    bool tells;         //!< true if all calls have reported their iterations
    std::vector<float> times;
};

}  // namespace benchmark

#endif
