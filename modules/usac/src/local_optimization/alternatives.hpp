// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ALTERNATIVES_HPP
#define OPENCV_USACV20_ALTERNATIVES_HPP

#include "local_optimization/runners_up.hpp"

namespace cv {
namespace usacv20 {

//! A model that can be chosen instead of the best model, see Alternatives.
struct Alternative
{
    Candidate candidate;
    bool sampled;  //!< true: `candidate.sample` led to the model; false: there is no such sample
    InlierBits inliers;
    double gain;  //!< number of points (the cost if all points were outliers) minus the cost
};

/** @brief Optimized models whose cost is not much higher than that of the best model, but whose
inliers are partly different.

With repeated structure or planes, a wrong model can explain more matches than the right model, and
no search can recognize it as wrong by its cost. Two rankings of the matches can tell that it is
wrong, because the inliers of the right model have higher ranks:

- The order of the matches, if it is known, for example from their scores. Two descriptors of the
  other image are nearly equally close to the descriptor of a repeated corner, so that matches of
  repeated corners have bad scores.
- For F, the number of common neighbors, see commonNeighbors(). Wrong matches between repeated
  elements, such as the columns of a facade, lie on the epipolar lines of a wrong model, but they
  seldom have neighbors in common in the two images.

Therefore a model other than that of lowest cost is chosen on three conditions. Its gain is at least
94 % (order) or 60 % (neighbors) of the gain of the model of lowest cost. At least half of its
inliers are inliers of the model of lowest cost, too, but the two models do not have nearly the same
inliers. And the log-likelihood of a ranking (orderLogLikelihood()) is higher with its inliers than
with those of the model of lowest cost, by more than the difference of the gains plus the effect of
chance. Misleading scores can do little harm, because they decide only if the gains are nearly
equal. */
class Alternatives
{
public:
    //! @param active false: no models are stored, because the run has no runners-up (RunnersUp), or
    //! the cost is not a sum over the points. No models are stored either if neither of the two
    //! rankings is available.
    Alternatives(bool active, const Context& context);

    bool active() const { return kept != 0; }
    //! Stores the model if its gain is high enough and if no stored model with at least this gain
    //! has nearly the same inliers. To be called only if active(). @param sampled see Alternative
    void offer(const Context& context, const Candidate& candidate, bool sampled);
    //! False if there are fewer than two models, so that chosen() returns null.
    bool contested() const { return count > 1; }
    //! The model to choose instead of the model of lowest cost; null: there is no such model.
    //! @param order the points, best point first; null: the order is not known
    //! @param common commonNeighbors() of the first #MATCHES_COMPARED points; null: not used for
    //! this problem, see hasCommonNeighbors()
    const Alternative* chosen(const Context& context, const int* order, const uchar* common) const;
    //! Forgets all models.
    void clear() { count = 0; }

private:
    enum { MOST = 16 };  //!< maximum number of models that are stored

    Alternative* kept;  //!< stored models, by descending gain; null: inactive
    int count;          //!< number of stored models
    double least;       //!< a stored model has at least this fraction of the largest gain
};

}  // namespace usacv20
}  // namespace cv

#endif
