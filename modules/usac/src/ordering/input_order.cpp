// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "ordering/ordering.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** The caller's order, best first. */
class InputOrderOrdering : public Ordering
{
public:
    void sort(const Context& context, std::vector<int>& order) CV_OVERRIDE
    {
        std::vector<int> place(context.points.inputSize, -1);
        for (int i = 0; i < context.points.size; ++i)
            place[context.points.inputIndex[i]] = i;
        order.clear();
        for (size_t i = 0; i < place.size(); ++i)
            if (place[i] >= 0)
                order.push_back(place[i]);
    }
};

}  // namespace

Ptr<Ordering> createInputOrderOrdering() { return makePtr<InputOrderOrdering>(); }

}  // namespace usacv20
}  // namespace cv
