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

1. guess(): the models of some uniform samples are compared by LogarithmicScore, which prefers no
   scale of the noise. The best one is polished, and its errors give the first threshold. If no
   model is better than chance, it is a third of the widest.
2. findCore(): a model between two motions, or two planes, explains both of them with wide noise. So
   if the threshold is more than a third of the widest, samples of the inliers look for a model that
   explains half of them within a third of the widest. If there is one, and the errors do not go on
   beyond that third, see errorsGoOn(), the search begins with it.
3. The search has this threshold and begins with this model. Its threshold is wider than that of the
   mask by two standard deviations of the estimate: with few inliers, models that fit some of them
   by luck would make it too narrow.
4. adapt(): when the search has ended, the errors of the best model give the threshold anew. If it
   differs much, the search continues with it: all samples are drawn anew. It becomes wider only if
   the errors go on beyond the present one: a second motion is not noise.
5. settle(): polishing and mask have the threshold that was found last; if the noise is unknown, a
   third of the widest. */
class AutomaticThreshold
{
public:
    AutomaticThreshold(const Problem& problem, const Params& params);

    /** @brief Steps 1 and 2. To be called before the components of the search are started.
    @param context of the search
    @param data its points, whose threshold is set
    @param model output: initial model of the search
    @return false if there is none */
    bool guess(const Context& context, ProblemData& data, Model& model);
    //! Step 4. @param ransac the search, which has ended
    void adapt(const Context& context, ProblemData& data, const State& state, Ransac& ransac);
    //! Instead of steps 1 to 4 if a model is given.
    void look(const Context& context, const Model& model);
    //! Step 5. @return standard deviation of the noise in pixels; 0: unknown
    double settle(ProblemData& data) const;
    //! Numbers of samples and of valid models of guess().
    int samples() const { return drawn; }
    int models() const { return computed; }

private:
    void begin(const Context& context);
    void setThreshold(ProblemData& data, double threshold) const;
    //! Threshold of the search for this noise.
    double searchThreshold(const InlierNoise& noise) const;
    Model polished(const Context& context, const Model& model) const;
    /** Step 2.
    @param points of guess(); their threshold becomes a third of the widest
    @param noise of the model
    @param model input: result of guess(); output: a model that explains a core of its inliers
    @return false if there is none */
    bool findCore(const Context& given, Correspondences& points, const InlierNoise& noise,
                  Model& model);
    void account(const State& state);

    Params params, coreParams;    //!< of guess() and findCore()
    Components parts, coreParts;  //!< of guess() and findCore()
    Ptr<ListedSampler> listed;    //!< sampler of findCore()
    double widest;                //!< threshold of the mask at the begin of the run
    InlierNoise latest;           //!< of the best model
    int drawn, computed;          //!< samples() and models()
};

}  // namespace usacv20
}  // namespace cv

#endif
