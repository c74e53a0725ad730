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

//! Raises std::runtime_error "file:line: what".
void failAt(const std::string& file, int line, const std::string& what);
void failToOpen(const std::string& file);

/** Reads up to `count` numbers from a line. @return how many there are, -1 if something else
follows them. */
int readNumbers(const std::string& line, double* values, int count);

//! One row of numbers in a text file.
struct NumberRow
{
    int count;  //!< of numbers; -1: there is something else on the line
    double values[6];
    int line;
};

/** Calls `take` for each line of a text file that is not empty, in their order. It raises an error
for a wrong count; numbers that are not finite raise std::runtime_error with file and line behind
that.
@param most numbers that a line may have, up to 6 */
void readRows(const std::string& file, int most, const std::function<void(const NumberRow&)>& take);

/** Reads the members of a pair's description, a file of JSON; what they complain about comes with
file, line and name.
 */
class TruthReader
{
public:
    //! A file that cannot be opened, or is no JSON, raises std::runtime_error.
    explicit TruthReader(const std::string& file);

    //! Calls `reader` with the member, null if there is none of that name.
    void read(const std::string& name, const std::function<void(const Json&)>& reader) const;

    void require(bool condition, const std::string& name, const std::string& what) const;

    //! `problem` is a letter or a list of letters, of which one must be that; null: any.
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
