// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

/* The kernels of residual/kernels.hpp for a formula. No include guard: each source file that is
compiled for an instruction set includes this file once. It must not instantiate inline functions
with external linkage: the linker keeps only one copy of such a function, perhaps one with
instructions that the processor does not have. */

#include <cmath>
#include <limits>
#include <type_traits>
#include "residual/kernels.hpp"
#include "numeric/instruction_set.hpp"
#include "residual/sums.inl.hpp"

namespace cv {
namespace usacv20 {
namespace {

//! Number of partial sums, one for each float in the widest registers. It is the same for all
//! instruction sets, so that all of them return the same bits.
constexpr int LANES = 16;

template <class Error, typename... Numbers>
inline float squaredOf(const float* m, Numbers... datum)
{
    return typename Error::template At<float>(m, datum...).squared();
}

template <class Error, typename... Columns>
inline void errorsOf(const float* m, int count, float* USAC_RESTRICT errors,
                     const Columns* USAC_RESTRICT... column)
{
    USAC_SIMD
    for (int i = 0; i < count; ++i)
        errors[i] = squaredOf<Error>(m, column[i]...);
}

template <class Error, int... K>
inline void errorsOf(const Correspondences& points, const float* m, int begin, int end,
                     float* errors, Indices<K...>)
{
    errorsOf<Error>(m, end - begin, errors, (points.column[K] + begin)...);
}

template <class Error>
void errorKernel(const Correspondences& points, const float* model, int begin, int end,
                 float* errors)
{
    float m[Error::NUMBERS];
    for (int i = 0; i < Error::NUMBERS; ++i)
        m[i] = model[i];
    errorsOf<Error>(points, m, begin, end, errors, typename IndicesTo<Error::COLUMNS>::Type());
}

struct MsacCost
{
    static inline float of(float error, float, float scale) { return msacCost(error, scale); }
};

//! 1 for an outlier, 0 for an inlier.
struct InlierCost
{
    static inline float of(float error, float limit, float) { return error <= limit ? 0.f : 1.f; }
};

//! Adds #LANES points to the partial sums. Compilers vectorize the loop, because its length is
//! constant and its arrays do not overlap.
template <class Error, class Cost, typename... Columns>
inline void addLanes(const float* m, float limit, float scale, float* USAC_RESTRICT cost,
                     int* USAC_RESTRICT inliers, const Columns* USAC_RESTRICT... column)
{
    USAC_SIMD
    for (int k = 0; k < LANES; ++k)
    {
        const float e = squaredOf<Error>(m, column[k]...);
        cost[k] += Cost::of(e, limit, scale);
        inliers[k] += e <= limit ? 1 : 0;
    }
}

template <class Error, class Cost, int... K>
inline void scoreOf(const Correspondences& points, const float* m, float limit, int begin, int end,
                    Quality& sum, Indices<K...>)
{
    const float scale = 1 / limit;
    float cost[LANES] = {0};
    int inliers[LANES] = {0};
    int i = begin;
    for (; i + LANES <= end; i += LANES)
        addLanes<Error, Cost>(m, limit, scale, cost, inliers, (points.column[K] + i)...);
    for (int k = 0; i < end; ++i, ++k)
    {
        const float e = squaredOf<Error>(m, points.column[K][i]...);
        cost[k] += Cost::of(e, limit, scale);
        inliers[k] += e <= limit ? 1 : 0;
    }
    for (int width = LANES / 2; width > 0; width /= 2)
        for (int k = 0; k < width; ++k)
        {
            cost[k] += cost[k + width];
            inliers[k] += inliers[k + width];
        }
    sum.cost += cost[0];
    sum.inliers += inliers[0];
}

template <class Error, class Cost>
void scoreKernel(const Correspondences& points, const float* model, float limit, int begin, int end,
                 Quality& sum)
{
    float m[Error::NUMBERS];
    for (int i = 0; i < Error::NUMBERS; ++i)
        m[i] = model[i];
    scoreOf<Error, Cost>(points, m, limit, begin, end, sum,
                         typename IndicesTo<Error::COLUMNS>::Type());
}

//! The kernels of a formula.
template <class Error>
ResidualKernels kernelsFor()
{
    typedef typename SumsOf<Error>::Type Sums;
    const ResidualKernels kernels = {errorKernel<Error>,
                                     scoreKernel<Error, MsacCost>,
                                     scoreKernel<Error, InlierCost>,
                                     sumsKernel<Error>,
                                     costKernel<Error>,
                                     leverageKernel<Error>,
                                     Error::COLUMNS,
                                     Sums::COUNT,
                                     Sums::toEquations};
    return kernels;
}

}  // namespace
}  // namespace usacv20
}  // namespace cv
