// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RANSAC_HPP
#define OPENCV_USACV20_RANSAC_HPP

#include "local_optimization/alternatives.hpp"
#include "local_optimization/runners_up.hpp"
#include "control/watch.hpp"

namespace cv {
namespace usacv20 {

//! The models of one sample that, when they were scored, were good enough to become the best model
//! or a runner-up (lines 4 to 13 of Algorithm 1).
struct Hypotheses
{
    int count;
    Model models[MAX_MODELS];
    Quality qualities[MAX_MODELS];
    bool rejectedSample;  //!< a degeneracy check has rejected the sample
    bool repeated;        //!< the sample was rejected because it contains a match twice; its points
                          //!< can still all be inliers
    //! Numbers of models, for the report: all models of the sample, and the models excluded by a
    //! check, by Verifier::preTest and by their cost.
    int computed, rejected, refused, dropped;
    //! For the verifier: numbers of inliers and of points in the first test of each model
    //! (preTest(), or the first block of points), summed over the models.
    int firstInliers, firstTested;
    int stopped;               //!< number of models that the verifier rejected during scoring
    double costs[MAX_MODELS];  //!< for each of these models, the cost before the last block that
                               //!< was scored; 0 if the score needs all errors of a model at once
};

/** @brief Algorithm 1 of @cite ivashechkin2021usacv20.

Samples are drawn in batches. Their models are computed and scored sequentially or by several
threads, and in either case compared with the best model in the order of the samples. Everything
that affects the result (samples, verification, the best model at the time of this comparison) is
the same in both cases, so that the result is bit-identical for any number of threads. Of the models
of the first batch, only the best one is optimized at once, because better models than these are
soon found @cite lebeda2012fixing. When the search is about to end, the runners-up
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
    //! @param drawn number of uniform samples whose best model is `initial`; these samples count
    //! for the confidence if most points are inliers of the best model, see samplesThatCount()
    void begin(const Model& initial, int drawn = 0);
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
    const int* bestSample() const { return sampled ? sampleOfBest.val : 0; }

private:
    bool terminate();
    //! True if the run must end now. @param work work done since the last call, in point tests
    bool stop(double work) const { return context.watch && context.watch->stop(work); }
    bool stopped() const { return context.watch && context.watch->stopped(); }
    void drawBatch();
    //! Computes the models of `count` samples, at most MinimalSolver::MAX_TOGETHER, and writes them
    //! to `h`.
    void solve(const Sample* drawn, int count, Hypotheses* h) const;
    //! Checks and scores the models in `h`. @param index index of the sample in the batch
    //! @param row memory for errors, see rate()
    void hypothesize(int index, Hypotheses& h, float* row) const;
    //! Calls hypothesize() for the sample `index` of the batch. If this sample has not been solved
    //! yet, first calls solve() for it and the samples after it, `ahead` samples in total. To be
    //! called for one sample after the other, in order.
    const Hypotheses& hypothesizeNext(int index);
    //! Calls solve() and hypothesize() for all samples of the batch, in several threads.
    void hypothesizeBatch();
    void hypothesizePart(int first, int count);
    //! Allocates memory for the hypotheses of `wanted` samples and, if the score needs all errors
    //! of a model at once, for `rows` rows of errors.
    void reserve(int wanted, int rows);
    //! A model of a sample with this cost or more becomes neither the best model nor, unless it is
    //! a rival (see addRival()), a runner-up.
    double uselessCost() const;
    void improve(const Candidate& candidate, const Quality& before);
    //! @param sample the sample of the model; null: the model does not come from a sample
    void setBest(const Model& model, const Quality& quality, const Sample* sample);
    void addRunnerUp(const Candidate& candidate);
    //! Called when the search is about to end: optimizes runners-up and draws samples of
    //! unexplained points. @return false if the search ends
    bool lookBeside();
    void improveRunnersUp();
    //! Replaces the best model with one of `alternatives` if a ranking of the points (a known
    //! order, or a ranking by common neighbors) is clearly more likely with the inliers of the
    //! alternative than with those of the best model.
    void chooseByRank();
    void offerCore(const Model& core);
    void setValid(const Model& model, const Sample* sample);
    //! The score of a model after the discounts of the degeneracy checks.
    Quality discounted(const Model& model, const Quality& rated) const;
    bool worthOptimizing(const RunnerUp& runnerUp) const;
    /** The best model explains the points whose errors are at most EXPLAINED times
    Context::inlierThreshold. The factor is above 1 because some correct matches lie beyond the
    threshold if the noise is wide. See doc/constants.md. */
    static constexpr double EXPLAINED = 1.5;
    //! Draws samples of the points that the best model does not explain; see
    //! ransac_unexplained.cpp. @return false if there was nothing to search, so that no samples
    //! were drawn
    bool searchUnexplained();
    int unexplainedPoints(int* indices) const;
    //! Draws a few samples of unexplained points, and more of them only if there is evidence of a
    //! rival (a second model that explains other points).
    //! @param drawn number of samples drawn before searchUnexplained()
    void sampleForRivals(const int* indices, int count, double wanted, int drawn);
    void sampleUnexplained(const int* indices, int count, int most);
    //! @param index State::iteration of the sample
    Sample drawUnexplained(const int* indices, int count, int index) const;
    //! A rival has at least this many inliers that the best model does not explain. Only the points
    //! of InlierBits are counted.
    double rivalInliers() const;
    //! Stores the model as a runner-up if it is a rival and if more than m of its inliers are not
    //! explained by the best model (m is the sample size). @return false if one of these conditions
    //! does not hold
    bool addRival(const Sample& sample, const Model& model);
    //! Return true if all degeneracy checks accept the sample (validSample()) or the model
    //! (validModel()).
    bool validSample(const int* sample) const;
    bool validModel(const int* sample, const Model& model) const;
    //! @param sample the sample that led to the model; null: the model does not come from a sample
    void optimize(const Sample* sample, Model& model, Quality& quality);
    void offer(const Model& model, const Quality& quality, const Sample* sample);
    bool recover(const int* sample, Model& model, Quality& quality);
    void account(const Hypotheses& hypotheses);
    void updateTermination();
    //! Calls Termination::adapt of all criteria. @return true if the required number of samples
    //! might have changed
    bool adaptTerminations();
    int samplesThatCount() const;
    void require(double wanted, bool all, int reason);

