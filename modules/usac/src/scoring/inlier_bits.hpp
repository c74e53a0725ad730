// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_INLIER_BITS_HPP
#define OPENCV_USACV20_INLIER_BITS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Which of the first points are inliers of a model, a bit each: the points are in random order, so
//! that these stand for all.
class InlierBits
{
public:
    //! Most points. 512: search failures the same within their noise.
    enum { MOST = 256 };

    //! None.
    InlierBits();
    //! @param width in units of Context::inlierThreshold
    InlierBits(const Context& context, const Model& model, double width = 1);

    int count() const;
    //! Those that are not among `others`.
    int without(const InlierBits& others) const;

private:
    enum { WORDS = MOST / 64 };

    uint64 words[WORDS];
};

}  // namespace usacv20
}  // namespace cv

#endif
