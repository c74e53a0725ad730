// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_INLIER_SET_HPP
#define OPENCV_USACV20_INLIER_SET_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief What the local optimizers share: a set of points, random parts of it, and fits that are kept if they are
 * better. */
class InlierSet
{
public:
    //! Takes the points with errors up to a multiple of the threshold.
    void within(const Context& context, const Model& model, double multiple);
    //! Brings `count` random members to the front, all if there are not as many. @return their number
    int select(Rng& rng, int count);
    //! Least squares over the first `count` members from `model`; false if they determine none.
    bool fit(const Context& context, int count, Model& model, int iterations = 10) const;
    //! The same; the fit replaces the model if its quality is better.
    bool improve(const Context& context, int count, Model& model, Quality& quality, int iterations = 10) const;

    int size() const { return (int)members.size(); }

    std::vector<int> members;

private:
    std::vector<float> errors;
};

//! Puts `candidate` in the place of a model that is worse.
bool keepBetter(const Context& context, const Model& candidate, Model& model, Quality& quality);

}  // namespace usacv20
}  // namespace cv

#endif
