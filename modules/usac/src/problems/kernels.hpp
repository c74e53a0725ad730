// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_KERNELS_HPP
#define OPENCV_USACV20_KERNELS_HPP

#include "problems/errors.hpp"
#include "problems/fundamental/arcs.hpp"
#include "residual/formula_residual.hpp"

namespace cv {
namespace usacv20 {

//! The compiled loops over points for all problems. There is one such set for each instruction set.
struct Kernels
{
    ResidualKernels residuals[Errors::COUNT];  //!< in the order of the list #Errors
    ArcsKernel arcs;
};

Kernels baselineKernels();
#ifdef USACV20_HAVE_AVX2
Kernels avx2Kernels();
#endif
#ifdef USACV20_HAVE_AVX512
Kernels avx512Kernels();
#endif

//! The fastest kernels that the processor supports and that the environment variable
//! OPENCV_CPU_DISABLE does not exclude.
const Kernels& kernels();

namespace {  // unnamed, because the formulas are in unnamed namespaces

//! The compiled loops over points for the formula `Error`.
template <class Error>
inline const ResidualKernels& kernelsOf()
{
    return kernels().residuals[PlaceOf<Error, Errors>::VALUE];
}

//! Creates the residual with the formula `Error`.
template <class Error>
inline Ptr<Residual> createResidualOf()
{
    return makePtr<FormulaResidual<Error>>(kernelsOf<Error>());
}

//! True if `residual` uses the formula `Error`. The caller can then use a closed-form fit for this
//! formula.
template <class Error>
inline bool hasFormula(const Residual& residual)
{
    return residual.kernels() == &kernelsOf<Error>();
}

}  // namespace

}  // namespace usacv20
}  // namespace cv

#endif
