// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_ARGUMENTS_HPP
#define OPENCV_USACV20_BENCHMARK_ARGUMENTS_HPP

#include <string>
#include <vector>
#include "opencv2/core/utility.hpp"

namespace benchmark {

//! Splits "a,b{c=1,d=2},e" at the commas outside of braces. Empty names are left out.
std::vector<std::string> splitNames(const std::string& names);

//! Raises std::runtime_error with the text `what` if the condition does not hold.
void require(bool condition, const std::string& what);

/** The value of an option as a number. These functions raise std::runtime_error unless the whole
text is a number (integerOf: an integer), whereas cv::CommandLineParser reads "1.5" as the integer
1. */
double numberOf(const cv::CommandLineParser& parser, const std::string& name);
int integerOf(const cv::CommandLineParser& parser, const std::string& name);
//! The same conversions for a text. `name` is the name of the option in error messages.
double toNumber(const std::string& text, const std::string& name);
int toInteger(const std::string& text, const std::string& name);

/** The options of a command line. cv::CommandLineParser keeps only one value of a repeated option
and ignores unknown options; this class keeps all values and refuses unknown options. */
class Arguments
{
public:
    //! Raises std::runtime_error for an argument that is not an option of `parser` or that has no
    //! value; only the options that ask for help (--help, -h and so on) need no value.
    Arguments(int argc, char** argv, const cv::CommandLineParser& parser);

    //! All values of an option, which can be repeated. A value that lists several names separated
    //! by commas is split.
    std::vector<std::string> all(const std::string& name) const;
    //! True if the option was given, even with an empty value.
    bool given(const std::string& name) const;

private:
    std::vector<std::string> names, values;
};

//! The names given with an option. Without this option, the names in `fallback`; if `fallback` is
//! empty, those in the option's default in `parser`. Raises std::runtime_error if there is no name.
std::vector<std::string> namesOf(const cv::CommandLineParser& parser, const Arguments& arguments,
                                 const std::string& option,
                                 const std::string& fallback = std::string());

}  // namespace benchmark

#endif
