// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "polishing/polishing.hpp"
#include "core/chi_square.hpp"
#include "optimization/noise_scale.hpp"

namespace cv {
namespace usacv20 {

namespace {

// Half and double of these on lists and on structured scenes: doc/constants.md.

/** Standard deviations: 1.6 % (F, E) and 2.3 % (H) less accurate than least squares under normal
noise. Half: errors on the lists +2 to +11 %, on the scenes +24 to +61 %; double: +2 % (F, E), on
the scenes +8 %, H -7 %. */
constexpr double SUPPORT = 5.3;
//! Thresholds, points: the steps but for the last two look at the first points until so many are so
//! near. Half: time and errors within 1 %; double: time within 3 %.
constexpr int REACH = 3, FEW = 500;
//! Points that are looked at together, and steps of the last fit, to its end. Half, double: the
//! same.
constexpr int BLOCK = 256, LAST = 10;
//! Least decrease of the loss, in mean points near, and relative change of the scale that are worth
//! another step. Half, double: errors within 0.4 %, time within 2 %.
constexpr double SETTLED = 0.1, SAME_SCALE = 0.1;
//! Decrease of the loss, a part of that of the points near, after which the noise is estimated
//! again. Half, double: errors within 0.1 %, time within 2 %.
constexpr double MARKED = 0.1;

/** Gauss and Newton's method on the geometric error under Tukey's biweight @cite beaton1974fitting,
by weights w = (1 - (error / support)^2)^2 that are renewed. The support is #SUPPORT standard
deviations of the noise (NoiseScale), at which the biweight is nearly as accurate as least squares
under normal noise. What is further away has no say: a wrong match far from the others in the images
(near the epipole, say) would pull at F with even a hundredth of its weight.

It ends when it has arrived: when the last step has lowered the loss by less than a tenth of that of
a mean point near, whatever the threshold is; or after Params::polishingSteps, of which the last is
a fit to the end. */
class RobustPolisher : public Polisher
{
public:
    void polish(const Context& context, Model& model) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const int steps = context.params.polishingSteps, degrees = p.problem->errorDimension();
        double sigma = 0, lossBefore = DBL_MAX;
        int wanted = FEW, lookedBefore = 0;
        Arena::Scope scope(context.arena);
        errors = scope.take<float>(p.size);
        near = scope.take<int>(p.size);
        weights = scope.take<double>(p.size);
        for (int i = 0; i < steps && !(i > 0 && context.stop()); ++i)
        {
            int looked = look(context, model, i + 2 < steps ? wanted : p.size);
            double loss = i > 0 ? weigh(p, sigma, looked) : 0;
            const double decrease = lossBefore - loss;
            const bool settled = looked == lookedBefore &&
                                 decrease < SETTLED * lossNear / std::max(count, 1);
            if (settled && looked < p.size)
                looked = look(context, model, wanted = p.size);
            if (i == 0 || i == steps / 2 || settled || decrease > MARKED * lossNear)
            {
                const double before = sigma;
                sigma = NoiseScale::estimate(errors, looked, p.threshold, degrees);
                if (settled && lookedBefore == p.size &&
                    std::abs(sigma - before) < SAME_SCALE * sigma)
                    return;
                loss = weigh(p, sigma, looked);
            }
            lossBefore = loss;
            lookedBefore = looked;
            if (!context.nonMinimalSolver().fit(p, near, count, weights, model,
                                                i + 1 < steps ? 1 : LAST))
                return;
        }
    }

private:
    //! Errors of the first points until `wanted` are within #REACH thresholds, or a block more.
    //! @return how many it took
    int look(const Context& context, const Model& model, int wanted)
    {
        const Correspondences& p = context.points;
        const float limit = (float)(REACH * REACH * p.threshold * p.threshold);
        int looked = 0, found = 0;
        while (looked < p.size && found < wanted)
        {
            const int size = std::min<int>(BLOCK, p.size - looked);
            float* const block = &errors[looked];
            context.components.residual->squaredErrors(p, model, looked, looked + size, block);
            for (int i = 0; i < size; ++i)
                found += block[i] <= limit;
            looked += size;
        }
        return looked;
    }

    /** Finds the points within the support of those looked at, and their weights. @return the loss
    of those looked at, of which each takes at most 1 */
    double weigh(const Correspondences& p, double sigma, int looked)
    {
        const double support = SUPPORT * sigma * p.threshold, scale = 1 / (support * support);
        const float limit = (float)(support * support);
        const float* const e = errors;
        int* const members = near;
        int size = 0;
        for (int i = 0; i < looked; ++i)  // no branches, which could not be foretold
        {
            members[size] = i;
            size += e[i] < limit;  // false for NaN
        }
        double sum = 0;
        for (int k = 0; k < size; ++k)
        {
            const double rest = 1 - e[members[k]] * scale;
            weights[k] = rest * rest;
            sum += 1 - rest * rest * rest;
        }
        count = size;
        lossNear = sum;
        return lossNear + looked - count;
    }

    // while it polishes
    float* errors;
    int* near;        //!< the points within the support come first
    double* weights;  //!< theirs
    int count;        //!< of both
    double lossNear;  //!< of the points near
};

}  // namespace

Ptr<Polisher> createRobustPolisher() { return makePtr<RobustPolisher>(); }

}  // namespace usacv20
}  // namespace cv
