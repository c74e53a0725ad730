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
//! or a runner-up (lines 4 to 14 of Algorithm 1).
struct Hypotheses
{
    int count;
    Model models[MAX_MODELS];
    Quality qualities[MAX_MODELS];
    bool rejectedSample;  //!< a degeneracy check has rejected the sample
    bool repeated;        //!< the sample was rejected because it contains a match twice, but may
                          //!< consist of inliers
    //! Numbers of models, for the report: all models of the sample, and those excluded by a check,
    //! by Verifier::preTest and by their cost.
    int computed, rejected, refused, dropped;
    //! For the verifier: numbers of inliers and of points in the first tests of the models.
    int firstInliers, firstTested;
    int stopped;               //!< number of models that the verifier rejected during scoring
    double costs[MAX_MODELS];  //!< costs of these rejected models before their last block of points
};

/** @brief Algorithm 1 of @cite ivashechkin2021usacv20.

Samples are drawn in batches. Their models are computed and scored sequentially or by several
threads, and in either case evaluated in the order of the samples. Everything that affects the
result (samples, verification, the best model at the time of evaluation) is the same in both cases,
so that the result is bit-identical for any number of threads. Of the first batch, only the best
model is optimized at once, because better models than the first ones are soon found
@cite lebeda2012fixing. When the search is about to end, the runners-up (Params::runnersUp) are
optimized, too, as well as models of samples of the points that the best model does not explain. If
one of these models becomes the best model, the termination criteria are evaluated again. */
class Ransac
{
public:
    //! @param context, state the fixed and the changing data of the run
    //! @param checkSamples true: validate the indices in samples, because the sampler is custom
    Ransac(const Context& context, State& state, bool checkSamples = false);

    //! To be called before run(): scores and optimizes an initial model, as if from a sample.
    //! @param drawn number of uniform samples of which `initial` is the best model; they count for
    //! the confidence if most points are inliers of the best model, see samplesThatCount()
    void begin(const Model& initial, int drawn = 0);
    /** Searches until a criterion ends the search, or until `pause` samples have been drawn. The
    result is State::best; State::bestQuality stays infinite if no model is found. @return false if
    the search was paused; another call then continues it. */
    bool run(int pause = INT_MAX);
    //! To be called when the threshold has changed: scores and optimizes the best model anew, and
    //! forgets the scores of other models. If a check now rejects the best model, there is no best
    //! model until run() finds one.
    void thresholdChanged();
    //! To be called before thresholdChanged() if the samples so far do not count for the
    //! confidence, because their models were tested with another threshold. The verifier and the
    //! criteria begin anew.
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
    //! Scores the models in `h`. @param index index of the sample in the batch
    //! @param row memory for errors, see rate()
    void hypothesize(int index, Hypotheses& h, float* row) const;
    //! Calls hypothesize() for the sample `index` of the batch, and before it solve() for the next
    //! `ahead` samples if they are not solved yet. To be called for one sample after the other.
    const Hypotheses& hypothesizeNext(int index);
    //! Calls solve() and hypothesize() for all samples of the batch, by several threads.
    void hypothesizeBatch();
    void hypothesizePart(int first, int count);
    //! Allocates memory for the hypotheses of `wanted` samples and for `rows` rows of errors.
    void reserve(int wanted, int rows);
    //! A model of a sample with this cost or more becomes neither the best model nor a runner-up.
    double uselessCost() const;
    void improve(const Candidate& candidate, const Quality& before);
    //! @param sample the sample of the model; null: the model does not come from a sample
    void setBest(const Model& model, const Quality& quality, const Sample* sample);
    void addRunnerUp(const Candidate& candidate);
    //! Called when the search is about to end: optimizes runners-up and draws samples of
    //! unexplained points. @return false if the search ends
    bool lookBeside();
    void improveRunnersUp();
    //! If the order of the points is known: replaces the best model by one of `alternatives` if the
    //! order is clearly more likely with the inliers of the alternative.
    void chooseByOrder();
    bool worthOptimizing(const RunnerUp& runnerUp) const;
    /** The best model explains the points whose errors are at most EXPLAINED times
    Context::inlierThreshold. The factor is above 1 because some correct matches lie beyond the
    threshold if the noise is wide. See doc/constants.md. */
    static constexpr double EXPLAINED = 1.5;
    //! Draws samples of the points that the best model does not explain; see
    //! ransac_unexplained.cpp. @return false if there is nothing to search
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
    //! @return false if the model is not a rival
    bool addRival(const Sample& sample, const Model& model);
    //! True if all degeneracy checks accept the sample, or the model.
    bool validSample(const int* sample) const;
    bool validModel(const int* sample, const Model& model) const;
    //! @param sample the sample that led to the model; null: the model does not come from a sample
    void optimize(const Sample* sample, Model& model, Quality& quality);
    void offer(const Model& model, const Quality& quality, const Sample* sample);
    bool recover(const int* sample, Model& model, Quality& quality);
    void account(const Hypotheses& hypotheses);
    void updateTermination();
    //! Calls Termination::adapt of all criteria. @return true if the required number of samples may
    //! have changed
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
    Hypotheses* batch;  //!< models of the samples; of `ahead` samples if there is one thread
    float* errorRows;   //!< a row of errors per thread; null: the score does not need them
    int size;           //!< number of samples in the batch
    int hypotheses;     //!< number of elements allocated for `batch`
    RunnersUp runnersUp;
    Alternatives alternatives;
    Sample sampleOfBest;
    bool sampled;  //!< true if the best model comes from `sampleOfBest`
    //! Number of samples that do not count, see forgetSamples(). Minus this number, if it is
    //! negative: number of samples drawn before this search that count, too, see begin().
    int forgotten;
    Model explored;          //!< the best model for which searchUnexplained() was last called
    int unexplainedSamples;  //!< number of samples of unexplained points so far
    int rivals;  //!< RunnersUp::mostUnexplained() when the runners-up were last optimized
    const int threads;
    const double sampleWork;  //!< work to solve a sample and to score one model, in point tests
    int firstOfBatch;         //!< State::iteration of the first sample of the batch
    const int ahead;          //!< number of samples that are solved at once
    const int exhaustive;     //!< see exhaustiveSamples()
    //! The run can stop after `required` samples that count, see samplesThatCount(), or after
    //! `requiredOfAll` samples of any kind. The reasons are the StopReason of the criterion.
    int required, requiredReason, requiredOfAll, reasonOfAll;
    int ending;         //!< StopReason when terminate() was last true
    bool anyModel;      //!< true if a sample has led to a model
    double localTicks;  //!< duration of local optimization in ticks
    const bool checkSamples;
};

}  // namespace usacv20
}  // namespace cv

#endif
