// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "ordering/ordering.hpp"

namespace cv {
namespace usacv20 {

namespace {

uint64 hashOf(const Correspondences& p, int i)
{
    uint64 h = 0;
    for (int k = 0; k < p.columns(); ++k)
    {
        const float value = p.column[k][i] + 0.f;  // turns -0 into 0, because their bits differ
        unsigned bits;
        std::memcpy(&bits, &value, sizeof(bits));
        h = (h ^ (h >> 32) ^ bits) * 0xbf58476d1ce4e5b9ULL;
    }
    return h >> 32;
}

bool same(const Correspondences& p, int i, int k)
{
    for (int c = 0; c < p.columns(); ++c)
        if (p.column[c][i] != p.column[c][k])
            return false;
    return true;
}

}  // namespace

void repeatedLast(const Context& context, int* order)
{
    const Correspondences& points = context.points;
    int mask = 1;
    while (mask < 2 * points.size)
        mask *= 2;
    Arena::Scope scope(context.arena);
    int *const table = scope.take<int>(mask), *const repeated = scope.take<int>(points.size);
    std::fill(table, table + mask, -1);
    --mask;
    int kept = 0, repetitions = 0;
    for (int i = 0; i < points.size; ++i)
    {
        const int point = order[i];
        int at = (int)hashOf(points, point) & mask;
        while (table[at] >= 0 && !same(points, table[at], point))
            at = (at + 1) & mask;
        if (table[at] >= 0)
        {
            repeated[repetitions++] = point;
            continue;
        }
        table[at] = point;
        order[kept++] = point;
    }
    std::copy(repeated, repeated + repetitions, order + kept);
}

}  // namespace usacv20
}  // namespace cv
