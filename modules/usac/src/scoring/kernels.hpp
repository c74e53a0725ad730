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

//! Points of one call of a SumsKernel. Fewer are filled up with points of weight 0.
constexpr int SUMS_CHUNK = 32;
//! Each sum is kept in so many parts, to be added at the end.
constexpr int SUMS_LANES = 8;
/** Adds the Gauss-Newton sums of #SUMS_CHUNK points to `sums`, or the sum of their squared errors
alone; see sums.inl.hpp.
@param chunk the columns and the weight of the points: rows of #SUMS_CHUNK, of two views 5, of a
pose 6 */
typedef void (*SumsKernel)(const double (*chunk)[SUMS_CHUNK], const double* model,
                           double (*sums)[SUMS_LANES]);
//! Length of `sums` for the transfer error, the reprojection error and the epipolar distances, the
//! longest.
constexpr int TRANSFER_SUMS = 34, REPROJECTION_SUMS = 53, EPIPOLAR_SUMS = 55;

//! Of ArcsKernel: points come in multiples of this, rows of numbers, coefficients of the line,
//! parts of the line.
constexpr int ARCS_BLOCK = 16, ARCS_ROWS = 9, ARCS_WEIGHTS = 24, ARCS_BINS = 256;
/** Of `stride` points, the arcs of a line on which an epipole keeps them within the threshold, see
PlaneParallax and arcs.inl.hpp.
@param rows #ARCS_ROWS rows of `stride` numbers: n (3 of them) and the upper triangle of G (6)
@param stride points, a multiple of #ARCS_BLOCK
@param weights #ARCS_WEIGHTS coefficients of the line
@param from, to output: first and last bin of each arc; where every place suits, 0 and -1 */
typedef void (*ArcsKernel)(const float* rows, int stride, const float* weights, int* from, int* to);

/** The loops over points, compiled once for each instruction set. All versions return the same
bits: the sums run in the same lanes and order, and no multiplication is contracted with an
addition. Indices: Residual::Kind; the sums and the costs of the symmetric transfer error are those
in image 2 alone. */
struct Kernels
{
    ErrorKernel errors[Residual::CUSTOM];
    FusedKernel msac[Residual::CUSTOM];
    FusedKernel inliers[Residual::CUSTOM];
    SumsKernel sums[Residual::CUSTOM];   //!< null where fits are in closed form
    SumsKernel costs[Residual::CUSTOM];  //!< the same
    ArcsKernel arcs;
};

Kernels baselineKernels();
#ifdef USACV20_HAVE_AVX2
Kernels avx2Kernels();
#endif
#ifdef USACV20_HAVE_AVX512
Kernels avx512Kernels();
#endif

//! The best kernels of this processor, as far as OPENCV_CPU_DISABLE lets them be used.
const Kernels& kernels();

//! Model::size() numbers in the precision of the kernels; of a homogeneous model scaled so that no
//! float overflows.
void toFloat(const Model& model, float* m, bool homogeneous = true);

}  // namespace usacv20
}  // namespace cv

#endif
