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

/** @brief Finds the threshold of a run in the data, for #THRESHOLD_ESTIMATED.

The threshold that the caller has given is the widest threshold that is considered.

1. guess(): the models of some uniform samples are compared by LogarithmicScore, which prefers no
   scale of the noise. The best model is polished, and its errors give the first threshold. If no
   model is better than chance, the first threshold is a third of the widest threshold.
2. findCore(): a model between two motions, or between two planes, explains the inliers of both with
   wide noise. Therefore, if the threshold is more than a third of the widest one, also after
   polishing, samples of the inliers are drawn to find a model of a core: it explains half of the
   inliers within a third of the widest threshold. If there is such a model, and errorsGoOn() finds
   no more errors beyond this threshold, the search begins with this model and threshold.
3. The search begins with the model and the threshold of steps 1 and 2. If most points are inliers
   of the best model, its criteria also count the uniform samples of step 1. Otherwise wrong matches
   that agree with each other may have more inliers at the wide threshold than the right model, and
   the samples do not count. The threshold of the search is wider than that of the mask by two
   standard deviations of the estimate, because with few inliers, models that fit some of them by
   chance would make the threshold too narrow.
4. adapt(): when the search has ended, the threshold is estimated again from the errors of the best
   model. If the new threshold differs by more than a factor of 1.4, the search continues with it,
   and the samples drawn so far no longer count. The threshold becomes wider only if errorsGoOn()
   finds errors beyond the present threshold, because a second motion is not noise.
5. settle(): polishing and mask use the threshold that was found last, or a third of the widest
   threshold if the noise is unknown. */
class AutomaticThreshold
{
public:
    AutomaticThreshold(const Problem& problem, const Params& params);

    /** @brief Steps 1 and 2. To be called before the components of the search are started.
    @param context context of the search
    @param data points of the search; their threshold is set
    @param model output: initial model of the search
    @return false if no initial model was found */
    bool guess(const Context& context, ProblemData& data, Model& model);
    //! Step 4. @param ransac the search, which has ended
    void adapt(const Context& context, ProblemData& data, const State& state, Ransac& ransac);
    //! Estimates the noise of a given model, instead of steps 1 to 4.
    void look(const Context& context, const Model& model);
    //! Step 5. @return standard deviation of the noise in pixels; 0: unknown
    double settle(ProblemData& data) const;
    //! Numbers of samples and of valid models of guess().
    int samples() const { return drawn; }
    int models() const { return computed; }
    //! Number of samples of guess() that are uniform among all its points.
    int uniformSamples() const { return uniform; }

private:
    void begin(const Context& context);
    void setThreshold(ProblemData& data, double threshold) const;
    //! Threshold of the search for this noise.
    double searchThreshold(const InlierNoise& noise) const;
    Model polished(const Context& context, const Model& model) const;
    /** Step 2.
    @param given context of the search
    @param points points of guess(); their threshold becomes a third of the widest threshold
    @param noise noise of the model
    @param model input: result of guess(); output: a model that explains a core of its inliers
    @return false if there is no core */
    bool findCore(const Context& given, Correspondences& points, const InlierNoise& noise,
                  Model& model);
    void account(const State& state);

    Params params, coreParams;     //!< options of guess() and of findCore()
    Components parts, coreParts;   //!< components of guess() and of findCore()
    Ptr<ListedSampler> listed;     //!< sampler of findCore()
    double widest;                 //!< threshold of the mask at the beginning of the run
    InlierNoise latest;            //!< latest estimate of the noise of the best model
    int drawn, computed, uniform;  //!< results of samples(), models() and uniformSamples()
};

}  // namespace usacv20
}  // namespace cv

#endif
