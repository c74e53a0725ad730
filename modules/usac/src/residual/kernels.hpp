// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RESIDUAL_KERNELS_HPP
#define OPENCV_USACV20_RESIDUAL_KERNELS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! A list of indices at compile time, like std::index_sequence of C++14. It is used to pass the
//! columns of a datum to a formula as separate arguments.
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

//! Number of points in one call of a SumsKernel. If there are fewer points, the caller adds points
//! of weight 0.
constexpr int SUMS_CHUNK = 32;
//! Number of partial sums of each sum; the caller of the kernels adds the partial sums at the end.
constexpr int SUMS_LANES = 8;
//! Maximum number of sums of a kernel: the number of entries in the lower triangle of a matrix with
//! #MAX_MODEL_SIZE + 1 rows.
constexpr int MAX_SUMS = (MAX_MODEL_SIZE + 1) * (MAX_MODEL_SIZE + 2) / 2;
//! Maximum number of entries of the derivative of an error, see Residual::linearize().
constexpr int MAX_DERIVATIVE = (int)Residual::MAX_COMPONENTS * (int)MAX_MODEL_SIZE;
/** Computes, for #SUMS_CHUNK points, the sums from which the normal equations of the Gauss-Newton
method are built, or only the sum of the weighted squared errors, and adds them to `sums`. See
sums.inl.hpp.
@param chunk a row of #SUMS_CHUNK numbers for each column of the points, and a last row with the
weights of the points */
typedef void (*SumsKernel)(const double (*chunk)[SUMS_CHUNK], const double* model,
                           double (*sums)[SUMS_LANES]);

/** Computes, for #SUMS_CHUNK points, the weighted sum of |L d|^2 over the components of the error.
Here d is the derivative of a component with respect to the N = Model::size() entries of the model.
If L^T L is the inverse of the matrix of the normal equations, these are the leverages of the
points.
@param chunk, model see SumsKernel
@param L lower triangular N x N matrix, row by row
@param leverages output, #SUMS_CHUNK numbers */
typedef void (*LeverageKernel)(const double (*chunk)[SUMS_CHUNK], const double* model,
                               const double* L, double* leverages);

/** The loops over points that the module compiles from the formula of an error, once for each
instruction set. `errors`, `msac` and `inliers` can be null. The loops for all instruction sets
return the same bits: they have the same partial sums, add in the same order, and fuse no
multiplication with an addition. */
struct ResidualKernels
{
    ErrorKernel errors;   //!< squared errors
    FusedKernel msac;     //!< MSAC score
    FusedKernel inliers;  //!< score whose cost is the number of points that are not inliers
    SumsKernel sums;      //!< all sums for the normal equations
    SumsKernel cost;      //!< only the sum of the weighted squared errors
    LeverageKernel leverages;
    int columns;  //!< number of columns of a datum
    int count;    //!< number of sums that the kernel `sums` computes
    /** Computes the normal equations of the Gauss-Newton method in the N = Model::size() entries of
    a model, for the weighted errors r with the Jacobian J.
    @param total the `count` sums
    @param JtJ output, J^T J, N x N, symmetric
    @param Jtr output, J^T r, N numbers
    @param cost output, r^T r */
    void (*toEquations)(const double* total, double* JtJ, double* Jtr, double& cost);
};

//! Converts the Model::size() entries of a model to float without overflow: a homogeneous model is
//! divided by its largest absolute entry; the entries of other models are clamped to the range of
//! float.
void toFloat(const Model& model, float* m, bool homogeneous = true);

namespace {  // compiled for different instruction sets, see formula_residual.hpp

//! MSAC cost: truncated squared error in units of the squared threshold @cite torr2000mlesac.
//! @param scale 1 divided by the squared threshold
inline float msacCost(float squaredError, float scale)
{
    const float cost = squaredError * scale;
    return cost < 1.f ? cost : 1.f;  // 1 for NaN
}

}  // namespace

}  // namespace usacv20
}  // namespace cv

#endif
