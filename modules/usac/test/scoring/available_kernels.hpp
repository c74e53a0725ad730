// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_AVAILABLE_KERNELS_HPP
#define OPENCV_USACV20_TEST_AVAILABLE_KERNELS_HPP

#include "test_precomp.hpp"
#include "scoring/kernels.hpp"

namespace opencv_test {
namespace {

struct NamedKernels
{
    const char* name;
    Kernels kernels;
};

//! Of all instruction sets that this processor has.
std::vector<NamedKernels> availableKernels()
{
    std::vector<NamedKernels> result;
    const NamedKernels baseline = {"baseline", baselineKernels()};
    result.push_back(baseline);
#ifdef USACV20_HAVE_AVX2
    if (checkHardwareSupport(CV_CPU_AVX2))
    {
        const NamedKernels avx2 = {"AVX2", avx2Kernels()};
        result.push_back(avx2);
    }
#endif
#ifdef USACV20_HAVE_AVX512
    if (checkHardwareSupport(CV_CPU_AVX_512F) && checkHardwareSupport(CV_CPU_AVX_512BW) &&
        checkHardwareSupport(CV_CPU_AVX_512DQ) && checkHardwareSupport(CV_CPU_AVX_512VL))
    {
        const NamedKernels avx512 = {"AVX-512", avx512Kernels()};
        result.push_back(avx512);
    }
#endif
    const NamedKernels best = {"best", kernels()};
    result.push_back(best);
    return result;
}

}
}  // namespace

#endif
