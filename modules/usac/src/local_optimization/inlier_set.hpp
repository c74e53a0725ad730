// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_INLIER_SET_HPP
#define OPENCV_USACV20_INLIER_SET_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief A set of points, from which the local optimizers of LO-RANSAC and GC-RANSAC select random
subsets and to which they fit models. */
class InlierSet
{
public:
    InlierSet() : members(0), count(0), errors(0) {}

    //! Takes memory for `points` points. Must be called before all other methods.
    void allocate(Arena::Scope& scope, int points)
    {
        members = scope.take<int>(points);
        errors = scope.take<float>(points);
        count = 0;
    }
    //! Sets the members to the points whose errors under the model are at most `multiple` times
    //! the threshold.
    void within(const Context& context, const Model& model, double multiple);
    //! Moves `most` random members, or all members if there are fewer, to the front of the array.
    //! @return number of members moved to the front
    int select(Rng& rng, int most);
    //! Fits `model` to the first `first` members by least squares, starting from its present value,
    //! in at most `iterations` steps.
    //! @return false if these members do not determine a model
    bool fit(const Context& context, int first, Model& model, int iterations = 10) const;
    //! Like fit(), but replaces `model` and `quality` only if the quality of the fit is better than
    //! `quality`. @return true if the model was replaced
    bool improve(const Context& context, int first, Model& model, Quality& quality,
                 int iterations = 10) const;

    int size() const { return count; }

    int* members;  //!< indices of the points in the set
    int count;     //!< number of members

private:
    float* errors;
};

//! Replaces the model with `candidate` if `candidate` has a better score. @return true if the model
//! was replaced
bool keepBetter(const Context& context, const Model& candidate, Model& model, Quality& quality);

}  // namespace usacv20
}  // namespace cv

#endif
