// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/instruction_set.hpp"
#include "problems/kernels.inl.hpp"

namespace cv {
namespace usacv20 {

Kernels baselineKernels() { return allKernels(); }

static Kernels bestKernels()
{
    const InstructionSet instructions = fastestInstructions();
#ifdef USACV20_HAVE_AVX512
    if (instructions == INSTRUCTIONS_AVX512)
        return avx512Kernels();
#endif
#ifdef USACV20_HAVE_AVX2
    if (instructions == INSTRUCTIONS_AVX2)
        return avx2Kernels();
#endif
    CV_UNUSED(instructions);
    return baselineKernels();
}

const Kernels& kernels()
{
    static const Kernels best = bestKernels();
    return best;
}

}  // namespace usacv20
}  // namespace cv
