// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_PAIR_WRITER_HPP
#define OPENCV_USACV20_BENCHMARK_PAIR_WRITER_HPP

#include <fstream>
#include <string>
#include <vector>
#include "opencv2/core.hpp"
#include "scenes.hpp"

namespace benchmark {

/** Writes scenes as a data set of the benchmark.

`<folder>/lists/<name>.<letter>.list` for each letter names the pairs, `<folder>/pairs/<name>/<number>.corr` and `.json`
hold them. Files of the same names are replaced. What cannot be written raises std::runtime_error. */
class PairWriter
{
public:
    //! @param letters the problems that the pairs are for: "H" or "FE".
    PairWriter(const std::string& folder, const std::string& name, const std::string& letters);

    void write(const opencv_test::Scene& scene);

private:
    void writeCorrespondences(const std::string& file, const opencv_test::Scene& scene) const;
    void writeTruth(const std::string& file, const opencv_test::Scene& scene) const;

    std::string folder, name, letters;
    std::vector<cv::Ptr<std::ofstream>> lists;  //!< one a letter
    int count;                                  //!< pairs so far
};

}  // namespace benchmark

#endif
