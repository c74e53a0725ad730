// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "ordering/ordering.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! BUCKETS: number of ranks that are distinguished. ORDERING_OTHERS: number that is added to the
//! number of points that share only one of the two cells of a match, so that a few points do not
//! give a high fraction (see DensityOrdering).
constexpr int BUCKETS = 64, ORDERING_OTHERS = 3;

//! The box of the points of an array is divided into CELL_DIVISIONS cells along each of two axes,
//! which gives CELLS cells in total. See doc/constants.md.
constexpr int CELL_DIVISIONS = 8, CELLS = CELL_DIVISIONS * CELL_DIVISIONS;

int division(float value, float low, float scale)
{
    const float cell = (value - low) * scale, inside = cell > 0 ? cell : 0;
    return (int)(inside < CELL_DIVISIONS - 1.f ? inside : CELL_DIVISIONS - 1.f);
}

//! Finds the cell of each point from its first two coordinates in an array; a single coordinate
//! gives one row of cells.
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

/** @brief Orders matches by their local density in the joint space (x1, y1, x2, y2), relative to
their density in the images (@cite ivashechkin2021usacv20, section "Other features").

Each image is divided into cells, see assignCells(). Inliers come in groups: most of the points that
share an inlier's cell in image 1 or image 2 also share its cell in the other image. Points are
ordered by this fraction, largest first: it is s / (s + n + #ORDERING_OTHERS), where s is the number
of other points that share both cells, and n is the number of points that share only one of them
(the mean of the two images). The absolute density would put the most crowded regions of the images
first, whether their matches are right or wrong. Counting and a bucket sort take O(N). Points of
equal rank keep their pseudo-random order. */
class DensityOrdering : public Ordering
{
public:
    bool informative(const Context&) const CV_OVERRIDE { return false; }

    void sort(const Context& context, int* order) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        Arena::Scope scope(context.arena);
        ushort *const cells1 = scope.take<ushort>(p.size), *const cells2 = scope.take<ushort>(
                                                               p.size);
        assignCells(p, 0, cells1);
        assignCells(p, 1, cells2);
        int in1[CELLS] = {0}, in2[CELLS] = {0};
        int* const both = scope.take<int>(CELLS * CELLS);
        std::fill(both, both + CELLS * CELLS, 0);
        for (int i = 0; i < p.size; ++i)
        {
            ++in1[cells1[i]];
            ++in2[cells2[i]];
            ++both[cells1[i] * CELLS + cells2[i]];
        }
        uchar* const bucket = scope.take<uchar>(p.size);
        int start[BUCKETS + 1] = {0};
        for (int i = 0; i < p.size; ++i)
        {
            const int support = both[cells1[i] * CELLS + cells2[i]] - 1;
            const double others = 0.5 * (in1[cells1[i]] + in2[cells2[i]]) - 1 - support;
            bucket[i] = (uchar)((BUCKETS - 1) *
                                (1 - support / (support + others + ORDERING_OTHERS)));
            ++start[bucket[i] + 1];
        }
        for (int b = 0; b < BUCKETS; ++b)
            start[b + 1] += start[b];
        for (int i = 0; i < p.size; ++i)
            order[start[bucket[i]]++] = i;
    }
};

}  // namespace

Ptr<Ordering> createDensityOrdering() { return makePtr<DensityOrdering>(); }

}  // namespace usacv20
}  // namespace cv
