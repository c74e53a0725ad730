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

//! A proportion with the interval of Wilson that holds the true one with 95 %.
struct Proportion
{
    Proportion(int count, int of);
    //! In percent: "1.2 [0.4, 3.5]"; "-" of nothing.
    std::string text() const;

    int of;
    double value, low, high;  //!< 0 .. 1
};

/** Counts what calls of one method on the scenes of one or more cells have given. */
class Tally
{
public:
    Tally();

    void add(const Call& call, const Verdict& verdict);
    //! Those of a whole cell.
    void add(const Tally& cell, const std::string& name);

    //! Search failures among the calls that ended by themselves.
    Proportion failures() const { return Proportion(failed - limitedFailed, calls - limited); }

    int size() const { return calls; }
    bool empty() const { return calls == 0; }

    enum { COLUMNS = 10 };  //!< of a Markdown table
    static std::string markdownHeader();
    std::string markdown() const;
    //! One entry of a table: the search failures, and behind a plus the part of the calls that the
    //! limit let fail.
    std::string brief() const;
    static std::string csvHeader();
    std::string csv() const;

private:
    //! Negative where the method does not tell.
    double meanIterations() const;

    int calls, limited, failed, limitedFailed, worse, wrong, none;
    double iterations;  //!< sum
    bool tells;         //!< every call told its iterations
    std::vector<float> times;
    std::string worstCell;
    double worstRate;
};

}  // namespace benchmark

#endif
