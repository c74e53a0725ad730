// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/instruction_set.hpp"

namespace cv {
namespace usacv20 {

InstructionSet fastestInstructions()
{
#ifdef USACV20_HAVE_AVX512
    // all features are checked, because the environment variable OPENCV_CPU_DISABLE can name the
    // group AVX512_SKX or single features
    if (checkHardwareSupport(CV_CPU_AVX512_SKX) && checkHardwareSupport(CV_CPU_AVX_512F) &&
        checkHardwareSupport(CV_CPU_AVX_512BW) && checkHardwareSupport(CV_CPU_AVX_512DQ) &&
        checkHardwareSupport(CV_CPU_AVX_512VL))
        return INSTRUCTIONS_AVX512;
#endif
#ifdef USACV20_HAVE_AVX2
    if (checkHardwareSupport(CV_CPU_AVX2))
        return INSTRUCTIONS_AVX2;
#endif
    return INSTRUCTIONS_BASELINE;
}

}  // namespace usacv20
}  // namespace cv
