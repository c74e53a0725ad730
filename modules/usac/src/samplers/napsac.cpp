// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "samplers/samplers.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Maximum number of first points that are tried for a sample, see NapsacSampler.
constexpr int MOST_CENTERS = 100;

/** @brief NAPSAC: a random point and some of its neighbors @cite nasuto2002napsac.

The first point of a sample is drawn uniformly from all points, the other points uniformly from the
neighbors of the first point in the coarsest layer of the neighborhood graph. Finer layers would
give more all-inlier samples, but a model of points close to each other is inaccurate, and F or E is
wrong if these points lie on a plane.

A point with fewer neighbors than a sample needs is most likely an outlier. The paper discards the
sample; here another first point is drawn, which has the same effect without a lost iteration. If
#MOST_CENTERS first points have too few neighbors, hardly any point has enough of them, and the
sample is drawn uniformly from all points. */
class NapsacSampler : public Sampler
{
public:
    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize(), size = context.points.size;
        Neighborhood& neighborhood = context.neighborhood();
        if (!isOrdered(context, state, m, sample))
            return;
        for (int i = 0; i < MOST_CENTERS; ++i)
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
