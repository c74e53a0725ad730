// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Number of noise scales, the same as in the program of the authors of @cite barath2019magsac.
constexpr int PARTITIONS = 5;

/** MAGSAC @cite barath2019magsac: the number of samples that the standard criterion asks for,
averaged over the noise scale, which is uniform in 0 .. sigma_max (the scale to which the threshold
corresponds). For the scale i sigma_max / #PARTITIONS (i = 1, ..., #PARTITIONS), the inliers of the
best model are the points with errors up to i / #PARTITIONS thresholds.

The smallest scale has the fewest inliers and asks for the most samples, so that this criterion is
stricter than the standard one. The criterion suits a threshold several times as large as the noise
requires. With a tight threshold, the smallest scale has too few inliers for the search to end
before Params::maxIterations. Takes one pass over the points. */
class MagsacTermination : public Termination
{
public:
    int iterations(const Context& context, const State& state) const CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize();
        if (state.bestQuality.inliers < m)
            return INT_MAX;
        int inliers[PARTITIONS] = {0};
        count(context, state.best, inliers);
        const bool exact = (context.params.termination & TERMINATION_EXACT) != 0;
        const double logFailure = std::log(1 - context.params.confidence);
        const double kept = keptProbability(context, state.bestQuality.inliers);
        double sum = 0;
        for (int i = 0, within = 0; i < PARTITIONS; ++i)
        {
            within += inliers[i];
            const double good = goodSampleProbability(within, context.points.size, m, exact) * kept;
            if (!(good > 0))
                return INT_MAX;
            sum += good < 1 ? logFailure / std::log1p(-good) : 0;
        }
        const double mean = std::max(std::ceil(sum / PARTITIONS), 1.0);
        return mean < INT_MAX ? (int)mean : INT_MAX;
    }

    bool countsAll() const CV_OVERRIDE { return false; }
    int reason() const CV_OVERRIDE { return STOP_MAGSAC; }

private:
    //! Counts in `inliers[i]` the points with errors between i / #PARTITIONS and (i + 1) /
    //! #PARTITIONS of the threshold.
    static void count(const Context& context, const Model& model, int* inliers)
    {
        const Correspondences& p = context.points;
        const float scale = (float)(PARTITIONS / p.threshold);
        Arena::Scope scope(context.arena);
        float* const errors = scope.take<float>(p.size);
        context.components.residual->squaredErrors(p, model, 0, p.size, errors);
        for (int i = 0; i < p.size; ++i)
        {
            const float error = std::sqrt(errors[i]) * scale;
            if (error <= PARTITIONS)  // NaN is not counted
                ++inliers[std::max((int)std::ceil(error) - 1, 0)];
        }
    }
};

}  // namespace

Ptr<Termination> createMagsacTermination() { return makePtr<MagsacTermination>(); }

}  // namespace usacv20
}  // namespace cv
