// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "scoring/kernels.inl.hpp"

namespace cv {
namespace usacv20 {

Kernels baselineKernels() { return allKernels(); }

#ifdef USACV20_HAVE_AVX512
//! The AVX-512 versions, and those of AVX2 for few samples.
static Kernels widestKernels()
{
    Kernels all = avx512Kernels();
#ifdef USACV20_HAVE_AVX2
    const Kernels narrower = avx2Kernels();
    all.fivePoints.few = narrower.fivePoints.few;
    all.sevenPoints.few = narrower.sevenPoints.few;
#endif
    return all;
}
#endif

static Kernels bestKernels()
{
#ifdef USACV20_HAVE_AVX512
    // OPENCV_CPU_DISABLE can name the group AVX512_SKX or single features
    if (checkHardwareSupport(CV_CPU_AVX512_SKX) && checkHardwareSupport(CV_CPU_AVX_512F) &&
        checkHardwareSupport(CV_CPU_AVX_512BW) && checkHardwareSupport(CV_CPU_AVX_512DQ) &&
        checkHardwareSupport(CV_CPU_AVX_512VL))
        return widestKernels();
#endif
#ifdef USACV20_HAVE_AVX2
    if (checkHardwareSupport(CV_CPU_AVX2))
        return avx2Kernels();
#endif
    return baselineKernels();
}

const Kernels& kernels()
{
    static const Kernels best = bestKernels();
    return best;
}

void toFloat(const Model& model, float* m, bool homogeneous)
{
    double factor = 1, limit = FLT_MAX;
    if (homogeneous)
    {
        double largest = 0;
        for (int i = 0; i < model.size(); ++i)
            largest = std::max(largest, std::abs(model.val[i]));
        factor = largest > 0 ? 1 / largest : 0;
        limit = 1;
    }
    float all[MAX_MODEL_SIZE];
    USAC_SIMD
    for (int i = 0; i < MAX_MODEL_SIZE; ++i)
    {
        const double value = model.val[i] * factor, raised = value < -limit ? -limit : value;
        all[i] = (float)(limit < raised ? limit : raised);
    }
    std::copy(all, all + model.size(), m);
}

}  // namespace usacv20
}  // namespace cv
