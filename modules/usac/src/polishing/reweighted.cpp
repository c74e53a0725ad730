// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "optimization/marginalized_fit.hpp"
#include "polishing/polishing.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! A fit that lowers the loss by less than this part of it is the last. Half, double: errors the
//! same.
constexpr double SETTLED = 1e-5;

/** Re-weighted least squares over all points with the weights of MAGSAC++ @cite barath2020magsac,
within the threshold of the score. A fit is taken while it lowers the loss of these weights, which
the theory promises of each: that loss is what it minimizes, so not the cost of the run's own
quality but this decides. */
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
            if (before - loss < SETTLED * before)
                return;
        }
    }
};

}  // namespace

Ptr<Polisher> createReweightedPolisher() { return makePtr<ReweightedPolisher>(); }

}  // namespace usacv20
}  // namespace cv
