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
less than 0.7 and not more than 1.5 times the one given. */
class RobustPolisher : public Polisher
{
public:
    void polish(const Context& context, Model& model) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const Components& parts = context.components;
        double scale = 0;
        std::vector<float> errors(p.size);
        std::vector<double> weights;
        std::vector<int> near;
        for (int i = 0; i < ITERATIONS; ++i)
        {
            parts.residual->squaredErrors(p, model, 0, p.size, errors.data());
            if (i == 0 || i == ITERATIONS / 2)
                scale = scaleOf(p, errors);
            near.clear();
            weights.clear();
            for (int k = 0; k < p.size; ++k)
            {
                const double relative = errors[k] * scale;
                if (!(errors[k] <= REACH * REACH * p.threshold * p.threshold))
                    continue;
                near.push_back(k);
                weights.push_back(1 / ((1 + relative) * (1 + relative)));
            }
            if (!parts.nonMinimalSolver->fit(p, near.data(), (int)near.size(), weights.data(), model, STEPS))
                return;
        }
    }

private:
    //! One over the square of the scale.
    static double scaleOf(const Correspondences& p, const std::vector<float>& errors)
    {
        const int degrees = degreesOfFreedom(p.problem);
        const double sigma = NoiseScale::estimate(errors.data(), p.size, p.threshold, degrees);
        const double scale = std::min(std::max(sigma * thresholdInSigmas(degrees), 0.7), 1.5) * p.threshold;
        return 1 / (scale * scale);
    }

    //! The weights are renewed before a fit with the old ones has converged.
    enum { REACH = 3, ITERATIONS = 4, STEPS = 1 };
};

} // namespace

Ptr<Polisher> createRobustPolisher()
{
    return makePtr<RobustPolisher>();
}

} // namespace usacv20
} // namespace cv
