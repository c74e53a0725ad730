// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "solvers/point_chunks.hpp"

namespace cv {
namespace usacv20 {

PointChunks::PointChunks(const Correspondences& points, const int* indices, int count, const double* weights)
    : chunks((count + SUMS_CHUNK - 1) / SUMS_CHUNK)
{
    rows.allocate((size_t)std::max(chunks, 1) * ROWS * SUMS_CHUNK);
    for (int c = 0; c < chunks; ++c)
    {
        Row* const chunk = (Row*)rows.data() + c * ROWS;
        for (int k = 0; k < SUMS_CHUNK; ++k)
        {
            const int wanted = c * SUMS_CHUNK + k, at = std::min(wanted, count - 1), i = indices[at];
            chunk[0][k] = points.dx1[i];
            chunk[1][k] = points.dy1[i];
            chunk[2][k] = points.dx2[i];
            chunk[3][k] = points.dy2[i];
            chunk[4][k] = wanted >= count ? 0 : weights ? weights[at] : 1;
        }
    }
}

void PointChunks::sum(SumsKernel kernel, int count, const double* model, bool swapped, double* sums) const
{
    double lanes[EPIPOLAR_SUMS][SUMS_LANES];
    std::fill(lanes[0], lanes[count], 0.);
    for (int c = 0; c < chunks; ++c)
    {
        const Row* chunk = (const Row*)rows.data() + c * ROWS;
        Row exchanged[ROWS];
        if (swapped)
        {
            std::memcpy(exchanged, chunk + 2, 2 * sizeof(Row));
            std::memcpy(exchanged + 2, chunk, 2 * sizeof(Row));
            std::memcpy(exchanged + 4, chunk + 4, sizeof(Row));
            chunk = exchanged;
        }
        kernel(chunk, model, lanes);
    }
    for (int i = 0; i < count; ++i)
    {
        double* l = lanes[i];
        for (int width = SUMS_LANES / 2; width > 0; width /= 2)
            for (int k = 0; k < width; ++k)
                l[k] += l[k + width];
        sums[i] = l[0];
    }
}

} // namespace usacv20
} // namespace cv
