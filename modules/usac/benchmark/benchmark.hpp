// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_BENCHMARK_HPP
#define OPENCV_USACV20_BENCHMARK_BENCHMARK_HPP

namespace benchmark {

/** All that usac_benchmark does, for a program that has registered methods of its own
(registry.hpp):

    int program(int argc, char** argv)
    {
        benchmark::registerMethod("custom:mine", ...);
        return benchmark::runBenchmark(argc, argv);
    }

    int main(int argc, char** argv) { return benchmark::runProgram(program, argc, argv);  //
    program.hpp: exceptions become messages }

Takes the command line of usac_benchmark (doc/benchmark.md); a mistake in it raises
std::runtime_error.
@return the exit code: 0, or 2 if some pairs could not be read. */
int runBenchmark(int argc, char** argv);

}  // namespace benchmark

#endif
