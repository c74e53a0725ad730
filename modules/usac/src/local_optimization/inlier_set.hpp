// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_INLIER_SET_HPP
#define OPENCV_USACV20_INLIER_SET_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief What the local optimizers share: a set of points, random parts of it, and fits that are
 kept if they are * better. */
class InlierSet
{
public:
    InlierSet() : members(0), count(0), errors(0) {}

    //! Memory for so many points, before anything else.
    void allocate(Arena::Scope& scope, int points)
    {
        members = scope.take<int>(points);
        errors = scope.take<float>(points);
        count = 0;
    }
    //! Takes the points with errors up to a multiple of the threshold.
    void within(const Context& context, const Model& model, double multiple);
    //! Brings `most` random members to the front, all if there are not as many. @return their
    //! number
    int select(Rng& rng, int most);
    //! Least squares over the `first` members from `model`; false if they determine none.
    bool fit(const Context& context, int first, Model& model, int iterations = 10) const;
    //! The same; the fit replaces the model if its quality is better.
    bool improve(const Context& context, int first, Model& model, Quality& quality,
                 int iterations = 10) const;

    int size() const { return count; }

    int* members;
    int count;  //!< of the members

private:
    float* errors;
};

//! Puts `candidate` in the place of a model that is worse.
bool keepBetter(const Context& context, const Model& candidate, Model& model, Quality& quality);

}  // namespace usacv20
}  // namespace cv

#endif
