// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/bits.hpp"
#include "ordering/ordering.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Bits for each match in the sets of hash values, at least: about 1 / BITS_PER_MATCH of the
//! matches share their bit with another match by chance. The value has no effect on the result.
constexpr int BITS_PER_MATCH = 16;

unsigned hashOf(const Correspondences& p, int i)
{
    uint64 h = 0;
    for (int k = 0; k < p.columns(); ++k)
    {
        const float value = p.column[k][i] + 0.f;  // turns -0 into 0, because their bits differ
        unsigned bits;
        std::memcpy(&bits, &value, sizeof(bits));
        h = (h ^ (h >> 32) ^ bits) * 0xbf58476d1ce4e5b9ULL;
    }
    return (unsigned)(h >> 32);
}

bool same(const Correspondences& p, int i, int k)
{
    for (int c = 0; c < p.columns(); ++c)
        if (p.column[c][i] != p.column[c][k])
            return false;
    return true;
}

/** Lists the places in the order whose matches might be repeated: their hash values share a bit
with another match. This takes no branches, which would often be mispredicted.
@param hash output: hash value of each match
@param places output: at most Correspondences::size places, ascending
@return number of places */
int placesToCompare(const Context& context, const int* order, unsigned* hash, int* places)
{
    const Correspondences& points = context.points;
    int words = 1;
    while ((int64)words * WORD_BITS < (int64)points.size * BITS_PER_MATCH)
        words *= 2;
    Arena::Scope scope(context.arena);
    uint64 *const once = scope.take<uint64>(words), *const twice = scope.take<uint64>(words);
    std::fill(once, once + words, 0);
    std::fill(twice, twice + words, 0);
    for (int i = 0; i < points.size; ++i)
    {
        hash[i] = hashOf(points, i);
        const uint64 bit = (uint64)1 << (hash[i] % WORD_BITS);
        const unsigned word = hash[i] / WORD_BITS & (words - 1);
        twice[word] |= once[word] & bit;
        once[word] |= bit;
    }
    int count = 0;
    for (int k = 0; k < points.size; ++k)
    {
        const unsigned h = hash[order[k]];
        places[count] = k;
        count += twice[h / WORD_BITS & (words - 1)] >> (h % WORD_BITS) & 1;
    }
    return count;
}

//! Moves the items at `count` ascending places to the end; `places` is overwritten.
void moveLast(int* items, int size, int* places, int count)
{
    if (count == 0)
        return;
    int* kept = items + places[0];
    for (int k = 0; k < count; ++k)
    {
        const int begin = places[k] + 1, end = k + 1 < count ? places[k + 1] : size;
        places[k] = items[begin - 1];
        kept = std::copy(items + begin, items + end, kept);
    }
    std::copy(places, places + count, kept);
}

}  // namespace

void repeatedLast(const Context& context, int* order)
{
    const Correspondences& points = context.points;
    Arena::Scope scope(context.arena);
    unsigned* const hash = scope.take<unsigned>(points.size);
    int* const places = scope.take<int>(points.size);
    const int count = placesToCompare(context, order, hash, places);
    int mask = 1;
    while (mask < 2 * count)
        mask *= 2;
    int* const table = scope.take<int>(mask);
    std::fill(table, table + mask, -1);
    --mask;
    int repetitions = 0;
    for (int k = 0; k < count; ++k)
    {
        const int point = order[places[k]];
        int at = (int)(hash[point] / WORD_BITS) & mask;
        while (table[at] >= 0 && !same(points, table[at], point))
            at = (at + 1) & mask;
        if (table[at] >= 0)
            places[repetitions++] = places[k];
        else
            table[at] = point;
    }
    moveLast(order, points.size, places, repetitions);
}

}  // namespace usacv20
}  // namespace cv
