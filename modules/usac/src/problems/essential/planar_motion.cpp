// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/streams.hpp"
#include "problems/essential/essential.hpp"
#include "problems/two_view/dominant_plane.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! A plane dominates the scene if more than this fraction of the inliers lies on it: the wrong
//! motion that explains the plane then has nearly as many inliers as the right one. See
//! doc/constants.md.
constexpr double DOMINANT = 0.8;
//! Assumed fraction of the all-inlier samples that lead to the correct motion if a plane dominates.
//! A smaller value makes the search draw more samples. See doc/constants.md.
constexpr double SUCCESS = 0.5;

/** @brief Raises the number of samples for E if a plane dominates the scene.

Two camera motions explain five points of a plane @cite ma2004invitation, and both motions fit the
whole plane; only the few points off the plane show which motion is right. With noise, the correct
motion computed from five points of the plane is often too inaccurate to have more inliers than the
wrong motion. If most inliers of the best model lie on a plane, the termination criteria therefore
assume that only the fraction SUCCESS of the all-inlier samples leads to the correct motion. */
class PlanarMotion : public Degeneracy
{
public:
    double successProbability(const Context& context, const State& state,
                              const Model& model) CV_OVERRIDE
    {
        Matx33d H;
        Rng rng(context.params.seed, streamOf(STREAM_PLANE, state.iteration));
        return plane.find(context, rng, model, DOMINANT, H) ? SUCCESS : 1;
    }

private:
    DominantPlane plane;
};

}  // namespace

Ptr<Degeneracy> createPlanarMotion() { return makePtr<PlanarMotion>(); }

}  // namespace usacv20
}  // namespace cv
