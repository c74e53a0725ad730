// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SEEN_POINTS_HPP
#define OPENCV_USACV20_SEEN_POINTS_HPP

#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

//! What the points of an image, given on the normalized image plane, say about the camera matrix.
//! NaN is allowed.
struct SeenPoints
{
    SeenPoints(const double* x, const double* y, int count);

    //! True if most points are more than 80 degrees off the optical axis, as with a camera matrix
    //! that is the identity or inverted.
    bool aside;
    //! The corner (1 to 4) of the box of all points at which the principal point is, within a tenth
    //! of the sides of the box; 0: none. Such is the camera matrix of an image twice as large, or
    //! with a principal point of (0, 0).
    int corner;

    static const char* const ASIDE;  //!< the text of a warning that `aside` is true
};

}  // namespace usacv20
}  // namespace cv

#endif
