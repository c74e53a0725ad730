// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLE_BATCH_HPP
#define OPENCV_USACV20_SAMPLE_BATCH_HPP

#include "local_optimization/runners_up.hpp"
#include "loop/checks.hpp"

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

/** @brief A batch of samples with their models: lines 3 to 13 of Algorithm 1.

The models are computed and scored by several threads in draw(), or one sample after the other in
hypotheses(). They are the same in both cases. */
class SampleBatch
{
public:
    //! @param checks, runnersUp are used for each model; the object keeps references
    //! @param checkSamples true: samples are checked for valid indices, because the caller has
    //! replaced the sampler
    SampleBatch(const Context& context, State& state, const Checks& checks,
                const RunnersUp& runnersUp, bool checkSamples);

    //! True if no batch has been drawn yet.
    bool begins() const { return drawn == 0; }
    //! Draws the samples of the next batch. Batches grow, so that easy problems draw few
    //! superfluous samples and hard problems use all threads.
    void draw();
    //! Number of samples in the batch.
    int size() const { return drawn; }
    const Sample& sample(int index) const { return samples[index]; }
    //! State::counts of a sample.
    bool counts(int index) const { return counted[index] != 0; }
    //! The models of a sample. To be called for the samples 0, 1, ... in this order; the result is
    //! valid until the next call.
    const Hypotheses& hypotheses(int index);

    //! Number of samples that are solved at once.
    int ahead() const { return together; }
    //! Computes the models of `count` samples, at most ahead(), and writes them to `h` (lines 4
    //! to 6).
    void solve(const Sample* drawn, int count, Hypotheses* h) const;

private:
    //! Checks and scores the models in `h` (lines 7 to 13). @param index index of the sample
    //! @param row memory for errors, see rate()
    void score(int index, Hypotheses& h, float* row) const;
    //! Computes and scores the models of all samples, in several threads.
    void hypothesizeAll();
    void hypothesizePart(int begin, int count);
    //! Allocates memory for the hypotheses of `wanted` samples and, if the score needs all errors
    //! of a model at once, for `rows` rows of errors.
    void reserve(int wanted, int rows);

    const Context& context;
    State& state;
    const Checks& checks;
    const RunnersUp& runnersUp;
    const bool checkSamples;
    const int together;  //!< see ahead()
    const int threads;
    Sample* samples;
    uchar* counted;      //!< see counts()
    Hypotheses* solved;  //!< models of all samples if `parallel`, else of ahead() samples
    float* errorRows;    //!< a row of errors per thread; null: the score does not need them
    int reserved;        //!< number of elements allocated for `solved`
    int drawn;           //!< number of samples
    int first;           //!< State::iteration of the first sample
    bool parallel;       //!< draw() has computed and scored the models
};

}  // namespace usacv20
}  // namespace cv

#endif
