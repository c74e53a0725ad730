// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Standard criterion: the number of samples that contain, with the given confidence, at least one
sample that consists of inliers and leads to a good model that the verifier keeps. Points that are
not inliers of the best model so far are assumed to be outliers @cite fischler1981random. */
class StandardTermination : public Termination
{
public:
    int iterations(const Context& context, const State& state) const CV_OVERRIDE
    {
        return samplesNeeded(goodModelProbability(context, state, state.bestQuality.inliers),
                             std::log(1 - context.params.confidence));
    }

    bool countsAll() const CV_OVERRIDE { return false; }
    int reason() const CV_OVERRIDE { return STOP_STANDARD; }
};

}  // namespace

Ptr<Termination> createStandardTermination() { return makePtr<StandardTermination>(); }

}  // namespace usacv20
}  // namespace cv
