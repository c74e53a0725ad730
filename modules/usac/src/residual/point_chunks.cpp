// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "residual/point_chunks.hpp"

namespace cv {
namespace usacv20 {

PointChunks::PointChunks(const Correspondences& points_, const int* indices_, int count,
                         const double* weights_, Arena* arena)
    : points(points_), indices(indices_), weights(weights_), size(count),
      chunks((count + SUMS_CHUNK - 1) / SUMS_CHUNK),
      columns(points_.noise == 1 ? points_.columns() : points_.numbers()), stride(columns + 1),
      scope(arena ? *arena : own), rows(few)
{
    CV_DbgAssert(count > 0);
    if (chunks * stride > STORED_ROWS)
    {
        rows = 0;
        return;
    }
    if (chunks * stride > LOCAL_ROWS)
        rows = scope.take<Row>((size_t)chunks * stride);
    for (int c = 0; c < chunks; ++c)
        copy(c, rows + c * stride);
}

const PointChunks::Row* PointChunks::chunk(int index, Row* memory) const
{
    if (rows)
        return rows + index * stride;
    copy(index, memory);
    return memory;
}

void PointChunks::copy(int index, Row* chunk) const
{
    const int first = index * SUMS_CHUNK, here = std::min(size - first, SUMS_CHUNK);
    if (columns == TWO_VIEW_ROWS - 1)
        gather(first, here, std::integral_constant<int, TWO_VIEW_ROWS - 1>(), chunk);
    else
        gather(first, here, columns, chunk);
    if (points.noise == 1)
        weigh(first, here, chunk);
}

//! @param width number of columns; for two views, a std::integral_constant, so that the compiler
//! knows the number
template <class Width>
void PointChunks::gather(int first, int here, Width width, Row* chunk) const
{
    for (int k = 0; k < here; ++k)
    {
        const int i = indices[first + k];
        for (int column = 0; column < width; ++column)
            chunk[column][k] = points.exact[column][i];
        chunk[width][k] = weights ? weights[first + k] : 1;
    }
    for (int row = 0; row <= width; ++row)  // pads with copies of the last point, of weight 0
        std::fill(chunk[row] + here, chunk[row] + SUMS_CHUNK,
                  row < width ? chunk[row][here - 1] : 0.);
}

//! Multiplies the weights by the squared factors of the errors.
void PointChunks::weigh(int first, int here, Row* chunk) const
{
    for (int k = 0; k < here; ++k)
    {
        const double factor = points.exact[columns][indices[first + k]];
        chunk[columns][k] *= factor * factor;
    }
}

bool PointChunks::get(int index, double* datum, double& weight) const
{
    if (index >= size)
        return false;
    const int i = indices[index];
    for (int column = 0; column < columns + (points.noise == 1); ++column)
        datum[column] = points.exact[column][i];
    weight = weights ? weights[index] : 1;
    return true;
}

namespace {

//! The sum of SUMS_LANES numbers; the two halves are added first, then the halves of the result.
inline double sumOfLanes(const double* lanes)
{
    CV_StaticAssert(SUMS_LANES == 8, "three steps add eight lanes");
    double four[4], two[2];
    for (int k = 0; k < 4; ++k)
        four[k] = lanes[k] + lanes[k + 4];
    for (int k = 0; k < 2; ++k)
        two[k] = four[k] + four[k + 2];
    return two[0] + two[1];
}

}  // namespace

void PointChunks::sum(SumsKernel kernel, int count, const double* model, double* sums) const
{
    static const double zeros[MAX_SUMS][SUMS_LANES] = {{0}};
    double lanes[MAX_SUMS][SUMS_LANES];
    std::memcpy(lanes, zeros,
                count * sizeof(lanes[0]));  // std::fill would be compiled to a slow instruction
    Row memory[MAX_ROWS];
    for (int c = 0; c < chunks; ++c)
        kernel(chunk(c, memory), model, lanes);
    for (int i = 0; i < count; ++i)
        sums[i] = sumOfLanes(lanes[i]);
}

void PointChunks::leverages(LeverageKernel kernel, const double* model, const double* L,
                            double* result) const
{
    Row memory[MAX_ROWS];
    for (int c = 0; c < chunks; ++c)
    {
        double here[SUMS_CHUNK];
        kernel(chunk(c, memory), model, L, here);
        const int first = c * SUMS_CHUNK;
        std::copy(here, here + std::min(size - first, SUMS_CHUNK), result + first);
    }
}

}  // namespace usacv20
}  // namespace cv
