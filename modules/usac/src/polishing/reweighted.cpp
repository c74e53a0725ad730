// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "optimization/marginalized_fit.hpp"
#include "polishing/polishing.hpp"
#include "scoring/marginalized_weights.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! A fit that lowers the loss by less than this fraction is the last one.
constexpr double SETTLED_LOSS = 1e-5;

/** Iteratively re-weighted least squares over all points within Score::threshold(), with the
weights of MAGSAC++ @cite barath2020magsac. Fits are accepted as long as they lower the loss
that belongs to these weights, even if the cost under the score of the run increases. */
class ReweightedPolisher : public Polisher
{
public:
    void polish(const Context& context, Model& model) CV_OVERRIDE
    {
        Arena::Scope scope(context.arena);
        MarginalizedFit reweighted;
        reweighted.allocate(scope, context.points.size);
        const double threshold = context.components.score->threshold(context, model);
        double loss = reweighted.weigh(context, threshold, model);
        const double work = context.points.size * FIT_WORK;
        for (int i = 0; i < context.params.polishingSteps &&
                        !(i > 0 ? context.stop() : context.stopBefore(work));
             ++i)
        {
            Model fitted = model;
            if (!reweighted.fit(context, fitted))
                return;
            const double before = loss;
            loss = reweighted.weigh(context, threshold, fitted);
            if (!(loss < before))
                return;
            model = fitted;
            if (before - loss < SETTLED_LOSS * before)
                return;
        }
    }

    double support(const Context& context, const float*) const CV_OVERRIDE
    {
        return context.points.threshold;
    }

    double weight(double square, int degrees) const CV_OVERRIDE
    {
        return MarginalizedWeights::of(degrees).tabulatedWeight((float)square);
    }
};

}  // namespace

Ptr<Polisher> createReweightedPolisher() { return makePtr<ReweightedPolisher>(); }

}  // namespace usacv20
}  // namespace cv
