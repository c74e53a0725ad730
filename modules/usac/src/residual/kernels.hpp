// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RESIDUAL_KERNELS_HPP
#define OPENCV_USACV20_RESIDUAL_KERNELS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! A list of indices at compile time, like std::index_sequence of C++14: it passes the columns of
//! a datum to a formula as separate arguments.
template <int... K>
struct Indices
{};

//! The member Type is Indices<0, ..., N - 1>.
template <int N, int... K>
struct IndicesTo : IndicesTo<N - 1, N - 1, K...>
{};

template <int... K>
struct IndicesTo<0, K...>
{
    typedef Indices<K...> Type;
};

//! Squared errors of the points begin .. end-1 under a model.
typedef void (*ErrorKernel)(const Correspondences& points, const float* model, int begin, int end,
                            float* errors);

//! Number of points of one call of a SumsKernel; fewer are padded with points of weight 0.
constexpr int SUMS_CHUNK = 32;
//! Number of partial sums of each sum; the caller adds them at the end.
constexpr int SUMS_LANES = 8;
//! Most sums of a kernel: the lower triangle of a matrix of #MAX_MODEL_SIZE + 1 rows.
constexpr int MAX_SUMS = (MAX_MODEL_SIZE + 1) * (MAX_MODEL_SIZE + 2) / 2;
//! Most numbers of the derivative of an error, see Residual::linearize().
constexpr int MAX_DERIVATIVE = (int)Residual::MAX_COMPONENTS * (int)MAX_MODEL_SIZE;
/** Adds the Gauss-Newton sums of #SUMS_CHUNK points to `sums`, or the sum of their squared errors
alone; see sums.inl.hpp.
@param chunk columns of the points and their weights: rows of #SUMS_CHUNK numbers, one for each
number of a datum, the last one for the weights */
typedef void (*SumsKernel)(const double (*chunk)[SUMS_CHUNK], const double* model,
                           double (*sums)[SUMS_LANES]);

/** The loops over points that the module compiles from the formula of an error, once for each
instruction set. All versions return the same bits: they sum in the same lanes and order, and no
multiplication is contracted with an addition. */
struct ResidualKernels
{
    ErrorKernel errors;
    FusedKernel msac;     //!< of the MSAC score
    FusedKernel inliers;  //!< of the number of inliers
    SumsKernel sums;
    SumsKernel cost;
    int count;  //!< number of sums of `sums`
    /** Writes the normal equations of the Gauss-Newton method with N = Model::size() entries.
    @param total the `count` sums
    @param JtJ output, N x N, symmetric
    @param Jtr output, N
    @param cost output */
    void (*toEquations)(const double* total, double* JtJ, double* Jtr, double& cost);
};

//! Converts the Model::size() numbers of a model to float without overflow: a homogeneous model is
//! divided by its largest entry; the entries of any other model are clamped.
void toFloat(const Model& model, float* m, bool homogeneous = true);

namespace {  // compiled for different instruction sets, see formula_residual.hpp

//! MSAC cost: truncated squared error in units of the squared threshold @cite torr2000mlesac.
inline float msacCost(float squaredError, float scale)
{
    const float cost = squaredError * scale;
    return cost < 1.f ? cost : 1.f;  // also for NaN
}

}  // namespace

}  // namespace usacv20
}  // namespace cv

#endif
