// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_BENCHMARK_HPP
#define OPENCV_USACV20_BENCHMARK_BENCHMARK_HPP

namespace benchmark {

/** Does all that the program usac_benchmark does. A program with methods of its own registers them
first (registry.hpp):

    int program(int argc, char** argv)
    {
        benchmark::registerMethod("custom:mine", ...);
        return benchmark::runBenchmark(argc, argv);
    }

    // program.hpp: runProgram prints exceptions as messages
    int main(int argc, char** argv) { return benchmark::runProgram(program, argc, argv); }

The command line is that of usac_benchmark (doc/benchmark.md). Wrong options raise
std::runtime_error.
@return the exit code: 0, or 2 if some pairs could not be read. */
int runBenchmark(int argc, char** argv);

}  // namespace benchmark

#endif
