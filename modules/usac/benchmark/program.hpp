// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_PROGRAM_HPP
#define OPENCV_USACV20_BENCHMARK_PROGRAM_HPP

#include <fstream>
#include <string>

namespace benchmark {

//! Opens a file for writing unless its name is empty. Raises std::runtime_error if the file cannot
//! be opened. Programs call this before they measure what they write to the file, so that a wrong
//! path is found early.
void openOutput(std::ofstream& out, const std::string& file);

/** The body of a main() function: calls `program` and returns its exit code. An exception of
`program` becomes a message on the standard error and the exit code 1. OpenCV's own printing of
exceptions is turned off to avoid a second message. */
int runProgram(int (*program)(int argc, char** argv), int argc, char** argv);

}  // namespace benchmark

#endif
