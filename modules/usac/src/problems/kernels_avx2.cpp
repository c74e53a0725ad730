// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifdef __AVX2__

#include "problems/kernels.inl.hpp"

#ifdef USACV20_HAVE_AVX2

namespace cv {
namespace usacv20 {

Kernels avx2Kernels() { return allKernels(); }

}  // namespace usacv20
}  // namespace cv

#endif
#endif
