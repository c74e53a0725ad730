// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Included by problems/kernels.inl.hpp, once for each instruction set.

#include "problems/fundamental/arcs.hpp"
#include "numeric/instruction_set.hpp"

namespace cv {
namespace usacv20 {
namespace {

/* A point is within the threshold for the epipole e if (e n)^2 <= e^T G e, where e n is a scalar
product, see PlaneParallax::setPlane(). For e = u + t v on a line, this becomes
A t^2 + 2 B t + C <= 0. The arc begins where this polynomial becomes negative, at
t = (-B - sqrt(D)) / A, and ends at (-B + sqrt(D)) / A; it passes through infinity if A is negative.
D = B^2 - A C is expanded, because the largest terms, r0^2 r1^2 with r0 = u n and r1 = v n, cancel.
If D <= 0, the point is within the threshold for every e on the line, because some e on the line
fulfills e n = 0. Then the point does not vote: its arc is from 0 to -1. */
void arcsKernel(const float* rows, int stride, const float* weights, int* USAC_RESTRICT from,
                int* USAC_RESTRICT to)
{
    const float *n0 = rows, *n1 = n0 + stride, *n2 = n1 + stride, *g00 = n2 + stride,
                *g01 = g00 + stride, *g02 = g01 + stride, *g11 = g02 + stride, *g12 = g11 + stride,
                *g22 = g12 + stride;
    float w[ARCS_WEIGHTS];
    for (int k = 0; k < ARCS_WEIGHTS; ++k)
        w[k] = weights[k];
    USAC_SIMD
    for (int k = 0; k < stride; ++k)
    {
        const float r0 = w[0] * n0[k] + w[1] * n1[k] + w[2] * n2[k],
                    r1 = w[3] * n0[k] + w[4] * n1[k] + w[5] * n2[k];
        const float d0 = w[6] * g00[k] + w[7] * g01[k] + w[8] * g02[k] + w[9] * g11[k] +
                         w[10] * g12[k] + w[11] * g22[k];
        const float d1 = w[12] * g00[k] + w[13] * g01[k] + w[14] * g02[k] + w[15] * g11[k] +
                         w[16] * g12[k] + w[17] * g22[k];
        const float d2 = w[18] * g00[k] + w[19] * g01[k] + w[20] * g02[k] + w[21] * g11[k] +
                         w[22] * g12[k] + w[23] * g22[k];
        const float A = r1 * r1 - d2, B = r0 * r1 - d1, C = r0 * r0 - d0;
        const float D = (d2 * r0 * r0 + d0 * r1 * r1 - 2 * d1 * r0 * r1) - (d0 * d2 - d1 * d1);
        const float root = sqrtf(D > 0 ? D : 0.f);
        const float q = B >= 0 ? -B - root : root - B;
        const int one = binOf(placeOf(q, A)), other = binOf(placeOf(C, q));
        const int begin = B >= 0 ? one : other, end = B >= 0 ? other : one;
        from[k] = D > 0 ? begin : 0;
        to[k] = D > 0 ? end : -1;
    }
}

}  // namespace
}  // namespace usacv20
}  // namespace cv
