// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_TRUTH_READER_HPP
#define OPENCV_USACV20_BENCHMARK_TRUTH_READER_HPP

#include <functional>
#include <string>
#include "json.hpp"
#include "opencv2/core.hpp"

namespace benchmark {

//! Raises std::runtime_error with the text "file:line: what".
void failAt(const std::string& file, int line, const std::string& what);
void failToOpen(const std::string& file);

/** Reads up to `count` numbers from a line. @return the number of values read; -1 if the line also
has something else, or more numbers. */
int readNumbers(const std::string& line, double* values, int count);

//! One row of numbers in a text file.
struct NumberRow
{
    int count;  //!< count of numbers; -1: the line contains something else, or too many numbers
    double values[6];
    int line;  //!< line number in the file
};

/** Calls `take` for each nonempty line of a text file in order. `take` must raise an error if
NumberRow::count is wrong. After each call of `take`, std::runtime_error with file and line is
raised if a number of the line is not finite.
@param most largest count of numbers on a line, up to 6 */
void readRows(const std::string& file, int most, const std::function<void(const NumberRow&)>& take);

/** Reads the members of a pair's description, a JSON file. Error messages name the file, the line
and the member.
 */
class TruthReader
{
public:
    //! Raises std::runtime_error if the file cannot be opened or is not valid JSON.
    explicit TruthReader(const std::string& file);

    //! Calls `reader` with the member of this name, or with a null value if there is none. If
    //! `reader` raises std::runtime_error, file, line and name are added to the error's message.
    void read(const std::string& name, const std::function<void(const Json&)>& reader) const;

    //! Raises an error about the member `name` if the condition does not hold.
    void require(bool condition, const std::string& name, const std::string& what) const;

    //! Raises an error unless the member `problem` is null, is this letter, or is a list that
    //! contains this letter.
    void requireProblem(char letter) const;

private:
    const std::string file;
    const Json json;
};

cv::Size2d toSize(const Json& json);
//! @return false if the value is null.
bool toMatrix(const Json& json, cv::Matx33d& matrix);
bool toVector(const Json& json, cv::Vec3d& vector);

}  // namespace benchmark

#endif
