// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "ordering/ordering.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! A key for sorting: first by score, then by the index of the point. The bits of positive floats,
//! read as integers, have the same order as the floats; the bits of negative floats have the
//! inverse order.
uint64 keyOf(float score, int point)
{
    score += 0.f;  // turns -0 into 0, because their bits differ
    unsigned bits;
    std::memcpy(&bits, &score, sizeof(bits));
    bits = bits & 0x80000000u ? ~bits : bits | 0x80000000u;
    return (uint64)bits << 32 | (unsigned)point;
}

/** Orders points by Params::scores so that the best point comes first; in Correspondences::scores,
lower is always better. Points of equal score keep their pseudo-random order. Takes O(N log N) time.
*/
class ScoreOrdering : public Ordering
{
public:
    void sort(const Context& context, int* order) CV_OVERRIDE
    {
        const int size = context.points.size;
        Arena::Scope scope(context.arena);
        uint64* const keys = scope.take<uint64>(size);
        for (int i = 0; i < size; ++i)
            keys[i] = keyOf(context.points.scores[i], i);
        std::sort(keys, keys + size);
        for (int i = 0; i < size; ++i)
            order[i] = (int)(unsigned)keys[i];
    }
};

}  // namespace

Ptr<Ordering> createScoreOrdering() { return makePtr<ScoreOrdering>(); }

}  // namespace usacv20
}  // namespace cv
