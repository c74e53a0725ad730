// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// No include guard: included once by the source file of each instruction set.

#include "residual/kernels.inl.hpp"
#include "problems/fundamental/arcs.inl.hpp"
#include "problems/kernels.hpp"

namespace cv {
namespace usacv20 {
namespace {

template <class... All>
Kernels kernelsOfList(ErrorList<All...>)
{
    const Kernels all = {{kernelsFor<All>()...}, arcsKernel};
    return all;
}

Kernels allKernels() { return kernelsOfList(Errors()); }

}  // namespace
}  // namespace usacv20
}  // namespace cv
