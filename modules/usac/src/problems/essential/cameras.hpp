// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CAMERAS_HPP
#define OPENCV_USACV20_CAMERAS_HPP

#include "problems/distortion.hpp"

namespace cv {
namespace usacv20 {

//! The cameras of two views, with distortion.
class Cameras
{
public:
    /** Raises cv::Exception if the arguments are no cameras.
    @param cameraMatrix1, cameraMatrix2 3x3, any depth; the second one empty: as the first
    @param distCoeffs1, distCoeffs2 4, 5, 8, 12 or 14 coefficients as for cv::undistortPoints;
    empty: none */
    Cameras(InputArray cameraMatrix1, InputArray cameraMatrix2, InputArray distCoeffs1,
            InputArray distCoeffs2);

    //! From pixels to the normalized image plane, in place; NaN where the lens images nothing.
    //! @return mean focal length in pixels
    double toImagePlane(double* const* columns, int count) const;

private:
    Matx33d K1, K2;
    Distortion distortion1, distortion2;
};

}  // namespace usacv20
}  // namespace cv

#endif
