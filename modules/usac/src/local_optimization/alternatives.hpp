// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ALTERNATIVES_HPP
#define OPENCV_USACV20_ALTERNATIVES_HPP

#include "local_optimization/runners_up.hpp"

namespace cv {
namespace usacv20 {

//! A model after local optimization.
struct Alternative
{
    Candidate candidate;
    bool sampled;  //!< the model comes from a sample
    InlierBits inliers;
    double gain;  //!< number of points, which is the cost without any model, minus the cost
};

/** @brief Optimized models whose cost is hardly higher than that of the best model, but whose
inliers are partly different.

With repeated structure or planes, a wrong model may explain a few more matches than the right
model, and no search can tell this by the cost. But if the order of the matches is known, the
inliers of the right model come earlier in the order, because the descriptor of a repeated corner
has a second neighbor that is nearly as close. Therefore another model than that of lowest cost is
chosen on three conditions: its gain is nearly as large; the two models share inliers; the order is
more likely with the inliers of the other model (orderLogLikelihood()) by more than the difference
of the gains and by more than chance. As the gains are nearly equal, misleading scores can do little
harm. */
class Alternatives
{
public:
    //! @param active false: no models are stored, because the order is not known or because the
    //! cost is not a sum over the points
    //! @param arena memory of the run
    Alternatives(bool active, Arena& arena);

    bool active() const { return kept != 0; }
    //! Stores the model if it is one of those described above. To be called only if active().
    void offer(const Context& context, const Candidate& candidate, bool sampled);
    //! False if chosen() returns null whatever the order is.
    bool contested() const { return count > 1; }
    //! The model to choose instead of that of lowest cost; null: there is no such model.
    //! @param order the points, best point first
    const Alternative* chosen(const Context& context, const int* order) const;
    //! Forgets all models.
    void clear() { count = 0; }

private:
    enum { MOST = 8 };  //!< maximum number of models that are stored

    //! orderLogLikelihood() of all points, extrapolated from the first #LOOKED of them, which are a
    //! random subset.
    double orderOf(const Context& context, const Model& model, const int* order) const;

    Alternative* kept;  //!< stored models, by descending gain; null: inactive
    int count;          //!< number of stored models
};

}  // namespace usacv20
}  // namespace cv

#endif
