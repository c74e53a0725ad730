// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ALTERNATIVES_HPP
#define OPENCV_USACV20_ALTERNATIVES_HPP

#include "local_optimization/runners_up.hpp"

namespace cv {
namespace usacv20 {

//! An optimized model.
struct Alternative
{
    Candidate candidate;
    bool sampled;  //!< the model comes from a sample
    InlierBits inliers;
    double gain;  //!< reduction of the cost relative to no model at all
};

/** @brief Optimized models that cost hardly more than the best one, but have partly other inliers.

With repeated structure or planes, a wrong model may explain a few more matches than the right one,
and no search can tell by the cost. But if the order of the matches is known, the inliers of the
right model come earlier in it: the descriptor of a repeated corner has a second neighbor that is
nearly as close. So another model than the one of lowest cost is chosen if its gain is nearly as
large, they share inliers, and the order is more likely with its inliers (orderLogLikelihood()) by
more than what it loses in gain and by more than chance. As the gains are nearly equal, misleading
scores can do little harm. */
class Alternatives
{
public:
    //! @param active false: keep none, as the order is not known, or the cost is no sum over points
    Alternatives(bool active, Arena& arena);

    bool active() const { return kept != 0; }
    //! Keeps the model if it is one of those defined above; only if active().
    void offer(const Context& context, const Candidate& candidate, bool sampled);
    //! False if chosen() returns null for any order.
    bool contested() const { return count > 1; }
    //! The model to choose instead of the one of lowest cost; null: none.
    //! @param order the points, best first
    const Alternative* chosen(const Context& context, const int* order) const;
    //! Forgets all models.
    void clear() { count = 0; }

private:
    enum { MOST = 8 };  //!< maximum number of models that are kept

    //! orderLogLikelihood() of all points; computed from the first #LOOKED of them, which are a
    //! random sample.
    double orderOf(const Context& context, const Model& model, const int* order) const;

    Alternative* kept;  //!< by descending gain; null: inactive
    int count;          //!< number of models kept
};

}  // namespace usacv20
}  // namespace cv

#endif
