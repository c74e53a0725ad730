// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "samplers/samplers.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** @brief NAPSAC: any point and its neighbours @cite nasuto2002napsac.

The first point is uniform, the others are uniform among its neighbours in the finest layer of the graph with 2 m members,
so that a point has more than one sample, or in the coarsest one if that has m. A point with fewer is most likely a wrong match.
The paper gives the sample up; here another first point is drawn, which is the same without a lost iteration. Where #TRIES of them
have too few neighbours, hardly any point has enough, and the sample is drawn from all points. */
class NapsacSampler : public Sampler
{
public:
    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize(), size = context.points.size;
        state.subsetSize = size;
        for (int i = 0; i < TRIES; ++i)
        {
            sample[0] = state.rng.uniform(size);
            const int* members;
            const int count = surroundings(context, m, sample[0], members);
            if (count >= m)
            {
                drawOthers(state.rng, members, count, m, sample);
                return;
            }
        }
        state.rng.distinct(size, m, sample);
    }

private:
    enum { TRIES = 100 };

    static int surroundings(const Context& context, int m, int centre, const int*& members)
    {
        Neighbourhood& neighbourhood = *context.components.neighbourhood;
        int count = 0;
        for (int layer = 0; layer < neighbourhood.layers() && count < 2 * m; ++layer)
            count = neighbourhood.members(context, layer, centre, members);
        return count;
    }
};

} // namespace

Ptr<Sampler> createNapsacSampler()
{
    return makePtr<NapsacSampler>();
}

} // namespace usacv20
} // namespace cv
