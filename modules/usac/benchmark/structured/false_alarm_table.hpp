// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_FALSE_ALARM_TABLE_HPP
#define OPENCV_USACV20_BENCHMARK_FALSE_ALARM_TABLE_HPP

#include <ostream>
#include <vector>
#include "structured_options.hpp"

namespace benchmark {

/** Measures how often methods return a model if all matches are wrong. */
class FalseAlarmTable
{
public:
    //! Unknown methods raise std::runtime_error.
    explicit FalseAlarmTable(const StructuredOptions& options);

    //! Writes a table with a row for each problem, kind and size, and a column for each method.
    //! @param csv gets a row for each entry of the table; null: no such file is written
    void run(std::ostream& out, std::ostream* csv);

private:
    //! For each method, the number of scenes of the cell for which it returns a model.
    std::vector<int> measure(const Cell& cell) const;

    const StructuredOptions& options;
    std::vector<cv::Ptr<Method>> methods;
};

}  // namespace benchmark

#endif
