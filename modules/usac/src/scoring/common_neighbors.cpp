// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include <memory>
#include "scoring/common_neighbors.hpp"
#include "numeric/bits.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Number of matches whose neighbors are searched for together, in the lanes of a vector register
//! of any instruction set.
constexpr int LANES = 4;
//! Number of matches on each side that are looked at before the search checks whether all others
//! are too far away. The result does not depend on this number.
constexpr int STEP = 4;
//! Number of bits of the index of a match, see withIndex().
constexpr int INDEX_BITS = 8;
//! Matches with this squared distance or more are not neighbors; the value also stands for a
//! missing neighbor.
constexpr float NONE = 1e38f;

float square(float x) { return x * x; }

//! A squared distance whose lowest bits are replaced by the index of a match, which changes it by
//! at most 3e-5 of its value. The results are ordered by distance, then by index.
inline float withIndex(float squared, int index)
{
    int bits;
    std::memcpy(&bits, &squared, sizeof(bits));
    bits = (bits & -(1 << INDEX_BITS)) | index;
    std::memcpy(&squared, &bits, sizeof(bits));
    return squared;
}

inline int indexOf(float key)
{
    int bits;
    std::memcpy(&bits, &key, sizeof(bits));
    return bits & ((1 << INDEX_BITS) - 1);
}

//! A set of matches, one bit for each match.
struct Matches
{
    Matches() { std::fill(words, words + WORDS, (uint64)0); }

    void add(int index) { words[index / WORD_BITS] |= (uint64)1 << index % WORD_BITS; }
    int common(const Matches& others) const
    {
        int sum = 0;
        for (int k = 0; k < WORDS; ++k)
            sum += ones(words[k] & others.words[k]);
        return sum;
    }

    enum { WORDS = MATCHES_COMPARED / WORD_BITS };

    uint64 words[WORDS];
};

/** @brief Finds the nearest neighbors of each match in one image.

The matches are sorted by the x coordinates of their points. For #LANES successive matches at a
time, the others are looked at, those with near x first, until all further ones are too far away
along x. There are no branches on single distances, which would often be mispredicted. */
class NeighborSearch
{
public:
    //! @param same_, otherSame_ squared distances, in this image and in the other one, up to which
    //! two points count as the same point, so that their matches are not neighbors
    NeighborSearch(const Correspondences& p, int image, int count_, float same_, float otherSame_)
        : count(count_), same(same_), otherSame(otherSame_)
    {
        const float *const x = p.column[image ? X2 : X1], *const y = p.column[image ? Y2 : Y1],
                           *const otherX = p.column[image ? X1 : X2],
                           *const otherY = p.column[image ? Y1 : Y2];
        for (int i = 0; i < count; ++i)
            index[i] = i;
        std::sort(index, index + count,
                  [x](int a, int b) { return x[a] != x[b] ? x[a] < x[b] : a < b; });
        for (int k = 0; k < count + LANES; ++k)
        {
            const int i = index[std::min(k, count - 1)];
            place[0][k] = x[i];
            place[1][k] = y[i];
            place[2][k] = otherX[i];
            place[3][k] = otherY[i];
        }
    }

    void find(Matches* neighbors)
    {
        for (int first = 0; first < count; first += LANES)
        {
            findNearest(first);
            for (int lane = 0; lane < LANES && first + lane < count; ++lane)
                for (int k = 0; k < NEIGHBORS_COMPARED; ++k)
                    if (nearest[k][lane] < NONE)
                        neighbors[index[first + lane]].add(indexOf(nearest[k][lane]));
        }
    }

private:
    //! Sets `nearest` to the neighbors of the matches `first`, ..., `first` + LANES - 1.
    void findNearest(int first)
    {
        for (int n = 0; n < NEIGHBORS_COMPARED; ++n)
            std::fill(nearest[n], nearest[n] + LANES, NONE);
        int left = first - 1, right = std::min(first + LANES, count);
        for (int k = first; k < right; ++k)
            look(first, k);
        while (left >= 0 || right < count)
        {
            const float* const farthest = nearest[NEIGHBORS_COMPARED - 1];
            const float limit = *std::max_element(farthest, farthest + LANES);
            if (left >= 0 && withIndex(square(place[0][first] - place[0][left]), 0) > limit)
                left = -1;
            if (right < count &&
                withIndex(square(place[0][right] - place[0][first + LANES - 1]), 0) > limit)
                right = count;
            for (int end = std::max(left - STEP, -1); left > end; --left)
                look(first, left);
            for (int end = std::min(right + STEP, count); right < end; ++right)
                look(first, right);
        }
    }

    //! Adds the match `other` to the neighbors of those of the matches for which it is near enough.
    void look(int first, int other)
    {
        const float ax = place[0][other], ay = place[1][other], bx = place[2][other],
                    by = place[3][other];
        const int added = index[other];
        float key[LANES];
        USAC_SIMD
        for (int k = 0; k < LANES; ++k)
        {
            const float squared = square(place[0][first + k] - ax) +
                                  square(place[1][first + k] - ay);
            const float between = square(place[2][first + k] - bx) +
                                  square(place[3][first + k] - by);
            const bool neighbor = (squared > same) & (between > otherSame) & (squared < NONE);
            key[k] = neighbor ? withIndex(squared, added) : NONE;
        }
        for (int n = 0; n < NEIGHBORS_COMPARED; ++n)
            sortLanes(nearest[n], key);
    }

    //! Swaps those lanes of a and b in which b is smaller.
    static void sortLanes(float* USAC_RESTRICT a, float* USAC_RESTRICT b)
    {
        USAC_SIMD
        for (int k = 0; k < LANES; ++k)
        {
            const float x = a[k], y = b[k];
            const float low = x < y ? x : y, high = x < y ? y : x;
            a[k] = low;
            b[k] = high;
        }
    }

    const int count;
    const float same, otherSame;
    int index[MATCHES_COMPARED];               //!< the matches, by ascending x
    float place[4][MATCHES_COMPARED + LANES];  //!< x and y of the sorted matches in this image,
                                               //!< then in the other image
    float nearest[NEIGHBORS_COMPARED][LANES];  //!< for each of LANES matches, the distances of the
                                               //!< neighbors so far (withIndex()), nearest first
};

}  // namespace

bool hasCommonNeighbors(const Problem& problem)
{
    return problem.coordinates(0) == 2 && problem.coordinates(1) == 2 && problem.commonUnit() &&
           problem.errorDimension() == 1 && problem.dimension() >= 7;
}

void commonNeighbors(const Correspondences& points, int count, double threshold, uchar* common,
                     Arena& arena)
{
    CV_StaticAssert(MATCHES_COMPARED <= 1 << INDEX_BITS && MATCHES_COMPARED % WORD_BITS == 0,
                    "an index must fit into the bits, and the matches into whole words");
    CV_Assert(0 < count && count <= MATCHES_COMPARED);
    Arena::Scope scope(arena);
    Matches* neighbors[2];
    float same[2];
    for (int image = 0; image < 2; ++image)
        same[image] = (float)((image ? 1 : points.frame[0].scale / points.frame[1].scale) *
                              threshold);
    for (int image = 0; image < 2; ++image)
    {
        neighbors[image] = scope.take<Matches>(count);
        std::uninitialized_fill(neighbors[image], neighbors[image] + count, Matches());
        NeighborSearch(points, image, count, square(same[image]), square(same[1 - image]))
            .find(neighbors[image]);
    }
    for (int i = 0; i < count; ++i)
        common[i] = (uchar)neighbors[0][i].common(neighbors[1][i]);
}

}  // namespace usacv20
}  // namespace cv
