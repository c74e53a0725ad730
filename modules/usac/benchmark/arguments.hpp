// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_ARGUMENTS_HPP
#define OPENCV_USACV20_BENCHMARK_ARGUMENTS_HPP

#include <string>
#include <vector>
#include "opencv2/core/utility.hpp"

namespace benchmark {

//! Splits "a,b{c=1,d=2},e" at the commas outside of braces.
std::vector<std::string> splitNames(const std::string& names);

//! Raises std::runtime_error with the text if the condition does not hold.
void require(bool condition, const std::string& what);

/** The value of an option as a number. cv::CommandLineParser takes "1.5" for the integer 1; here
what is not a number all through raises std::runtime_error. */
double numberOf(const cv::CommandLineParser& parser, const std::string& name);
int integerOf(const cv::CommandLineParser& parser, const std::string& name);
//! The same for a text that was given with an option.
double toNumber(const std::string& text, const std::string& name);
int toInteger(const std::string& text, const std::string& name);

/** What cv::CommandLineParser does not do: it keeps only one of repeated options and ignores
unknown ones. */
class Arguments
{
public:
    //! Raises std::runtime_error for anything that is no option of `parser`.
    Arguments(int argc, char** argv, const cv::CommandLineParser& parser);

    //! All values of an option, each of which may hold several names between commas.
    std::vector<std::string> all(const std::string& name) const;
    bool given(const std::string& name) const;

private:
    std::vector<std::string> names, values;
};

//! What an option names, or else `fallback`, by default that of the parser. Nothing at all raises
//! std::runtime_error.
std::vector<std::string> namesOf(const cv::CommandLineParser& parser, const Arguments& arguments,
                                 const std::string& option,
                                 const std::string& fallback = std::string());

}  // namespace benchmark

#endif
