// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/growth.hpp"
#include "samplers/samplers.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** PROSAC @cite chum2005matching: samples are drawn from the n best points, and n grows slowly.
Each sample contains the n-th point, the newest one. When n has reached the number of all points,
samples are uniform. With Params::orderedEvery above 1, some earlier samples are uniform, too. */
class ProsacSampler : public Sampler
{
public:
    void start(const Context& context) CV_OVERRIDE
    {
        growth = GrowingSet(context.components.minimalSolver->sampleSize(), context.points.size);
    }

    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize();
        const bool known = orderIsKnown(context);
        if (known && !isOrderedByKnowledge(context, state, m, sample))
            return;
        growth.next();
        const int n = growth.size();
        if (!known && !isOrdered(context, state, m, sample))
            return;
        if (growth.newest())
        {
            state.rng.distinct(n - 1, m - 1, sample);
            sample[m - 1] = n - 1;
        }
        else
            state.rng.distinct(n, m, sample);
        const int* const order = state.bestFirst(context);
        for (int k = 0; k < m; ++k)
            sample[k] = order[sample[k]];
    }

    double growingShare(const Context& context) const CV_OVERRIDE
    {
        return 1. / context.params.orderedEvery;
    }

private:
    GrowingSet growth;
};

}  // namespace

Ptr<Sampler> createProsacSampler() { return makePtr<ProsacSampler>(); }

}  // namespace usacv20
}  // namespace cv
