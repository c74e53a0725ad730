// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_PAIR_WRITER_HPP
#define OPENCV_USACV20_BENCHMARK_PAIR_WRITER_HPP

#include "list_writer.hpp"
#include "support/scenes.hpp"

namespace benchmark {

/** Writes scenes of two images as a data set of the benchmark: `.corr` and `.json` for each pair,
see ListWriter. */
class PairWriter
{
public:
    //! @param letters letters of the problems that the pairs can be used for: "H", "FE", "A", "S"
    //! or "T"
    PairWriter(const std::string& folder, const std::string& name, const std::string& letters);

    void write(const opencv_test::Scene& scene);

private:
    void writeCorrespondences(const std::string& file, const opencv_test::Scene& scene) const;
    void writeTruth(const std::string& file, const opencv_test::Scene& scene) const;

    std::string letters;
    ListWriter list;
};

}  // namespace benchmark

#endif
