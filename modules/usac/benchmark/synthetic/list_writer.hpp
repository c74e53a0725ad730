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

For each letter, `<folder>/lists/<name>.<letter>.list` names the pairs, whose files are
`<folder>/pairs/<name>/<number>` with an extension. Existing files of these names are replaced. A
file or folder that cannot be written raises std::runtime_error. */
class ListWriter
{
public:
    //! @param letters letters of the problems that the pairs can be used for
    ListWriter(const std::string& folder, const std::string& name, const std::string& letters);

    //! Adds the next pair to all lists. @return its path without extension
    std::string next();

private:
    std::string folder, name;
    std::vector<cv::Ptr<std::ofstream>> lists;  //!< one for each letter
    int count;                                  //!< number of pairs so far
};

//! Closes a file. Raises std::runtime_error if some of its contents could not be written.
void closeFile(std::ofstream& out, const std::string& file);

//! Writes one score on each line.
void writeScores(const std::string& file, const std::vector<float>& scores);

//! Opens a new JSON file. Raises std::runtime_error if the file cannot be opened.
void openJson(cv::FileStorage& out, const std::string& file);
//! Writes the first `rows` rows of a matrix.
void writeMatrix(cv::FileStorage& out, const std::string& name, const cv::Matx33d& matrix,
                 int rows = 3);
void writeVector(cv::FileStorage& out, const std::string& name, const cv::Vec3d& vector);
//! Writes the letters of the problems that a pair can be used for.
void writeProblems(cv::FileStorage& out, const std::string& letters);
//! Writes the indices of the right matches.
void writeRightMatches(cv::FileStorage& out, const std::vector<uchar>& truth);

}  // namespace benchmark

#endif
