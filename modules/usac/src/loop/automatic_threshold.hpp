// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_AUTOMATIC_THRESHOLD_HPP
#define OPENCV_USACV20_AUTOMATIC_THRESHOLD_HPP

#include "input/problem_data.hpp"
#include "loop/ransac.hpp"
#include "significance/inlier_noise.hpp"

namespace cv {
namespace usacv20 {

class ListedSampler;

/** @brief Estimates the threshold of a run from the data, for #THRESHOLD_ESTIMATED.

The threshold that the caller has given is the widest threshold that is considered.

1. guess(): the models of some uniform samples are compared by LogarithmicScore, which prefers no
   scale of the noise. The best model is polished, and its errors give the first threshold. If no
   model is better than chance, the first threshold is two thirds of the widest one.
2. findCore(): a model between two motions, or between two planes, explains the inliers of both with
   wide noise. Therefore, if the threshold is more than a third of the widest one even after
   polishing, samples of the inliers are drawn to find a model of a core, that is, a model that has
   at least half as many inliers at a third of the widest threshold. If there is such a model, and
   its errors do not continue beyond this narrower threshold (errorsGoOn()), the search begins with
   this model and at most this threshold.
3. The search begins with the model and the threshold of steps 1 and 2. If most points are inliers
   of the best model, the criteria of the search also count the uniform samples of step 1. Otherwise
   these samples do not count, because a model of wrong matches that agree with each other can have
   more inliers at the wide threshold than the right model. The threshold of the search is wider
   than the estimated threshold of the mask by two standard deviations of the estimate, because with
   few inliers, models that fit some of the inliers by chance would make the threshold too narrow.
4. adapt(): when the search has ended, the threshold is estimated again from the errors of the best
   model; it is two thirds of the widest one if the noise is unknown. If the new threshold differs
   by more than a factor of 1.4, the search continues with the new threshold, and the samples drawn
   so far no longer count. The threshold becomes wider by more than this factor only if the errors
   continue beyond the present threshold (errorsGoOn()), because a second motion is not noise.
5. settle(): polishing and the mask use the threshold that was estimated last, or two thirds of
   the widest threshold if the noise is unknown. */
class AutomaticThreshold
{
public:
    //! @param points points of the problem, of which only Correspondences::noise is used
    AutomaticThreshold(const Problem& problem, const Params& params, const Correspondences& points);

    /** @brief Takes steps 1 and 2. To be called before the components of the search are started.
    @param context context of the search
    @param data points of the search; their threshold is set
    @param model output: initial model of the search
    @return false if no initial model was found */
    bool guess(const Context& context, ProblemData& data, Model& model);
    //! Takes step 4. @param ransac the search, which has ended
    void adapt(const Context& context, ProblemData& data, const State& state, Ransac& ransac);
    //! Replaces steps 1 to 4 for Usac::refine, which has a model and does not search: estimates the
    //! noise of this model.
    void look(const Context& context, const Model& model);
    //! Takes step 5. @return standard deviation of the noise, in the unit of Params::threshold; 0:
    //! unknown
    double settle(ProblemData& data) const;
    //! Numbers of samples and of valid models of guess(), including those of findCore().
    int samples() const { return drawn; }
    int models() const { return computed; }
    //! The sample that led to the initial model of guess(); null: the model came from the caller.
    const Sample* bestSample() const { return sampled ? &sample : 0; }
    //! Number of samples of guess() that were drawn uniformly from all of its points.
    int uniformSamples() const { return uniform; }

private:
    void begin(const Context& context);
    void setThreshold(ProblemData& data, double threshold) const;
    //! The threshold of the search for a given noise of the best model.
    double searchThreshold(const InlierNoise& noise) const;
    Model polished(const Context& context, const Model& model) const;
    /** Takes step 2.
    @param given context of the search
    @param points points of guess(); their threshold becomes a third of the threshold of `given`
    @param noise noise of the model
    @param model input: result of guess(); output: a model that explains a core of its inliers
    @return false if there is no core */
    bool findCore(const Context& given, Correspondences& points, const InlierNoise& noise,
                  Model& model);
    void account(const State& state);
    void keepSample(const Ransac& ransac);

    Params params, coreParams;    //!< options of guess() and of findCore()
    Components parts, coreParts;  //!< components of guess() and of findCore()
    Ptr<ListedSampler> listed;    //!< sampler of findCore()
    double widest;                //!< the widest threshold, in the coordinates of the points
    InlierNoise latest;           //!< latest estimate of the noise of the best model
    Sample sample;                //!< result of bestSample(), if `sampled` is true
    bool sampled;
    int drawn, computed, uniform;  //!< results of samples(), models() and uniformSamples()
};

}  // namespace usacv20
}  // namespace cv

#endif
