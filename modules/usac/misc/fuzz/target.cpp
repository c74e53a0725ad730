// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdint.h>
#include "fuzz/fuzz_contracts.hpp"

// The target of the fuzzer. With USAC_FUZZ_REPLAY, this is a program that checks the inputs in the
// files named on its command line.

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    using namespace opencv_test;
    const std::string broken = brokenContract(readFuzzInput(data, size));
    if (!broken.empty())
    {
        std::fprintf(stderr, "broken contract: %s\n", broken.c_str());
        std::abort();
    }
    return 0;
}

#ifdef USAC_FUZZ_REPLAY
int main(int count, char** files)
{
    for (int i = 1; i < count; ++i)
    {
        std::ifstream in(files[i], std::ios::binary);
        const std::string bytes((std::istreambuf_iterator<char>(in)),
                                std::istreambuf_iterator<char>());
        std::printf("%s, %d bytes\n", files[i], (int)bytes.size());
        std::fflush(stdout);
        LLVMFuzzerTestOneInput((const uint8_t*)bytes.data(), bytes.size());
    }
    return 0;
}
#endif
