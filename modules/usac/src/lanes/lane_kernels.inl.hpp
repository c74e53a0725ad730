// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

/* No include guard: each source file that is compiled for an instruction set includes this file
once. This file must not instantiate inline functions with external linkage: the linker keeps only
one copy of such a function, perhaps one with instructions that the processor does not have. */

#include <cfloat>
#include <climits>
#include <cmath>
#include <cstring>
#include "numeric/polynomial.hpp"
#include "lanes/essential_basis.hpp"
#include "lanes/lane_kernels.hpp"
#include "lanes/pack.inl.hpp"
#include "lanes/null_space.inl.hpp"
#include "lanes/roots.inl.hpp"
#include "lanes/five_points_polynomials.inl.hpp"
#include "lanes/five_points.inl.hpp"
#include "lanes/seven_points.inl.hpp"
#include "lanes/four_points.inl.hpp"

namespace cv {
namespace usacv20 {
namespace {

lanes::Kernels allKernels()
{
    lanes::Kernels all;
    all.fivePoints = fivePointKernel;
    all.sevenPoints = sevenPointKernel;
    all.fourPoints = fourPointKernel;
    all.orientation = orientationKernel;
    return all;
}

}  // namespace
}  // namespace usacv20
}  // namespace cv
