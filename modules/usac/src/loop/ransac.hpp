// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RANSAC_HPP
#define OPENCV_USACV20_RANSAC_HPP

#include "local_optimization/alternatives.hpp"
#include "loop/rival_search.hpp"

namespace cv {
namespace usacv20 {

/** @brief Algorithm 1 of @cite ivashechkin2021usacv20.

Samples are drawn in batches. Their models are computed and scored sequentially or by several
threads, and in either case compared with the best model in the order of the samples. Everything
that affects the result (samples, verification, the best model at the time of this comparison) is
the same in both cases, so that the result is bit-identical for any number of threads. Of the models
of the first batch, only the best one is optimized at once, because better models than these are
soon found @cite lebeda2012fixing. With #LOCAL_OPTIMIZATION_GC_RANSAC, each model that is better
than the best one is optimized at once. When the search is about to end, the runners-up
(Params::runnersUp) are optimized, too, and so are promising models of samples of the points that
the best model does not explain. If one of these models becomes the best model, the termination
criteria are evaluated again. */
class Ransac
{
public:
    //! @param context, state the fixed and the changing data of the run
    //! @param checkSamples true: samples are checked for valid indices, because the caller has
    //! replaced the sampler
    Ransac(const Context& context, State& state, bool checkSamples = false);

    //! To be called before run(): scores and optimizes an initial model.
    //! @param sample the sample that led to `initial`; null: there is none
    //! @param drawn number of uniform samples whose best model is `initial`; these samples count
    //! for the confidence if most points are inliers of the best model, see Stopping
    void begin(const Model& initial, const Sample* sample = 0, int drawn = 0);
    /** The same for a model that might only be near the right one, such as that of the previous
    frame of a video: it is also optimized with a wider threshold, and the result is another initial
    model. This is not done if nearly all points within the wider threshold are inliers already. */
    void beginNear(const Model& initial);
    /** Searches until a criterion ends the search, or until at least `pause` samples have been
    drawn. The result is State::best; the cost of State::bestQuality stays infinite if no model is
    found. @return false if the search was paused; another call then continues the search. */
    bool run(int pause = INT_MAX);
    //! To be called when the threshold has changed: scores and optimizes the best model anew, and
    //! forgets the other models and their scores. If a check now rejects the best model, there is
    //! no best model until run() finds one.
    void thresholdChanged();
    //! To be called before thresholdChanged() if the samples so far do not count for the
    //! confidence, because their models were tested with another threshold. The sampler, the
    //! verifier and the criteria are started again.
    void forgetSamples();
    //! The sample that led to State::best; null if State::best did not come from a sample.
    const Sample* bestSample() const { return sampled ? &sampleOfBest : 0; }

private:
    //! Calls Stopping::adapt, and optimizes the runners-up if a criterion asks for other samples.
    //! @return true if the required number of samples might have changed
    bool adaptTerminations();
    //! Counts a sample and its models for the criteria, the verifier and the report.
    void account(const Hypotheses& hypotheses);
    //! Lines 14 to 25.
    void improve(const Candidate& candidate, const Quality& before);
    //! @param sample the sample that led to the model; null: the model does not come from a sample
    void optimize(const Sample* sample, Model& model, Quality& quality);
    //! @param sample as above
    void setBest(const Model& model, const Quality& quality, const Sample* sample);
    //! A model of a sample with this cost or more becomes neither the best model nor, unless it is
    //! a rival (see RivalSearch), a runner-up.
    double uselessCost() const;
    void addRunnerUp(const Candidate& candidate);
    //! Called when the search is about to end: optimizes runners-up and searches for rivals.
    //! @return false if the search ends
    bool lookBeside();
    void improveRunnersUp();
    bool worthOptimizing(const RunnerUp& runnerUp) const;
    //! Replaces the best model with one of `alternatives` if a ranking of the points (a known
    //! order, or a ranking by common neighbors) is clearly more likely with the inliers of the
    //! alternative than with those of the best model.
    void chooseByRank();
    void offer(const Model& model, const Quality& quality, const Sample* sample);
    void setValid(const Model& model, const Sample* sample);

    const Context& context;
    const Components& parts;
    State& state;
    const Checks checks;
    Stopping stopping;
    RunnersUp runnersUp;
    Alternatives alternatives;
    SampleBatch batch;
    RivalSearch rivals;
    const bool literal;  //!< models are compared with the best one, as in line 13 of Algorithm 1
    Sample sampleOfBest;
    bool sampled;       //!< true if the best model comes from `sampleOfBest`
    double localTicks;  //!< duration of all local optimizations, in ticks
};

}  // namespace usacv20
}  // namespace cv

#endif
