// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "ordering/ordering.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Keeps the order of the caller's arrays, which the caller has sorted so that the best matches
come first. If there are scores, ScoreOrdering is used instead. */
class InputOrderOrdering : public Ordering
{
public:
    void sort(const Context& context, int* order) CV_OVERRIDE
    {
        const int rows = context.points.inputSize;
        Arena::Scope scope(context.arena);
        int* const place = scope.take<int>(rows);
        std::fill(place, place + rows, -1);
        for (int i = 0; i < context.points.size; ++i)
            place[context.points.inputIndex[i]] = i;
        for (int i = 0; i < rows; ++i)
            if (place[i] >= 0)
                *order++ = place[i];
    }
};

}  // namespace

Ptr<Ordering> createInputOrderOrdering() { return makePtr<InputOrderOrdering>(); }

}  // namespace usacv20
}  // namespace cv
