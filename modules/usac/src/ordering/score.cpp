// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "ordering/ordering.hpp"

namespace cv {
namespace usacv20 {

namespace {

struct ByValue
{
    explicit ByValue(const float* values_) : values(values_) {}
    bool operator()(int a, int b) const
    {
        return values[a] < values[b] || (values[a] == values[b] && a < b);
    }
    const float* values;
};

/** Orders points by Params::scores so that the best point comes first. Points of equal score keep
their pseudo-random order, and repeated matches come last. Takes O(N log N). */
class ScoreOrdering : public Ordering
{
public:
    void sort(const Context& context, int* order) CV_OVERRIDE
    {
        const int size = context.points.size;
        for (int i = 0; i < size; ++i)
            order[i] = i;
        std::sort(order, order + size, ByValue(context.points.scores));
        repeatedLast(context, order);
    }
};

}  // namespace

Ptr<Ordering> createScoreOrdering() { return makePtr<ScoreOrdering>(); }

}  // namespace usacv20
}  // namespace cv
