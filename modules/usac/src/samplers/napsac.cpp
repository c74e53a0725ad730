// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "samplers/samplers.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! First points that are tried. Half, double: no run of the lists differs.
constexpr int TRIES = 100;

/** @brief NAPSAC: any point and its neighbors @cite nasuto2002napsac.

The first point is uniform, the others are uniform among its neighbors in the coarsest layer of the
graph. Finer layers find more samples of inliers only, but a model of points that are close to each
other is inaccurate and, where they lie on a plane, wrong: on an office scene they gave twice as
many wrong fundamental and essential matrices.

A point with fewer neighbors than a sample needs is most likely a wrong match. The paper gives the
sample up; here another first point is drawn, which is the same without a lost iteration. Where
#TRIES of them have too few neighbors, hardly any point has enough, and the sample is drawn from all
points. */
class NapsacSampler : public Sampler
{
public:
    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize(), size = context.points.size;
        Neighborhood& neighborhood = context.neighborhood();
        if (!isOrdered(context, state, sample))
            return;
        for (int i = 0; i < TRIES; ++i)
        {
            sample[0] = state.rng.uniform(size);
            const int* members;
            const int count = neighborhood.members(context, neighborhood.layers() - 1, sample[0],
                                                   members);
            if (count >= m)
            {
                drawOthers(state.rng, members, count, m, sample);
                return;
            }
        }
        state.rng.distinct(size, m, sample);
    }
};

}  // namespace

Ptr<Sampler> createNapsacSampler() { return makePtr<NapsacSampler>(); }

}  // namespace usacv20
}  // namespace cv
