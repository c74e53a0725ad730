// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "neighbourhood/neighbourhood.hpp"

namespace cv {
namespace usacv20 {

namespace {

struct ByValue
{
    explicit ByValue(const float* values_) : values(values_) {}
    bool operator()(int a, int b) const { return values[a] < values[b] || (values[a] == values[b] && a < b); }
    const float* values;
};

void sortBy(const float* values, std::vector<int>& order)
{
    for (size_t i = 0; i < order.size(); ++i)
        order[i] = (int)i;
    std::sort(order.begin(), order.end(), ByValue(values));
}

/** Given scores, best first. */
class ScorePrior : public Prior
{
public:
    void sort(const Context& context, std::vector<int>& order) CV_OVERRIDE { sortBy(context.points.scores, order); }
};

/** The caller's order, best first. */
class InputOrderPrior : public Prior
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

/** Local density of the points in the joint space, densest first: right matches come in groups, wrong ones do not (paper,
section "Other features"). The density is the mean over the layers of the neighbourhood of points per volume; with cells
of half the width in each layer, a point of a cell counts 16 times as much as one of the next coarser layer. */
class DensityPrior : public Prior
{
public:
    void sort(const Context& context, std::vector<int>& order) CV_OVERRIDE
    {
        Neighbourhood& neighbourhood = *context.components.neighbourhood;
        std::vector<float> sparsity(order.size());
        const int* members;
        for (size_t i = 0; i < order.size(); ++i)
            for (int layer = neighbourhood.layers() - 1; layer >= 0; --layer)
                sparsity[i] = sparsity[i] / 16 - (neighbourhood.members(context, layer, (int)i, members) - 1);
        sortBy(sparsity.data(), order);
    }
};

} // namespace

Ptr<Prior> createDensityPrior()
{
    return makePtr<DensityPrior>();
}

Ptr<Prior> createScorePrior()
{
    return makePtr<ScorePrior>();
}

Ptr<Prior> createInputOrderPrior()
{
    return makePtr<InputOrderPrior>();
}

} // namespace usacv20
} // namespace cv
