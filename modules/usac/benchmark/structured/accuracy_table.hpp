// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_ACCURACY_TABLE_HPP
#define OPENCV_USACV20_BENCHMARK_ACCURACY_TABLE_HPP

#include <ostream>
#include <string>
#include <vector>
#include "judge.hpp"
#include "structured_options.hpp"

namespace benchmark {

/** Compares the errors of methods with those of least squares over the right matches, for several
camera motions and noise levels. Wrong matches are uniformly distributed. */
class AccuracyTable
{
public:
    //! Unknown methods raise std::runtime_error.
    explicit AccuracyTable(const StructuredOptions& options);

    //! Writes a table for each problem to `out`, and a row for each cell, noise level and method
    //! (also for least squares) to `csv` unless that pointer is null.
    void run(std::ostream& out, std::ostream* csv);

private:
    //! The results of a method, or of least squares, on all scenes of a cell with one noise level.
    struct Errors
    {
        std::vector<double> errors, poses;
        std::vector<bool> far, wrong;  //!< see Verdict
    };

    Cell cellOf(ProblemType problem, const std::string& motion, int size, double ratio) const;
    void header(ProblemType problem, std::ostream& out) const;
    void row(const Cell& cell, double noise, std::ostream& out, std::ostream* csv) const;
    static void add(const Verdict& verdict, Errors& errors);
    void csvRow(const Cell& cell, double noise, const std::string& method, const Errors& errors,
                const Errors& reference, std::ostream& csv) const;

    const StructuredOptions& options;
    std::vector<cv::Ptr<Method>> methods;
};

}  // namespace benchmark

#endif
