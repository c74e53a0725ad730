// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "polishing/polishing.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Least squares over all inliers. The fit is repeated with the inliers of the new model while this
improves the score, but at most Params::polishingSteps times (last line of Algorithm 1 of
@cite ivashechkin2021usacv20). As only a better model is accepted, the inlier sets cannot cycle. */
class LeastSquaresPolisher : public Polisher
{
public:
    void polish(const Context& context, Model& model) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const Components& parts = context.components;
        const double limit = p.threshold * p.threshold;
        Arena::Scope scope(context.arena);
        double* const errors = scope.take<double>(p.size);
        int* const inliers = scope.take<int>(p.size);
        Quality quality = context.rate(model);
        const double work = context.points.size * FIT_WORK;
        for (int i = 0; i < context.params.polishingSteps &&
                        !(i > 0 ? context.stop() : context.stopBefore(work));
             ++i)
        {
            parts.residual->squaredErrors(model, p.exact, p.size, errors);
            int count = 0;
            for (int k = 0; k < p.size; ++k)
                if (errors[k] <= limit)
                    inliers[count++] = k;
            Model fitted = model;
            if (!context.nonMinimalSolver().fit(p, inliers, count, 0, fitted))
                return;
            const Quality fittedQuality = context.rate(fitted, quality.cost);
            if (!fittedQuality.betterThan(quality))
                return;
            model = fitted;
            quality = fittedQuality;
        }
    }

    double support(const Context& context, const float*) const CV_OVERRIDE
    {
        return context.points.threshold;
    }
};

}  // namespace

Ptr<Polisher> createLeastSquaresPolisher() { return makePtr<LeastSquaresPolisher>(); }

}  // namespace usacv20
}  // namespace cv
