// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RIVAL_SEARCH_HPP
#define OPENCV_USACV20_RIVAL_SEARCH_HPP

#include "loop/sample_batch.hpp"
#include "loop/stopping.hpp"

namespace cv {
namespace usacv20 {

/** @brief Draws samples of the points that the best model does not explain, when the search is
about to end.

Wrong matches can be consistent with each other: matches of repeated windows have a common shift, a
moving object has its own motion. Their model can have enough inliers to end the search before the
model of the correct matches is found. Finding the model of the correct matches takes a good sample,
and many all-inlier samples are not good: with noise, half of the all-inlier samples for H and most
of those for F and E yield models that SPRT rejects. But if two models share few of their inliers,
the points that one model does not explain are mostly inliers of the other model, and samples of
these points are all-inlier samples far more often. For example, suppose that 45 % of the points are
inliers of a first model and another 35 % are inliers of a second model. Then (45 / 65)^7 = 8 % of
the samples of seven points that the second model does not explain are all-inlier samples of the
first model, instead of (45 / 100)^7 = 0.4 % of the samples of all points.

For each best model, a few such samples are drawn if there are enough points for a rival. There
might be a rival, a second model with about as many inliers as the best model, if the model of such
a sample, or a runner-up, has many inliers that the best model does not explain: at least the
fraction RIVAL of the number of inliers of the best model. Then more such samples are drawn: as many
as are needed to find, with the required confidence, a model that has as many inliers as the best
model and shares at most a third of them with it; but at most a third of the number of other samples
drawn so far. If ConfirmedOrderTermination is about to end the search, a group of wrong matches
might come first in the order of the points; that criterion then sets the minimum number of these
samples (State::unexplainedSamples). All these samples count as iterations, but not for
State::countedSamples. */
class RivalSearch
{
public:
    //! The object keeps references to all arguments.
    RivalSearch(const Context& context, State& state, const Checks& checks,
                const SampleBatch& batch, RunnersUp& runnersUp, const Stopping& stopping);

    /** Draws the samples and stores rivals as runners-up. Each best model is processed once.
    @param ending StopReason of the criterion that is about to end the search
    @return false if there was nothing to search, so that no samples were drawn */
    bool search(int ending);
    //! A rival has at least this many inliers that the best model does not explain. Only the points
    //! of InlierBits are counted.
    double rivalInliers() const;
    //! Forgets which best model was processed.
    void clear() { explored = Model(); }

private:
    int unexplainedPoints(int* indices) const;
    //! Draws a few samples of unexplained points, and more of them only if there is evidence of a
    //! rival (a second model that explains other points).
    //! @param drawn number of samples drawn before search()
    void sampleForRivals(const int* indices, int count, double wanted, int drawn);
    void sampleUnexplained(const int* indices, int count, int most);
    //! @param index State::iteration of the sample
    Sample drawUnexplained(const int* indices, int count, int index) const;
    //! Stores the model as a runner-up if it is a rival and if more than m of its inliers are not
    //! explained by the best model (m is the sample size). @return false if one of these conditions
    //! does not hold
    bool addRival(const Sample& sample, const Model& model);

    const Context& context;
    State& state;
    const Checks& checks;
    const SampleBatch& batch;
    RunnersUp& runnersUp;
    const Stopping& stopping;
    const int m;             //!< sample size
    Model explored;          //!< the last best model that search() processed
    int unexplainedSamples;  //!< number of samples of unexplained points so far
};

}  // namespace usacv20
}  // namespace cv

#endif
