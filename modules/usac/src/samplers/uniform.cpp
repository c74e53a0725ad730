// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "samplers/samplers.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Draws samples so that all samples of distinct points are equally likely
@cite fischler1981random. */
class UniformSampler : public Sampler
{
public:
    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        state.rng.distinct(context.points.size, context.components.minimalSolver->sampleSize(),
                           sample);
    }
};

}  // namespace

Ptr<Sampler> createUniformSampler() { return makePtr<UniformSampler>(); }

}  // namespace usacv20
}  // namespace cv
