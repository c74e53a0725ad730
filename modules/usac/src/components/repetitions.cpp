// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/repetitions.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! A match is frequent if at least OFTEN of its occurrences are among the first FIRST_POINTS
//! matches, a random subset, and if all its occurrences make up more than 1 / COMMON of all
//! matches. See doc/constants.md.
constexpr int FIRST_POINTS = 64, OFTEN = 3, COMMON = MOST_FREQUENT + 1;

bool sameMatch(const double* const* columns, int numbers, int row, int other)
{
    bool same = true;
    for (int k = 0; same && k < numbers; ++k)
        same = columns[k][row] == columns[k][other];
    return same;
}

template <int DIMENSIONS>
uint64 hashOf(const Vec<double, DIMENSIONS>& cell)
{
    const uint64 factor = 0x9e3779b97f4a7c15ULL;
    uint64 bits[DIMENSIONS], h = 0;
    std::memcpy(bits, cell.val, sizeof(bits));
    // a small integer stored as double has only high bits set, and a product moves bits only
    // upward; the high half is therefore mixed into the low half
    for (int k = 0; k < DIMENSIONS; ++k)
    {
        h = (h ^ bits[k]) * factor;
        h ^= h >> 32;
    }
    return h * factor >> 32;
}

/** Marks the inliers whose cell contains an earlier inlier, with a hash table and linear probing.
Cell indices are doubles, because with small cells they can exceed the range of int. */
template <int DIMENSIONS>
void markInCells(const double* const* columns, const int* order, const uchar* mask, int count,
                 double side, uchar* repeated, Arena& arena)
{
    typedef Vec<double, DIMENSIONS> Cell;
    Arena::Scope scope(arena);
    const int most = count - (int)std::count(mask, mask + count, (uchar)0);
    Cell* const cells = scope.take<Cell>(most);
    int* const rows = scope.take<int>(most);
    int marked = 0, size = 1;
    for (int i = 0; i < count; ++i)
        if (mask[i])
        {
            const int point = order ? order[i] : i;
            for (int k = 0; k < DIMENSIONS; ++k)
                cells[marked][k] = (side > 0 ? std::floor(columns[k][point] / side)
                                             : columns[k][point]) +
                                   0.;  // turns -0 into 0, because the bits of the two differ
            rows[marked++] = i;
        }
    while (size < 2 * marked)
        size *= 2;
    int* const slots = scope.take<int>(size);
    std::fill(slots, slots + size, -1);  // -1 marks a free slot
    for (int i = 0; i < marked; ++i)
    {
        int at = (int)(hashOf<DIMENSIONS>(cells[i]) & (uint64)(size - 1));
        while (slots[at] >= 0 && cells[slots[at]] != cells[i])
            at = (at + 1) & (size - 1);
        repeated[rows[i]] |= slots[at] >= 0;
        slots[at] = slots[at] >= 0 ? slots[at] : i;
    }
}

}  // namespace

int independentInliers(const double* const* columns, const int* coordinates, const uchar* mask,
                       int count, double threshold1, double threshold2, Arena& arena)
{
    Arena::Scope scope(arena);
    uchar *const repeated1 = scope.take<uchar>(count), *const repeated2 = scope.take<uchar>(count);
    std::fill(repeated1, repeated1 + count, (uchar)0);
    std::fill(repeated2, repeated2 + count, (uchar)0);
    const int repetitions = std::max(
        markRepeated(columns, coordinates[0], 0, mask, count, threshold1, repeated1, arena),
        markRepeated(columns + coordinates[0], coordinates[1], 0, mask, count, threshold2,
                     repeated2, arena));
    int inliers = 0;
    for (int i = 0; i < count; ++i)
        inliers += mask[i] != 0;
    return inliers - repetitions;
}

int markRepeated(const double* const* columns, int dimensions, const int* order, const uchar* mask,
                 int count, double side, uchar* repeated, Arena& arena)
{
    if (dimensions == 1)
        markInCells<1>(columns, order, mask, count, side, repeated, arena);
    else if (dimensions == 2)
        markInCells<2>(columns, order, mask, count, side, repeated, arena);
    else if (dimensions == 3)
        markInCells<3>(columns, order, mask, count, side, repeated, arena);
    int sum = 0;
    for (int i = 0; i < count; ++i)
        sum += repeated[i];
    return sum;
}

bool inliersAreNearAPoint(const Problem& problem)
{
    return problem.coordinates(1) == 0 && problem.errorDimension() == problem.coordinates(0);
}

int markRepeated(const Correspondences& p, const int* order, const uchar* mask, int count,
                 double threshold, uchar* repeated, Arena& arena)
{
    if (inliersAreNearAPoint(*p.problem))
        threshold = 0;
    const double threshold1 = p.problem->commonUnit()
                                  ? threshold * p.frame[0].scale / p.frame[1].scale
                                  : 0;
    markRepeated(p.exact, p.coordinates[0], order, mask, count, threshold1, repeated, arena);
    return markRepeated(p.exact + p.coordinates[0], p.coordinates[1], order, mask, count, threshold,
                        repeated, arena);
}

int frequentMatches(const double* const* columns, int numbers, const int* rows, int count,
                    int* frequent)
{
    const int looked = std::min(count, FIRST_POINTS);
    double first[FIRST_POINTS];
    for (int i = 0; i < looked; ++i)
        first[i] = columns[0][rows[i]];
    int found = 0;
    for (int i = 0; i < looked; ++i)
    {
        int equal = 0;
        for (int k = 0; k <= i; ++k)  // fast preliminary test, without branches
            equal += first[k] == first[i];
        const auto same = [=](int row) { return sameMatch(columns, numbers, row, rows[i]); };
        if (equal >= OFTEN && std::count_if(rows, rows + i + 1, same) == OFTEN &&
            std::count_if(rows, rows + count, same) * COMMON > count)
            frequent[found++] = rows[i];
    }
    return found;
}

bool repeatsAny(const double* const* columns, int numbers, int row, const int* frequent, int count)
{
    bool repeats = false;
    for (int k = 0; k < count && !repeats; ++k)
        repeats = row != frequent[k] && sameMatch(columns, numbers, row, frequent[k]);
    return repeats;
}

}  // namespace usacv20
}  // namespace cv
