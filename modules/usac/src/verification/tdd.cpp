// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/sample_statistics.hpp"
#include "verification/verification.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Largest d that Params::check allows.
constexpr int MAX_POINTS = 100;

/** @brief T(d,d) test: a model is rejected unless d random points are all inliers
@cite matas2004randomized.

The d points are drawn anew for each model, before the model is tested on blocks of points.
Consecutive points of a block are not suitable: if there are few points, it can happen that no d
inliers are consecutive, so that no model at all would pass. Let epsilon and delta be the inlier
ratios of a good and of a wrong model. A good model passes with probability epsilon^d, a wrong one
with probability delta^d, and the test of a wrong model takes (1 - delta^d) / (1 - delta) points on
average. More samples compensate for rejected good models, see keptProbability(). */
class TddVerifier : public Verifier
{
public:
    explicit TddVerifier(int points_) : points(points_) {}

    bool preTest(const Context& context, const Model& model, Rng& rng, int& inliers,
                 int& tested) const CV_OVERRIDE
    {
        const int d = std::min(points, context.points.size);
        const float limit = (float)(context.inlierThreshold() * context.inlierThreshold());
        int chosen[MAX_POINTS];
        for (inliers = tested = 0; tested < d; ++inliers)
        {
            do
                chosen[tested] = rng.uniform(context.points.size);
            while (std::find(chosen, chosen + tested, chosen[tested]) != chosen + tested);
            const int point = chosen[tested++];
            float error;
            context.components.residual->squaredErrors(context.points, model, point, point + 1,
                                                       &error);
            if (!(error <= limit))  // NaN is rejected, too
                return false;
        }
        return true;
    }

    double keptProbability(const Context& context, double inliers,
                           bool withoutRepetition) const CV_OVERRIDE
    {
        const int n = context.points.size;
        return goodSampleProbability(inliers, n, std::min(points, n), withoutRepetition);
    }

    int nextBlock(int) const CV_OVERRIDE { return 256; }
    bool proceed(int, int) const CV_OVERRIDE { return true; }
    void sampleTested(State&, int, int) CV_OVERRIDE {}
    void adapt(const Context&, State&) CV_OVERRIDE {}

private:
    const int points;
};

}  // namespace

Ptr<Verifier> createTddVerifier(int points)
{
    CV_Assert(points >= 1 && points <= MAX_POINTS);
    return makePtr<TddVerifier>(points);
}

}  // namespace usacv20
}  // namespace cv