    const Context& context;
    const Components& parts;
    State& state;
    const int m;                //!< sample size
    Degeneracy* const* checks;  //!< Components::degeneracies
    const int checkCount;       //!< number of `checks`
    Sample* samples;            //!< samples of the batch
    uchar* counts;              //!< State::counts of each sample
    Hypotheses* batch;  //!< models of the samples; only of `ahead` samples if the batch is not
                        //!< distributed to threads
    float* errorRows;   //!< a row of errors per thread; null: the score does not need them
    int size;           //!< number of samples in the batch
    int hypotheses;     //!< number of elements allocated for `batch`
    RunnersUp runnersUp;
    Alternatives alternatives;
    Sample sampleOfBest;
    bool sampled;            //!< true if the best model comes from `sampleOfBest`
    Model explored;          //!< the last best model that searchUnexplained() processed
    int unexplainedSamples;  //!< number of samples of unexplained points so far
    int rivals;  //!< RunnersUp::mostUnexplained() when the runners-up were last optimized
    const int threads;
    const double sampleWork;  //!< work to solve a sample and to score one model, in point tests
    int firstOfBatch;         //!< State::iteration of the first sample of the batch
    const int ahead;          //!< number of samples that are solved at once
    const int exhaustive;     //!< see exhaustiveSamples()
    //! The run can stop after `required` samples that count, see samplesThatCount(), or after
    //! `requiredOfAll` samples of any kind. The reasons are the StopReason of the criteria that
    //! require these numbers.
    int required, requiredReason, requiredOfAll, reasonOfAll;
    int ending;         //!< StopReason when terminate() was last true
    bool anyModel;      //!< true if a sample has led to a model
    double localTicks;  //!< duration of all local optimizations, in ticks
    const bool checkSamples;
};

}  // namespace usacv20
}  // namespace cv

#endif
