// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SIMD_HPP
#define OPENCV_USACV20_SIMD_HPP

#ifdef _MSC_VER
#define USAC_RESTRICT __restrict
#else
#define USAC_RESTRICT __restrict__
#endif

//! Keeps compilers from unrolling a short loop before they can vectorize it. Needs -fopenmp-simd,
//! but not OpenMP.
#if defined __GNUC__
#define USAC_SIMD _Pragma("omp simd")
#else
#define USAC_SIMD
#endif

#endif
