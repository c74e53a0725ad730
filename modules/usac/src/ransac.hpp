// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RANSAC_HPP
#define OPENCV_USACV20_RANSAC_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! A sample and those of its models that beat the best model known when they were computed (lines 3 to 14).
struct Hypotheses
{
    int sample[MAX_SAMPLE_SIZE];
    int count;
    Model models[MAX_MODELS];
    Quality qualities[MAX_MODELS];
    bool rejectedSample;                   //!< by a check
    int computed, rejected, refused, dropped;  //!< models, for the report
    int firstInliers, firstTested;         //!< of their first blocks, for the verifier
};

/** @brief Algorithm 1 of @cite ivashechkin2021usacv20.

Samples are drawn in batches. Their models are computed and rated one after the other, or by several threads, and in
either case looked at in the order of the samples. What decides (samples, verification, the best model at the time of the
look) is the same in both cases, so the number of threads does not change a bit of the result. */
class Ransac
{
public:
    Ransac(const Context& context, State& state);

    //! Fills State::best; its quality stays infinite if no model was found.
    void run();
    //! Probability that a point agrees with a wrong model: the mean over the first blocks of all models.
    double randomInlierRatio() const;

private:
    bool terminate();
    void drawBatch();
    //! @param position number of the sample
    void hypothesise(int index, int position);
    void hypothesiseBatch();
    void improve(const int* sample, Model model, Quality quality);
    void optimize(Model& model, Quality& quality);
    bool isKnown(const Model& model);
    bool recover(const int* sample, Model& model, Quality& quality);
    void account(const Hypotheses& hypotheses);
    void updateTermination();

    const Context& context;
    const Components& parts;
    State& state;
    std::vector<Hypotheses> batch;
    std::vector<float> errors, bestErrors;
    const int threads;
    int required, requiredReason;
    int confirmations;  //!< local optimisations that led to the best model again
    double localTicks;
    double firstInliers, firstTested;
};

} // namespace usacv20
} // namespace cv

#endif
