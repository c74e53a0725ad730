// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_INSTRUCTION_SET_HPP
#define OPENCV_USACV20_INSTRUCTION_SET_HPP

#ifdef _MSC_VER
#define USAC_RESTRICT __restrict
#else
#define USAC_RESTRICT __restrict__
#endif

//! Written before a short loop, so that GCC and Clang vectorize the loop instead of unrolling it.
//! Needs the compiler option -fopenmp-simd, but not the OpenMP library.
#if defined __GNUC__
#define USAC_SIMD _Pragma("omp simd")
#else
#define USAC_SIMD
#endif

namespace cv {
namespace usacv20 {

//! Instruction sets for which some source files are compiled, see cmake/usac_options.cmake.
enum InstructionSet { INSTRUCTIONS_BASELINE, INSTRUCTIONS_AVX2, INSTRUCTIONS_AVX512 };

//! The fastest instruction set that the compiler and the processor support and that the environment
//! variable OPENCV_CPU_DISABLE does not exclude.
InstructionSet fastestInstructions();

}  // namespace usacv20
}  // namespace cv

#endif
