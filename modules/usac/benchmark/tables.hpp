// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_TABLES_HPP
#define OPENCV_USACV20_BENCHMARK_TABLES_HPP

#include <ostream>
#include <string>
#include <vector>
#include "summary.hpp"

namespace benchmark {

/** Writes the results: a table for each list, then averages over all lists and, if the lists are of
several problems, over the lists of each problem. */
class Tables
{
public:
    Tables(const Options& options, const std::vector<ListResult>& results);

    void markdown(std::ostream& out) const;
    //! Writes the same figures and mean wall times as CSV, with a row for each list and method. The
    //! list names of averages are `average`, `average.H` and so on.
    void csv(std::ostream& out) const;
    //! Writes the individual runs as CSV, one row for each.
    void runsCsv(std::ostream& out) const;

private:
    struct Table
    {
        std::string name, problem;  //!< problem: its letter; empty for all problems
        std::string title;
        int pairs;
        std::vector<Summary> rows;  //!< one for each method
    };

    void addList(const ListResult& result);
    void addAverages(const std::string& problem);
    void markdownTable(std::ostream& out, const Table& table) const;

    const Options& options;
    const std::vector<ListResult>& results;
    bool inPixels, inDegrees;  //!< true if the results have errors in this unit
    std::vector<Table> tables;
};

}  // namespace benchmark

#endif
