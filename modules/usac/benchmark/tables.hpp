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

/** Writes the results: one table a list, then the averages over all lists and over those of each
problem. */
class Tables
{
public:
    Tables(const Options& options, const std::vector<ListResult>& results);

    void markdown(std::ostream& out) const;
    //! The same figures, one row a list and method; the lists `average`, `average.H` etc. hold the
    //! averages.
    void csv(std::ostream& out) const;
    //! One row a call.
    void runsCsv(std::ostream& out) const;

private:
    struct Table
    {
        std::string name, problem;  //!< problem: its letter, empty for all
        std::string title;
        int pairs;
        std::vector<Summary> rows;  //!< one a method
    };

    void addList(const ListResult& result);
    void addAverages(const std::string& problem);
    void markdownTable(std::ostream& out, const Table& table) const;

    const Options& options;
    const std::vector<ListResult>& results;
    int baseline;              //!< index of a method
    bool inPixels, inDegrees;  //!< units of the errors that there are
    std::vector<Table> tables;
};

}  // namespace benchmark

#endif
