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

/** Writes the results as Markdown and CSV. */
class Tables
{
public:
    Tables(const Options& options, const std::vector<ListResult>& results);

    //! One table a list, then the averages over all lists and over those of each problem.
    void markdown(std::ostream& out) const;
    //! The same figures, one row a list and method; the lists `average.H` etc. hold the averages.
    void csv(std::ostream& out) const;
    //! One row a call.
    void runsCsv(std::ostream& out) const;

private:
    typedef std::vector<std::vector<Summary> > Summaries;

    void markdownList(std::ostream& out, size_t list) const;
    void markdownAverages(std::ostream& out, const std::string& title, const Summaries& chosen) const;
    void csvAverages(std::ostream& out, const std::string& name, const std::string& letter, const Summaries& chosen) const;
    Summaries ofProblem(ProblemType problem) const;

    const Options& options;
    const std::vector<ListResult>& results;
    Summaries summaries;  //!< of each list, of each method
    int baseline;         //!< index of a method
};

} // namespace benchmark

#endif
