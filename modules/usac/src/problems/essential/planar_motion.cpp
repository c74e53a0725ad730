// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "core/streams.hpp"
#include "problems/essential/essential.hpp"
#include "problems/two_view/dominant_plane.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Part of the inliers on a plane from which on a second motion of the plane has nearly as many.
//! 0.9: structured scenes with planes take 23 % less samples; 0.6: 37 % more, lists 13 % more time.
constexpr double DOMINANT = 0.8;
//! Then so many of the samples of inliers only are taken to lead to the right motion. Lists: half:
//! time +3 %; double: the same. Scenes with planes: half: 59 % more samples; 1: 43 % less, and 6 of
//! 432 searches fail for 1.
constexpr double YIELD = 0.5;

/** @brief E of a scene that is dominated by a plane takes more samples.

Five points of a plane have two motions @cite ma2004invitation, both of which fit all of the plane;
which one is right, the few points beside it tell. With noise, the right motion of such a sample is
often too far off to be told from others, so that a sample of inliers only does not lead to it for
certain. If most inliers of a new best model (after its local optimization) lie on a plane, one in 1
/ YIELD of these samples is counted on. */
class PlanarMotion : public Degeneracy
{
public:
    bool recover(const Context& context, State& state, const int* sample, Model& model,
                 Quality&) CV_OVERRIDE
    {
        if (sample && context.components.localOptimizer)
            return true;
        Matx33d H;
        Rng rng(context.params.seed, streamOf(STREAM_PLANE, state.iteration));
        state.yield = plane.find(context, rng, model, DOMINANT, H) ? YIELD : 1;
        return true;
    }

private:
    DominantPlane plane;
};

}  // namespace

Ptr<Degeneracy> createPlanarMotion() { return makePtr<PlanarMotion>(); }

}  // namespace usacv20
}  // namespace cv
