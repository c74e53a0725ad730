// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/joint_cells.hpp"

namespace cv {
namespace usacv20 {

namespace {

int division(float value, float low, float scale)
{
    const float cell = (value - low) * scale, inside = cell > 0 ? cell : 0;
    return (int)(inside < CELL_DIVISIONS - 1.f ? inside : CELL_DIVISIONS - 1.f);
}

//! Index of the enlarged cell (with a side `merged` times as long) that contains the given cell.
int merge(int cell, int merged)
{
    return cell / CELL_DIVISIONS / merged * CELL_DIVISIONS + cell % CELL_DIVISIONS / merged;
}

double pairsOf(const int* counts, int size)
{
    double sum = 0;
    for (int i = 0; i < size; ++i)
        sum += 0.5 * counts[i] * (counts[i] - 1.);
    return sum;
}

}  // namespace

void assignCells(const Correspondences& p, int array, ushort* cells)
{
    const int first = array ? p.coordinates[0] : 0, axes = std::min(p.coordinates[array], 2);
    std::fill(cells, cells + p.size, (ushort)0);
    for (int k = first; k < first + axes; ++k)
    {
        const float low = p.lower[k], range = p.upper[k] - low,
                    scale = range > 0 ? CELL_DIVISIONS / range : 0;
        const float* const values = p.column[k];
        for (int i = 0; i < p.size; ++i)
            cells[i] = (ushort)(cells[i] * CELL_DIVISIONS + division(values[i], low, scale));
    }
}

CellPairs::CellPairs(const Correspondences& p, const uchar* mask, uchar value, Arena& arena,
                     int merged)
    : cells(CELLS / (merged * merged))
{
    Arena::Scope scope(arena);
    ushort *const cells1 = scope.take<ushort>(p.size), *const cells2 = scope.take<ushort>(p.size);
    int *const in1 = scope.take<int>(CELLS), *const in2 = scope.take<int>(CELLS),
               *const inBoth = scope.take<int>(CELLS * CELLS);
    assignCells(p, 0, cells1);
    assignCells(p, 1, cells2);
    std::fill(in1, in1 + CELLS, 0);
    std::fill(in2, in2 + CELLS, 0);
    std::fill(inBoth, inBoth + CELLS * CELLS, 0);
    double size = 0;
    for (int i = 0; i < p.size; ++i)
        if (mask[i] == value)
        {
            ++size;
            const int first = merge(cells1[i], merged), second = merge(cells2[i], merged);
            ++in1[first];
            ++in2[second];
            ++inBoth[first * CELLS + second];
        }
    all = 0.5 * size * (size - 1);
    in[0] = pairsOf(in1, CELLS);
    in[1] = pairsOf(in2, CELLS);
    both = pairsOf(inBoth, CELLS * CELLS);
    expected = all > 0 ? in[0] * in[1] / all : 0;
    const double either = std::sqrt(in[0] * in[1]);
    coherence = either > 0 ? both / either : 0;
}

}  // namespace usacv20
}  // namespace cv
