// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "local_optimization/inlier_set.hpp"
#include "local_optimization/labeling.hpp"
#include "local_optimization/local_optimization.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Maximum number of points of a fit to the inliers (MAX_INNER_FIT), and of a fit to the points
//! within one of the shrinking thresholds (MAX_SHRINK). While the inliers still change, fits to
//! more points are slower but not better.
constexpr int MAX_INNER_FIT = 256, MAX_SHRINK = 64;
//! If there are many inliers, the graph cut labels only the first points, a random subset that
//! contains about CUT_INLIERS inliers, rounded up to CUT_INLIERS times a power of 2 points.
constexpr int CUT_INLIERS = 1024;
//! Number of Gauss-Newton steps of a fit. The fits that follow take the next steps.
constexpr int FIT_STEPS = 1;
//! An inner sample contains at most 1 / #LARGEST_PART of the inliers, as in @cite chum2003locally,
//! but always more points than a minimal sample.
constexpr int LARGEST_PART = 2;
//! If #LARGEST_PART makes inner samples smaller than Params::localSampleMultiple says, at least
//! IF_FEW are drawn (unless Params::localSamples is 0). With 30 matches, four samples instead of
//! one lower the mean error of F by 1 to 4 % and that of E by 1 %; for more inliers, four samples
//! lower errors by at most 1 %.
constexpr int IF_FEW = 4;
//! The first and widest of the shrinking thresholds, as a multiple of the threshold.
constexpr int WIDEST = 3;
//! An iteration is the last one unless it lowers the cost below this fraction of the previous cost.
//! The first iteration takes place only if the fits with shrinking thresholds have lowered the cost
//! below this fraction of the cost of the best model so far.
constexpr double WORTHWHILE = 0.97;
//! The fits with shrinking thresholds end early if the gain of the model is below this fraction of
//! the gain of the best model so far: after the fit with the widest threshold (FIRST_GAIN), or
//! after the next one (SECOND_GAIN). The gain is the number of points minus the cost. Nearly all
//! models that become the best model have more after these fits.
constexpr double FIRST_GAIN = 0.5, SECOND_GAIN = 0.6;
//! For Params::spatialWeight = 0: error, in thresholds, up to which a point is labeled as an
//! inlier, as Labeling does for a point without edges. At this error, K (see Labeling) is 1 / 2.
const double LABELED = std::sqrt(2 * CV_LOG2);

/** @brief Local optimization of Graph-Cut RANSAC @cite barath2018graph.

First, as in LO-RANSAC @cite chum2003locally, the model is fitted in turn to the points within three
times the threshold (#WIDEST), twice the threshold, and the threshold itself. With the threshold
alone, the model of a minimal sample would end in the nearest local optimum, because a fit to the
few points within the threshold hardly changes the model. Optimization ends after these fits, or
between them (#FIRST_GAIN), unless the model is now clearly better than the best model so far.

Then each iteration finds the spatially coherent inliers of the model (Labeling) and runs an inner
RANSAC over these inliers (of the first points, see #CUT_INLIERS): models are fitted to all of them
(to #MAX_INNER_FIT random ones if there are more), and to random samples of
Params::localSampleMultiple times the minimal size or, if there are few inliers, of half of the
inliers (then at least #IF_FEW samples). A better fit always replaces the model. Each iteration
except the first begins with fits with shrinking thresholds, as above. The first iteration without a
clear decrease of the cost is the last one, and Params::localIterations bounds the number of
iterations. */
class GraphCutOptimizer : public LocalOptimizer
{
public:
    void start(const Context&) CV_OVERRIDE { labeling.start(); }

    bool optimize(const Context& context, State& state, Model& model, Quality& quality) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize();
        Arena::Scope scope(context.arena);
        inliers.allocate(scope, context.points.size);
        bool improved = shrink(context, state, m, model, quality);
        double before = state.bestQuality.cost;
        for (int i = 0; i < context.params.localIterations && quality.cost < WORTHWHILE * before &&
                        !context.stop();
             ++i)
        {
            before = quality.cost;
            if (i > 0)
                improved |= shrink(context, state, m, model, quality);
            if (context.params.spatialWeight > 0)
                cut(context, model, quality);
            else
                inliers.within(context, model, LABELED);
            if (inliers.size() > m)
                improved |= fitInliers(context, state, m, model, quality);
        }
        return improved;
    }

private:
    //! Finds the spatially coherent inliers of the model among the first points, see #CUT_INLIERS.
    //! @param quality score of the model over all points
    void cut(const Context& context, const Model& model, const Quality& quality)
    {
        Correspondences points = context.points;
        const double wanted = (double)CUT_INLIERS * points.size / std::max(quality.inliers, 1);
        int size = context.neighborhood().edgesOfFirstPoints() ? (int)CUT_INLIERS : points.size;
        while (size < wanted && size < points.size)
            size *= 2;
        points.size = std::min(size, points.size);
        inliers.count = labeling.cut(
            Context(points, context.components, context.params, context.arena, context.watch),
            model, inliers.members);
    }

    //! Fits the model to the points within #WIDEST, ..., 2 and 1 thresholds. Each fit starts from
    //! the previous fit. Ends early if the model is far from the best one, see #FIRST_GAIN. @return
    //! true if the model was replaced
    bool shrink(const Context& context, State& state, int m, Model& model, Quality& quality)
    {
        Model fitted = model;
        bool improved = false;
        for (int multiple = WIDEST; multiple >= 1 && !context.stop(); --multiple)
        {
            inliers.within(context, fitted, multiple);
            if (inliers.size() <= m ||
                !inliers.fit(context, inliers.select(state.rng, MAX_SHRINK), fitted, FIT_STEPS))
                break;
            improved |= keepBetter(context, fitted, model, quality);
            const double points = context.points.size,
                         least = multiple == WIDEST ? FIRST_GAIN : SECOND_GAIN;
            if (points - quality.cost < least * (points - state.bestQuality.cost))
                break;
        }
        return improved;
    }

    bool fitInliers(const Context& context, State& state, int m, Model& model, Quality& quality)
    {
        const int count = inliers.size();
        const int full = m * context.params.localSampleMultiple;
        const int small = std::max(m + 1, std::min(full, count / LARGEST_PART));
        const int asked = context.params.localSamples;
        const int samples = asked > 0 && count < LARGEST_PART * full ? std::max(asked, IF_FEW)
                                                                     : asked;
        bool improved = inliers.improve(context, inliers.select(state.rng, MAX_INNER_FIT), model,
                                        quality, FIT_STEPS);
        for (int i = 0; i < samples && small < count && !context.stop(); ++i)
            improved |= inliers.improve(context, inliers.select(state.rng, small), model, quality,
                                        FIT_STEPS);
        return improved;
    }

    Labeling labeling;
    InlierSet inliers;
};

}  // namespace

Ptr<LocalOptimizer> createGraphCutOptimizer() { return makePtr<GraphCutOptimizer>(); }

}  // namespace usacv20
}  // namespace cv
