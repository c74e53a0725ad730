// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_LANE_KERNELS_HPP
#define OPENCV_USACV20_LANE_KERNELS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! A fundamental matrix counts as a matrix of rank 2 if the ratio of its second to its first
//! singular value is above this number.
constexpr double LEAST_RATIO = 1e-6;

/** Solves several samples at once, each in one lane of the vector registers. The models of a sample
do not depend on the other samples.
@param samples `count` samples, see MinimalSolver::solveMany
@param count 1 to MinimalSolver::MAX_TOGETHER, the number of lanes of the widest registers
@param models output: 3x3 matrices of unit norm, row by row
@param found output: number of models of each sample */
typedef void (*SolverKernel)(const Correspondences& points, const int* const* samples, int count,
                             double (*models)[MAX_MODELS][9], int* found);

/** Tests several samples at once.
@param samples, count see SolverKernel
@param valid output: for each sample, whether it passes the test */
typedef void (*SampleKernel)(const Correspondences& points, const int* const* samples, int count,
                             bool* valid);

//! Minimal solvers and tests for several samples at once, compiled once for each instruction set;
//! the results of all versions are bit-identical.
namespace lanes {

struct Kernels
{
    SolverKernel fivePoints;   //!< essential matrices
    SolverKernel sevenPoints;  //!< fundamental matrices
    SolverKernel fourPoints;   //!< homographies
    SampleKernel orientation;  //!< for homographies, see HomographyOrientation
};

Kernels baselineKernels();
#ifdef USACV20_HAVE_AVX2
Kernels avx2Kernels();
#endif
#ifdef USACV20_HAVE_AVX512
Kernels avx512Kernels();
#endif

//! The kernels that solve this number of samples in the shortest time on this processor.
const Kernels& kernelsFor(int samples);

}  // namespace lanes
}  // namespace usacv20
}  // namespace cv

#endif
