// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_LIST_WRITER_HPP
#define OPENCV_USACV20_BENCHMARK_LIST_WRITER_HPP

#include <fstream>
#include <string>
#include <vector>
#include "opencv2/core.hpp"

namespace benchmark {

/** Makes the folders of a data set, its lists and the names of its pairs.

`<folder>/lists/<name>.<letter>.list` for each letter names the pairs, whose files are
`<folder>/pairs/<name>/<number>` with an extension. Files of the same names are replaced. What
cannot be written raises std::runtime_error. */
class ListWriter
{
public:
    //! @param letters the problems that the pairs are for
    ListWriter(const std::string& folder, const std::string& name, const std::string& letters);

    //! Puts the next pair into all lists. @return its path without extension
    std::string next();

private:
    std::string folder, name;
    std::vector<cv::Ptr<std::ofstream>> lists;  //!< one a letter
    int count;                                  //!< pairs so far
};

//! Raises std::runtime_error if what was written to the file did not get there.
void closeFile(std::ofstream& out, const std::string& file);

//! Writes a score a line.
void writeScores(const std::string& file, const std::vector<float>& scores);

//! A new JSON file. One that cannot be opened raises std::runtime_error.
void openJson(cv::FileStorage& out, const std::string& file);
//! Writes the first rows of a matrix.
void writeMatrix(cv::FileStorage& out, const std::string& name, const cv::Matx33d& matrix,
                 int rows = 3);
void writeVector(cv::FileStorage& out, const std::string& name, const cv::Vec3d& vector);
//! Writes the letters of the problems that a pair is for.
void writeProblems(cv::FileStorage& out, const std::string& letters);
//! Writes the numbers of the right matches.
void writeRightMatches(cv::FileStorage& out, const std::vector<uchar>& truth);

}  // namespace benchmark

#endif
