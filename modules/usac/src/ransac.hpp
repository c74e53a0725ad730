// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RANSAC_HPP
#define OPENCV_USACV20_RANSAC_HPP

#include "local_optimization/runners_up.hpp"
#include "watch.hpp"

namespace cv {
namespace usacv20 {

//! The models of a sample that were of use when they were computed (lines 4 to 14): the best so
//! far, or a runner-up.
struct Hypotheses
{
    int count;
    Model models[MAX_MODELS];
    Quality qualities[MAX_MODELS];
    bool rejectedSample;  //!< by a check
    bool repeated;        //!< rejected, but may be a good one in which a match is twice
    int computed, rejected, refused, dropped;  //!< models, for the report
    int firstInliers, firstTested;             //!< of their first blocks, for the verifier
    int stopped;               //!< models that the verifier dropped while they were rated
    double costs[MAX_MODELS];  //!< theirs before their last block
};

/** @brief Algorithm 1 of @cite ivashechkin2021usacv20.

Samples are drawn in batches. Their models are computed and rated one after the other, or by several
threads, and in either case looked at in the order of the samples. What decides (samples,
verification, the best model at the time of the look) is the same in both cases, so the number of
threads does not change a bit of the result. Of the first batch, only the best model is optimized:
the first models are soon beaten @cite lebeda2012fixing. When the search is about to end, the
runners-up (Params::runnersUp) are optimized, too, and those of samples among the points that the
best model leaves; if one of them becomes the best model, the criteria are asked again. */
class Ransac
{
public:
    //! `checkSamples`: the sampler may make mistakes.
    Ransac(const Context& context, State& state, bool checkSamples = false);

    //! Before run(): rates a model and optimizes it, as one of a sample.
    void begin(const Model& initial);
    /** Fills State::best; its quality stays infinite if no model was found. Searches until a
    criterion ends the search, or so many samples have been drawn. @return false in the second case;
    the search goes on when it is called again. */
    bool run(int pause = INT_MAX);
    //! The threshold has changed: rates and optimizes the best model anew, and forgets what others
    //! were worth. If a check refuses it now, there is no best model until run() finds one.
    void thresholdChanged();
    //! The sample that led to State::best; null: it came from none.
    const int* bestSample() const { return sampled ? sampleOfBest.val : 0; }

private:
    bool terminate();
    //! Has the run to end at once? @param work since the question before, see Watch
    bool stop(double work) const { return context.watch && context.watch->stop(work); }
    bool stopped() const { return context.watch && context.watch->stopped(); }
    void drawBatch();
    //! @param index of the sample in the batch @param row memory for errors, see rate()
    void hypothesize(int index, Hypotheses& h, float* row) const;
    void hypothesizeBatch();
    void hypothesizePart(int first, int count);
    //! Memory for the hypotheses of so many samples, and so many rows of errors.
    void reserve(int wanted, int rows);
    //! Cost from which on the model of a sample is of no use.
    double uselessCost() const;
    void improve(const Candidate& candidate, const Quality& before);
    //! `sample`: where the model comes from; null: from none
    void setBest(const Model& model, const Quality& quality, const Sample* sample);
    void addRunnerUp(const Candidate& candidate);
    //! The search is about to end. @return false if it ends nevertheless
    bool lookBeside();
    void improveRunnersUp();
    bool worthOptimizing(const RunnerUp& runnerUp) const;
    /** Points within so many Context::inlierThreshold of the best model are explained by it: where
    the noise is as wide as the threshold, right matches are left beyond it, which are no rival's.
    1: a third more samples in all such scenes, instructions of H +4 %. */
    static constexpr double EXPLAINED = 1.5;
    //! Samples of the points that the best model leaves; see ransac_unexplained.cpp. @return false
    //! if there was none
    bool searchUnexplained();
    int unexplainedPoints(int* indices) const;
    //! Many only if there is a sign of a rival. @param drawn samples before this search
    void sampleForRivals(const int* indices, int count, double wanted, int drawn);
    void sampleUnexplained(const int* indices, int count, int most);
    //! So many inliers for itself has a rival of the best model, of those of InlierBits.
    double rivalInliers() const;
    //! @return false if it is none
    bool addRival(const Sample& sample, const Model& model);
    //! What the checks of degeneracy say.
    bool validSample(const int* sample) const;
    bool validModel(const int* sample, const Model& model) const;
    void optimize(Model& model, Quality& quality);
    bool recover(const int* sample, Model& model, Quality& quality);
    void account(const Hypotheses& hypotheses);
    void updateTermination();
    //! Lets the criteria look at what has been found. @return true if the number of samples may
    //! have changed
    bool adaptTerminations();
    int samplesThatCount() const;
    void require(double wanted, bool all, int reason);

    const Context& context;
    const Components& parts;
    State& state;
    const int m;                //!< points of a sample
    Degeneracy* const* checks;  //!< Components::degeneracies
    const int checkCount;       //!< of these
    Sample* samples;            //!< of the batch
    uchar* counts;              //!< State::counts of each
    Hypotheses* batch;          //!< theirs, or those of the present sample
    float* errorRows;  //!< one for each thread that rates models; null: the score wants none
    int size;          //!< of the batch
    int hypotheses;    //!< that there is room for
    RunnersUp runnersUp;
    Sample sampleOfBest;
    bool sampled;
    Model explored;          //!< the best model when what it leaves was searched
    int unexplainedSamples;  //!< of the points that a best model has left, so far
    int rivals;  //!< RunnersUp::mostUnexplained() when the runners-up were last optimized
    const int threads;
    const double sampleWork;  //!< of a sample and its models, at most, in tests of a point
    int firstOfBatch;         //!< number of its first sample
    const int exhaustive;
    //! Samples that count, and samples in all, after which the run can stop, and the criterion that
    //! says so.
    int required, requiredReason, requiredOfAll, reasonOfAll;
    double localTicks;
    const bool checkSamples;
};

}  // namespace usacv20
}  // namespace cv

#endif
