// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "program.hpp"

#include <iostream>
#include <stdexcept>
#include "opencv2/core.hpp"

namespace benchmark {

namespace {

int keepQuiet(int, const char*, const char*, const char*, int, void*) { return 0; }

}  // namespace

void openOutput(std::ofstream& out, const std::string& file)
{
    if (file.empty())
        return;
    out.open(file.c_str());
    if (!out)
        throw std::runtime_error(file + ": cannot be written");
}

int runProgram(int (*program)(int argc, char** argv), int argc, char** argv)
{
    try
    {
        cv::redirectError(keepQuiet);
        return program(argc, argv);
    }
    catch (const cv::Exception& error)
    {
        std::cerr << error.err << std::endl;
        return 1;
    }
    catch (const std::exception& error)
    {
        std::cerr << error.what() << std::endl;
        return 1;
    }
}

}  // namespace benchmark
