// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CHECKS_HPP
#define OPENCV_USACV20_CHECKS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! All degeneracy checks of a run (Components::degeneracies), called like one check.
class Checks
{
public:
    Checks(const Context& context, State& state);

    //! Moves the samples that all checks accept to the front of `samples`, in unchanged order.
    //! @param samples, sampleCount samples and their number, at most MinimalSolver::MAX_TOGETHER
    //! @return number of accepted samples
    int acceptSamples(const int** samples, int sampleCount) const;
    //! True if all checks accept the model of the sample.
    bool validModel(const int* sample, const Model& model) const;
    //! True if the points of a rejected sample might nevertheless all be inliers, because the
    //! sample contains a match twice.
    bool mayBeGood(const int* sample) const;
    /** Lines 14 to 17, and 20 and 21, of Algorithm 1: each check can replace a degenerate model,
    and then lowers the score of a model with dependent inliers.
    @param sample the sample that led to the model; null: the model does not come from a sample
    @return false if a check rejects the model */
    bool recover(const int* sample, Model& model, Quality& quality) const;
    //! The score `rated` of a model, lowered by the checks if inliers of the model are dependent.
    Quality discounted(const Model& model, const Quality& rated) const;
    //! Computes State::successProbability for a new best model; 1 without #TERMINATION_EXACT.
    void updateSuccessProbability(const Model& model) const;
    //! To be called when the threshold has changed.
    void thresholdChanged() const;

private:
    const Context& context;
    State& state;
    Degeneracy* const* const checks;
    const int count;  //!< number of `checks`
};

}  // namespace usacv20
}  // namespace cv

#endif
