// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "polishing/polishing.hpp"
#include "statistics/chi_square.hpp"
#include "statistics/noise_scale.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Levenberg and Marquardt's method on the geometric error under the robust loss of Geman and McClure
@cite geman1987statistical, by weights w = 1 / (1 + error^2 / scale^2)^2 that are renewed, over the points within #REACH thresholds.
The weights fall off smoothly where a threshold cuts, so the result depends less on it: the points just outside still
speak, those far outside do not. The scale is the threshold that would suit the noise of the inliers (NoiseScale), as far as it is not
less than 0.7 and not more than 1.5 times the one given. It ends when a step has lowered the sum of the losses by less than a
twentieth of a point, much less than noise puts between the least loss and that of the true model, or after Params::polishingSteps. */
class RobustPolisher : public Polisher
{
public:
    void polish(const Context& context, Model& model) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const int steps = context.params.polishingSteps;
        double scale = 0, lossBefore = DBL_MAX;
        int wanted = FEW, lookedBefore = 0;
        errors.resize(p.size);
        for (int i = 0; i < steps; ++i)
        {
            int looked = look(context, model, i + 2 < steps ? wanted : p.size);
            double loss = weigh(scale, looked);
            const bool settled = looked == lookedBefore && lossBefore - loss < SETTLED;
            if (settled && looked < p.size)
                looked = look(context, model, wanted = p.size);
            if (i == 0 || i == steps / 2 || settled)
            {
                const double scaleBefore = scale;
                scale = scaleOf(p, errors.data(), looked);
                if (settled && lookedBefore == p.size && std::abs(scale - scaleBefore) < SAME_SCALE * scale)
                    return;
                loss = weigh(scale, looked);
            }
            lossBefore = loss;
            lookedBefore = looked;
            if (!context.components.nonMinimalSolver->fit(p, near.data(), (int)near.size(), weights.data(), model, STEPS))
                return;
        }
    }

private:
    //! Finds the first points within #REACH thresholds, `wanted` or a block more. @return how many points it took
    int look(const Context& context, const Model& model, int wanted)
    {
        const Correspondences& p = context.points;
        const float limit = (float)(REACH * REACH * p.threshold * p.threshold);
        near.resize(p.size);
        int begin = 0, count = 0;
        while (begin < p.size && count < wanted)
        {
            const int end = std::min(begin + BLOCK, p.size);
            context.components.residual->squaredErrors(p, model, begin, end, errors.data() + begin);
            for (; begin < end; ++begin)  // no branches, which could not be foretold
            {
                near[count] = begin;
                count += errors[begin] <= limit;
            }
        }
        near.resize(count);
        return begin;
    }

    //! Weights of the points near. @return the loss of those looked at, of which each point takes at most 1
    double weigh(double scale, int looked)
    {
        double loss = looked - (double)near.size();
        weights.resize(near.size());
        for (size_t k = 0; k < near.size(); ++k)
        {
            const double root = 1 / (1 + errors[near[k]] * scale);
            weights[k] = root * root;
            loss += 1 - root;
        }
        return loss;
    }

    //! One over the square of the scale.
    static double scaleOf(const Correspondences& p, const float* errors, int count)
    {
        const int degrees = degreesOfFreedom(p.problem);
        const double sigma = NoiseScale::estimate(errors, count, p.threshold, degrees);
        const double scale = std::min(std::max(sigma * thresholdInSigmas(degrees), 0.7), 1.5) * p.threshold;
        return 1 / (scale * scale);
    }

    //! The weights are renewed before a fit with the old ones has converged; all points are needed for the last two.
    enum { REACH = 3, STEPS = 1, FEW = 500, BLOCK = 256 };

    //! Least decrease of the loss, a fraction of a point, and the change of the scale, that are worth another step.
    static const double SETTLED, SAME_SCALE;

    std::vector<float> errors;
    std::vector<int> near;  //!< the points that take part
    std::vector<double> weights;
};

const double RobustPolisher::SETTLED = 0.05;
const double RobustPolisher::SAME_SCALE = 0.1;

} // namespace

Ptr<Polisher> createRobustPolisher()
{
    return makePtr<RobustPolisher>();
}

} // namespace usacv20
} // namespace cv
