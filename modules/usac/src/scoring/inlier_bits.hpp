// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_INLIER_BITS_HPP
#define OPENCV_USACV20_INLIER_BITS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Marks which of the first points are inliers of a model, one bit per point. The points are in
//! random order, so that the first ones represent all.
class InlierBits
{
public:
    //! Maximum number of points.
    enum { MOST = 256 };

    //! No inliers.
    InlierBits();
    //! @param width threshold of the inliers, in units of Context::inlierThreshold
    InlierBits(const Context& context, const Model& model, double width = 1);

    //! Number of inliers.
    int count() const;
    //! Number of inliers that are not in `others`.
    int without(const InlierBits& others) const;

private:
    enum { WORDS = MOST / 64 };

    uint64 words[WORDS];
};

}  // namespace usacv20
}  // namespace cv

#endif
