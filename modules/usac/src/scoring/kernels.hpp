// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_KERNELS_HPP
#define OPENCV_USACV20_KERNELS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Squared errors of the points begin .. end-1 under a model.
typedef void (*ErrorKernel)(const Correspondences& points, const float* model, int begin, int end,
                            float* errors);

//! Number of points of one call of a SumsKernel; fewer are padded with points of weight 0.
constexpr int SUMS_CHUNK = 32;
//! Number of partial sums of each sum; the caller adds them at the end.
constexpr int SUMS_LANES = 8;
/** Adds the Gauss-Newton sums of #SUMS_CHUNK points to `sums`, or the sum of their squared errors
alone; see sums.inl.hpp.
@param chunk columns of the points and their weights: rows of #SUMS_CHUNK numbers, 5 rows for two
views, 6 for a pose */
typedef void (*SumsKernel)(const double (*chunk)[SUMS_CHUNK], const double* model,
                           double (*sums)[SUMS_LANES]);
//! Number of sums for the transfer error, the reprojection error and the epipolar distances.
//! EPIPOLAR_SUMS is the largest.
constexpr int TRANSFER_SUMS = 34, REPROJECTION_SUMS = 53, EPIPOLAR_SUMS = 55;

//! For ArcsKernel: ARCS_BLOCK divides the number of points; a point has ARCS_ROWS numbers, a line
//! has ARCS_WEIGHTS coefficients and is divided into ARCS_BINS bins.
constexpr int ARCS_BLOCK = 16, ARCS_ROWS = 9, ARCS_WEIGHTS = 24, ARCS_BINS = 256;
/** For each of `stride` points, the arc of a line on which an epipole keeps the point within the
threshold, see PlaneParallax and arcs.inl.hpp.
@param rows #ARCS_ROWS rows of `stride` numbers: n (3 of them) and the upper triangle of G (6)
@param stride number of points, a multiple of #ARCS_BLOCK
@param weights #ARCS_WEIGHTS coefficients of the line
@param from, to output: first and last bin of each arc; 0 and -1 if the arc is the whole line */
typedef void (*ArcsKernel)(const float* rows, int stride, const float* weights, int* from, int* to);

/** The loops over points, compiled once for each instruction set. All versions return the same
bits: they sum in the same lanes and order, and no multiplication is contracted with an addition.
The arrays are indexed by Residual::Kind; the sums and costs of the symmetric transfer error are
those in image 2 alone. */
struct Kernels
{
    ErrorKernel errors[Residual::CUSTOM];
    FusedKernel msac[Residual::CUSTOM];
    FusedKernel inliers[Residual::CUSTOM];
    SumsKernel sums[Residual::CUSTOM];   //!< null if fits are in closed form
    SumsKernel costs[Residual::CUSTOM];  //!< null likewise
    ArcsKernel arcs;
};

Kernels baselineKernels();
#ifdef USACV20_HAVE_AVX2
Kernels avx2Kernels();
#endif
#ifdef USACV20_HAVE_AVX512
Kernels avx512Kernels();
#endif

//! The fastest kernels that the processor supports and OPENCV_CPU_DISABLE permits.
const Kernels& kernels();

//! Converts the Model::size() numbers of a model to float without overflow: a homogeneous model is
//! divided by its largest entry; the entries of any other model are clamped.
void toFloat(const Model& model, float* m, bool homogeneous = true);

}  // namespace usacv20
}  // namespace cv

#endif
